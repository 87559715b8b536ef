// SPDX-License-Identifier: LGPL-3.0-or-later
#include "fault_harness.h"

#include <corral/polynomial/substitution.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <vector>

namespace corral::audit {
namespace {

using Exact = Rational_interval;

/// \brief What goes into the remainder of a Taylor form. A fault derives from this and leaves something out. The
/// control: nothing may be caught.
struct Sound_remainder
{
  static constexpr std::string_view name = "no_fault_taylor_form";
  static constexpr std::string_view description = "one step of the fast engine as it is";
  static constexpr bool keeps_rounding_of_root = true;
  static constexpr bool keeps_rounding_of_child = true;
  static constexpr bool keeps_dropped_terms = true;
  static constexpr bool exact_by_own_quantum = true;
};

/// The largest power of two of which all numbers are multiples; 0 if one of them is no dyadic number.
class Quantum
{
public:
  void take(const Rational& c)
  {
    if (c == 0) return;
    const mp_bitcnt_t below = mpz_scan1(c.get_den_mpz_t(), 0);
    if (Integer(c.get_den() >> below) != 1) is_known_ = false;
    const auto exponent = static_cast<long>(mpz_scan1(c.get_num_mpz_t(), 0)) - static_cast<long>(below);
    exponent_ = std::min(exponent_, exponent);
  }
  [[nodiscard]] Rational value() const
  {
    if (!is_known_ || exponent_ == largest) return 0;
    const Integer power = Integer(1) << static_cast<mp_bitcnt_t>(std::labs(exponent_));
    return exponent_ < 0 ? Rational(1, power) : Rational(power);
  }

private:
  static constexpr long largest = std::numeric_limits<long>::max();
  bool is_known_ = true;
  long exponent_ = largest;
};

/// \brief The form of doc/taylor_form.md: doubles as coefficients in coordinates of [-1, 1]^2 of a box, and a remainder
/// for every error so far; here the errors are summed exactly.
template <class Remainder>
class Taylor_form
{
public:
  /// The root form of f on the box that is twice as large along x and has `box` as its lower half.
  Taylor_form(const Exact_polynomial& f, const Exact_box& box)
  {
    std::array<Rational, 2> centre;
    std::array<Rational, 2> radius;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      radius[axis] = (box[axis].upper() - box[axis].lower()) / 2;
      centre[axis] = box[axis].lower() + radius[axis];
    }
    centre[0] += radius[0];
    radius[0] *= 2;
    const auto g = affine_substitution(f, centre, radius);
    size_ = {g.degree(0) + std::size_t{1}, g.degree(1) + std::size_t{1}};
    coefficients_.resize(size_[0] * size_[1]);
    for (const auto& [k, c] : g.terms())
      while (abs(c) > scale_) scale_ *= Integer(1) << 64;
    Quantum quantum;
    for (const auto& [k, c] : g.terms()) {
      double& rounded = at(k[0], k[1]);
      rounded = Rational(c / scale_).get_d();
      if (Remainder::keeps_rounding_of_root) remainder_ += abs(c / scale_ - Rational(rounded));
      if (Remainder::exact_by_own_quantum) quantum.take(Rational(rounded));
    }
    if (!Remainder::exact_by_own_quantum)
      for (const auto& term : f.terms()) quantum.take(term.coefficient / scale_);
    quantum_ = quantum.value();
  }

  /// \brief Goes to the lower half along x: u = (w - 1) / 2, by a scaling and Horner's triangle.
  ///
  /// What an error of the coefficient of w^k does to the coefficients below adds up to less than 2^k times the error.
  void take_lower_half()
  {
    Rational norm;
    for (const double c : coefficients_) norm += abs(Rational(c));
    quantum_ /= Integer(1) << (size_[0] - 1);
    const bool is_normal = quantum_ * (Integer(1) << 1000) >= 1; // below, numbers of the form may be subnormal
    counts_as_exact_ = is_normal && norm <= quantum_ * (Integer(1) << 52);
    for (std::size_t j = 0; j < size_[1]; ++j) {
      for (std::size_t k = 0; k < size_[0]; ++k) set(k, j, Rational(at(k, j)) / (Integer(1) << k));
      for (std::size_t low = 0; low + 1 < size_[0]; ++low)
        for (std::size_t k = size_[0] - 1; k-- > low;) set(k, j, Rational(at(k, j)) - Rational(at(k + 1, j)));
    }
  }

  /// Cuts off the terms that are small beside the sum of all.
  void drop_small_terms()
  {
    double sum = 0;
    for (const double c : coefficients_) sum += std::fabs(c);
    for (std::size_t i = 1; i < coefficients_.size(); ++i) {
      if (std::fabs(coefficients_[i]) > sum * 0x1p-8) continue;
      if (Remainder::keeps_dropped_terms) remainder_ += abs(Rational(coefficients_[i]));
      coefficients_[i] = 0;
    }
  }

  [[nodiscard]] Exact bound()
  {
    Exact sum(Rational(-remainder_), remainder_);
    for (std::size_t k = 0; k < size_[0]; ++k)
      for (std::size_t j = 0; j < size_[1]; ++j) {
        const Exact c{Rational(at(k, j))};
        sum += k + j == 0 ? c : c * (k % 2 == 0 && j % 2 == 0 ? Exact(0, 1) : Exact(-1, 1));
      }
    return sum * Exact(scale_);
  }

private:
  double& at(std::size_t k, std::size_t j) { return coefficients_[k * size_[1] + j]; }

  void set(std::size_t k, std::size_t j, const Rational& exact)
  {
    at(k, j) = exact.get_d();
    if (Remainder::keeps_rounding_of_child && !counts_as_exact_)
      remainder_ += abs(exact - Rational(at(k, j))) * (Integer(1) << k);
  }

  std::array<std::size_t, 2> size_{};
  std::vector<double> coefficients_;
  Rational scale_ = 1; // of all coefficients: none exceeds 1
  Rational remainder_;
  Rational quantum_;             // a power of two of which all coefficients are multiples; 0: none is known
  bool counts_as_exact_ = false; // whether the halving is taken to round nothing
};

template <class Remainder>
struct Taylor_form_bounder
{
  static constexpr std::string_view name = Remainder::name;
  static constexpr std::string_view description = Remainder::description;
  explicit Taylor_form_bounder(const Exact_polynomial& given) : f(given) {}
  [[nodiscard]] Exact bound(const Exact_box& box) const
  {
    Taylor_form<Remainder> form(f, box);
    form.take_lower_half();
    form.drop_small_terms();
    return form.bound();
  }
  Exact_polynomial f;
};

struct Rounding_of_the_root_lost : Sound_remainder
{
  static constexpr std::string_view name = "taylor_form_root_rounding_lost";
  static constexpr std::string_view description = "the root form is rounded to doubles and its remainder left out";
  static constexpr bool keeps_rounding_of_root = false;
};

struct Rounding_of_the_child_lost : Sound_remainder
{
  static constexpr std::string_view name = "taylor_form_child_rounding_lost";
  static constexpr std::string_view description = "the additions of a halving are rounded and their remainder left out";
  static constexpr bool keeps_rounding_of_child = false;
};

struct Dropped_terms_lost : Sound_remainder
{
  static constexpr std::string_view name = "taylor_form_dropped_terms_lost";
  static constexpr std::string_view description = "small terms are dropped and do not go into the remainder";
  static constexpr bool keeps_dropped_terms = false;
};

struct Rounding_counted_as_exact : Sound_remainder
{
  static constexpr std::string_view name = "taylor_form_rounding_counted_as_exact";
  static constexpr std::string_view description =
      "the quantum of the polynomial decides which halvings round nothing, and not that of its form";
  static constexpr bool exact_by_own_quantum = false;
};

} // namespace

std::vector<Planted_bounder> taylor_form_faults()
{
  return {planted<Taylor_form_bounder<Rounding_of_the_root_lost>>(),
          planted<Taylor_form_bounder<Rounding_of_the_child_lost>>(),
          planted<Taylor_form_bounder<Dropped_terms_lost>>(),
          planted<Taylor_form_bounder<Rounding_counted_as_exact>>()};
}

std::vector<Planted_bounder> sound_taylor_forms() { return {planted<Taylor_form_bounder<Sound_remainder>>()}; }

} // namespace corral::audit
