// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/errors.h>
#include <corral/number/all.h>

#include <gtest/gtest.h>

#include <cfenv>
#include <stdexcept>
#include <string>
#if defined __x86_64__
#include <xmmintrin.h>
#endif

namespace {

using namespace corral;

/// The direction in which sums are really rounded; `fegetround` may look at a unit that computes nothing.
int rounding_of_sums()
{
  volatile double one = 1;
  volatile double tiny = 0x1p-60;
  volatile double sum = one + tiny;
  volatile double difference = one - tiny;
  volatile double negative_sum = -one - tiny;
  if (sum > one) return FE_UPWARD;
  if (negative_sum < -one) return FE_DOWNWARD;
  return difference < one ? FE_TOWARDZERO : FE_TONEAREST;
}

/// The message with which the guard of `I` refuses to begin, or "" if it does not.
template <class I>
std::string refusal()
{
  try {
    const Arithmetic_scope<I> scope;
  } catch (const Unsafe_environment& error) {
    return error.what();
  }
  return "";
}

/// Sets a rounding mode and restores it to nearest.
class Rounding_mode
{
public:
  explicit Rounding_mode(int mode) { std::fesetround(mode); }
  ~Rounding_mode() { std::fesetround(FE_TONEAREST); }
};

TEST(Environment, is_accepted_as_it_is)
{
  EXPECT_EQ(find_environment_fault(), Environment_fault::none);
  EXPECT_EQ(refusal<Outward_interval>(), "");
  EXPECT_EQ(refusal<Cgal_interval>(), "");
}

TEST(Environment, refuses_other_rounding_modes)
{
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const Rounding_mode rounding(mode);
    EXPECT_NE(refusal<Outward_interval>().find("rounding mode"), std::string::npos) << mode;
    EXPECT_NE(refusal<Counted<Nearest_interval>>().find("rounding mode"), std::string::npos) << mode;
    EXPECT_EQ(refusal<Cgal_interval>(), "") << mode; // it sets its own
    EXPECT_EQ(rounding_of_sums(), mode);
  }
}

TEST(Environment, restores_the_rounding_mode_around_exceptions)
{
  try {
    const Arithmetic_scope<Cgal_interval> scope;
    EXPECT_EQ(rounding_of_sums(), FE_UPWARD);
    EXPECT_NE(refusal<Outward_interval>(), ""); // doubles that need rounding to nearest notice
    {
      const Arithmetic_scope<Cgal_interval> inner;
    }
    EXPECT_EQ(rounding_of_sums(), FE_UPWARD);
    throw std::runtime_error("in the middle of a computation");
  } catch (const std::runtime_error&) {
  }
  EXPECT_EQ(rounding_of_sums(), FE_TONEAREST);
}

#if defined __x86_64__
/// Sets bits of the control register of SSE and restores them.
class Control_bits
{
public:
  explicit Control_bits(unsigned bits) : before_(_mm_getcsr()) { _mm_setcsr(before_ | bits); }
  ~Control_bits() { _mm_setcsr(before_); }

private:
  unsigned before_;
};

TEST(Environment, refuses_to_lose_subnormals)
{
  for (const auto& [bits, words] : {std::pair(0x8000U, "flush-to-zero"), std::pair(0x0040U, "denormals-are-zero")}) {
    std::string of_outward;
    std::string of_cgal;
    {
      const Control_bits control(bits);
      of_outward = refusal<Outward_interval>();
      of_cgal = refusal<Cgal_interval>();
      EXPECT_EQ(rounding_of_sums(), FE_TONEAREST); // also where the guard of CGAL's intervals refuses
    }
    EXPECT_NE(of_outward.find(words), std::string::npos) << of_outward;
    EXPECT_NE(of_cgal.find(words), std::string::npos) << of_cgal;
    EXPECT_EQ(of_outward.find('\n'), std::string::npos);
  }
  EXPECT_EQ(refusal<Outward_interval>(), "");
}
#endif

} // namespace
