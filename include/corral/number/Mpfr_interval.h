// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_MPFR_INTERVAL_H
#define CORRAL_NUMBER_MPFR_INTERVAL_H

#include <corral/number/Interval_number.h>

#include <mpfi.h>

#include <algorithm>
#include <type_traits>
#include <utility>

namespace corral {

/// \brief Sets the precision of the `Mpfr_interval`s that this thread makes while it lives.
class Mpfr_precision_scope
{
public:
  static constexpr long least = 53;
  static constexpr long greatest = 1L << 20;

  /// \param bits  the length of the mantissa of both end points.
  /// \throw Invalid_input unless least <= bits <= greatest.
  explicit Mpfr_precision_scope(long bits);
  ~Mpfr_precision_scope() { current() = outer_; }
  Mpfr_precision_scope(const Mpfr_precision_scope&) = delete;
  Mpfr_precision_scope& operator=(const Mpfr_precision_scope&) = delete;

  /// The precision of this thread; 128 bits where no scope lives.
  [[nodiscard]] static long bits() { return current(); }

private:
  static long& current()
  {
    static thread_local long bits = 128;
    return bits;
  }
  long outer_;
};

/// \brief Gives MPFR its default range of exponents, which a program may have narrowed, and restores what it found.
class Mpfr_range_scope
{
public:
  Mpfr_range_scope();
  ~Mpfr_range_scope();
  Mpfr_range_scope(const Mpfr_range_scope&) = delete;
  Mpfr_range_scope& operator=(const Mpfr_range_scope&) = delete;

  /// Whether the thread's range of exponents is at least the default one.
  [[nodiscard]] static bool is_in_force()
  {
    return mpfr_get_emin() <= MPFR_EMIN_DEFAULT && mpfr_get_emax() >= MPFR_EMAX_DEFAULT;
  }

private:
  mpfr_exp_t least_;
  mpfr_exp_t greatest_;
};

/// \brief Model of `IntervalNumber`: MPFI, of any precision from 53 bits.
///
/// A number made from a built-in one or by `enclose` has the precision of the thread (`Mpfr_precision_scope`), the
/// result of an operation the greater precision of its operands. Thus threads agree on what they compute from shared
/// numbers. \par Reference  Revol, Rouillier, "Motivations for an arbitrary precision interval arithmetic and the MPFI
///      library", 2005.
class Mpfr_interval
{
public:
  Mpfr_interval() : Mpfr_interval(0) {}
  template <UnfitNumber T>
  Mpfr_interval(T value) = delete;
  /// The tightest interval around a built-in number.
  template <MachineNumber T>
  Mpfr_interval(T value) : Mpfr_interval(Bits{Mpfr_precision_scope::bits()})
  {
    if constexpr (std::is_floating_point_v<T>)
      set(static_cast<double>(value));
    else if constexpr (sizeof(T) > sizeof(long))
      mpfi_set_q(value_, exact_value(value).get_mpq_t());
    else if constexpr (std::is_signed_v<T>)
      mpfi_set_si(value_, value);
    else
      mpfi_set_ui(value_, value);
  }
  explicit Mpfr_interval(const Rational& value) : Mpfr_interval(Bits{Mpfr_precision_scope::bits()})
  {
    mpfi_set_q(value_, value.get_mpq_t());
  }
  Mpfr_interval(const Mpfr_interval& other) : Mpfr_interval(Bits{other.precision()}) { mpfi_set(value_, other.value_); }
  Mpfr_interval(Mpfr_interval&& other) noexcept : Mpfr_interval(Bits{MPFR_PREC_MIN})
  {
    mpfi_swap(value_, other.value_);
  }
  Mpfr_interval& operator=(const Mpfr_interval& other)
  {
    if (precision() != other.precision()) mpfi_set_prec(value_, other.precision());
    mpfi_set(value_, other.value_);
    return *this;
  }
  Mpfr_interval& operator=(Mpfr_interval&& other) noexcept
  {
    mpfi_swap(value_, other.value_);
    return *this;
  }
  ~Mpfr_interval() { mpfi_clear(value_); }

  /// The length of the mantissas in bits.
  [[nodiscard]] long precision() const { return mpfi_get_prec(value_); }
  [[nodiscard]] mpfi_srcptr value() const { return value_; }
  [[nodiscard]] mpfr_srcptr lower() const { return &value_->left; }
  [[nodiscard]] mpfr_srcptr upper() const { return &value_->right; }

  Mpfr_interval& operator+=(const Mpfr_interval& b) { return assign<mpfi_add>(b); }
  Mpfr_interval& operator-=(const Mpfr_interval& b) { return assign<mpfi_sub>(b); }
  Mpfr_interval& operator*=(const Mpfr_interval& b) { return assign<mpfi_mul>(b); }
  friend Mpfr_interval operator-(const Mpfr_interval& a) { return apply<mpfi_neg>(a); }
  friend Mpfr_interval operator+(const Mpfr_interval& a, const Mpfr_interval& b) { return apply<mpfi_add>(a, b); }
  friend Mpfr_interval operator-(const Mpfr_interval& a, const Mpfr_interval& b) { return apply<mpfi_sub>(a, b); }
  friend Mpfr_interval operator*(const Mpfr_interval& a, const Mpfr_interval& b) { return apply<mpfi_mul>(a, b); }
  friend Mpfr_interval square(const Mpfr_interval& a) { return apply<mpfi_sqr>(a); }

private:
  friend struct Interval_traits<Mpfr_interval>;
  struct Bits
  {
    long count;
  };

  explicit Mpfr_interval(Bits bits) { mpfi_init2(value_, bits.count); }
  void set(double value);
  static void check_range()
  {
    CORRAL_PRECONDITION(Mpfr_range_scope::is_in_force(),
                        "mpfr: arithmetic with a narrowed range of exponents; expected an "
                        "Arithmetic_scope<Mpfr_interval> on this thread");
  }

  /// The result of a function of MPFI in the greatest precision of its operands.
  template <auto function, class... Operand>
  static Mpfr_interval apply(const Operand&... operands)
  {
    check_range();
    Mpfr_interval result(Bits{std::max({operands.precision()...})});
    function(result.value_, operands.value_...);
    return result;
  }

  template <auto function>
  Mpfr_interval& assign(const Mpfr_interval& b)
  {
    if (precision() < b.precision()) return *this = apply<function>(*this, b);
    check_range();
    function(value_, value_, b.value_);
    return *this;
  }

  mpfi_t value_;
};

template <>
struct Interval_traits<Mpfr_interval>
{
  static constexpr std::string_view name = "mpfr";
  static constexpr bool is_guaranteed = true;
  static constexpr bool is_exact = false;
  using Scope = Mpfr_range_scope;

  static Mpfr_interval enclose(const Rational& value) { return Mpfr_interval(value); }
  static Mpfr_interval hull(const Mpfr_interval& a, const Mpfr_interval& b)
  {
    return Mpfr_interval::apply<mpfi_union>(a, b);
  }
  static bool is_number(const Mpfr_interval& x) { return mpfi_nan_p(x.value()) == 0; }
  static Mpfr_interval intersection(const Mpfr_interval& a, const Mpfr_interval& b);
  static Mpfr_interval lower(const Mpfr_interval& x) { return point(x.precision(), x.lower()); }
  static Mpfr_interval upper(const Mpfr_interval& x) { return point(x.precision(), x.upper()); }
  static std::optional<Rational> exact_lower(const Mpfr_interval& x) { return exact(x.lower()); }
  static std::optional<Rational> exact_upper(const Mpfr_interval& x) { return exact(x.upper()); }
  static int lower_sign(const Mpfr_interval& x) { return sign(x.lower(), -1); }
  static int upper_sign(const Mpfr_interval& x) { return sign(x.upper(), 1); }

private:
  static Mpfr_interval point(long bits, mpfr_srcptr end)
  {
    Mpfr_interval result(Mpfr_interval::Bits{bits});
    mpfi_set_fr(result.value_, end);
    return result;
  }
  static std::optional<Rational> exact(mpfr_srcptr end);
  static int sign(mpfr_srcptr end, int of_no_number)
  {
    if (mpfr_nan_p(end) != 0) return of_no_number;
    const int size = mpfr_sgn(end);
    return (size > 0) - (size < 0);
  }
};

} // namespace corral

#endif
