// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_COUNTED_H
#define CORRAL_NUMBER_COUNTED_H

#include <corral/number/Interval_number.h>

#include <cstdint>
#include <utility>

namespace corral {

/// How many operations a piece of work took.
struct Operation_counts
{
  std::uint64_t additions = 0;       ///< + and binary -
  std::uint64_t multiplications = 0; ///< * and square

  Operation_counts& operator+=(const Operation_counts& other)
  {
    additions += other.additions;
    multiplications += other.multiplications;
    return *this;
  }
  friend bool operator==(const Operation_counts&, const Operation_counts&) = default;
};

/// \brief Counts the operations that this thread makes with `Counted` numbers while the scope lives.
///
/// Scopes nest: what is counted in an inner one is counted in the outer one too. With any other number type nothing
/// is counted and the counts stay zero.
class Counting_scope
{
public:
  Counting_scope() : outer_(std::exchange(current(), {})) {}
  ~Counting_scope() { current() += outer_; }
  Counting_scope(const Counting_scope&) = delete;
  Counting_scope& operator=(const Counting_scope&) = delete;

  /// What was counted on this thread since the scope began.
  [[nodiscard]] Operation_counts counts() const { return current(); }

private:
  template <IntervalNumber I>
  friend class Counted;

  static Operation_counts& current()
  {
    static thread_local Operation_counts counts;
    return counts;
  }

  Operation_counts outer_;
};

/// \brief Model of `IntervalNumber`: the interval number `I`, counting its additions and multiplications.
///
/// Negation, hulls, end points, comparisons and conversions are not counted. Read the counts by a `Counting_scope`.
template <IntervalNumber I>
class Counted
{
public:
  Counted() = default;
  template <UnfitNumber T>
  Counted(T value) = delete;
  /// The built-in number as an `I`.
  template <MachineNumber T>
  Counted(T value) : value_(value)
  {}
  explicit Counted(I value) : value_(std::move(value)) {}

  [[nodiscard]] const I& value() const { return value_; }

  /// What this thread counted since its innermost `Counting_scope` began, or since it started.
  [[nodiscard]] static Operation_counts counts() { return Counting_scope::current(); }

  Counted& operator+=(const Counted& b)
  {
    count_addition();
    value_ += b.value_;
    return *this;
  }
  Counted& operator-=(const Counted& b)
  {
    count_addition();
    value_ -= b.value_;
    return *this;
  }
  Counted& operator*=(const Counted& b)
  {
    count_multiplication();
    value_ *= b.value_;
    return *this;
  }
  friend Counted operator-(const Counted& a) { return Counted(I(-a.value_)); }
  friend Counted operator+(Counted a, const Counted& b) { return std::move(a += b); }
  friend Counted operator-(Counted a, const Counted& b) { return std::move(a -= b); }
  friend Counted operator*(Counted a, const Counted& b) { return std::move(a *= b); }
  friend Counted square(const Counted& a)
  {
    count_multiplication();
    return Counted(I(square(a.value_)));
  }

private:
  static void count_addition() { ++Counting_scope::current().additions; }
  static void count_multiplication() { ++Counting_scope::current().multiplications; }

  I value_;
};

template <IntervalNumber I>
struct Interval_traits<Counted<I>>
{
  using Traits = Interval_traits<I>;
  static constexpr std::string_view name = "counted";
  static constexpr bool is_guaranteed = Traits::is_guaranteed;
  static constexpr bool is_exact = Traits::is_exact;
  using Scope = typename Traits::Scope;

  static Counted<I> enclose(const Rational& value) { return Counted<I>(Traits::enclose(value)); }
  static Counted<I> enclose(const Integer& mantissa, long exponent)
  {
    return Counted<I>(corral::enclose<I>(mantissa, exponent));
  }
  static bool is_number(const Counted<I>& x) { return Traits::is_number(x.value()); }
  static Counted<I> hull(const Counted<I>& a, const Counted<I>& b)
  {
    return Counted<I>(Traits::hull(a.value(), b.value()));
  }
  static Counted<I> intersection(const Counted<I>& a, const Counted<I>& b)
  {
    return Counted<I>(Traits::intersection(a.value(), b.value()));
  }
  static Counted<I> lower(const Counted<I>& x) { return Counted<I>(Traits::lower(x.value())); }
  static Counted<I> upper(const Counted<I>& x) { return Counted<I>(Traits::upper(x.value())); }
  static std::optional<Rational> exact_lower(const Counted<I>& x) { return Traits::exact_lower(x.value()); }
  static std::optional<Rational> exact_upper(const Counted<I>& x) { return Traits::exact_upper(x.value()); }
  static int lower_sign(const Counted<I>& x) { return Traits::lower_sign(x.value()); }
  static int upper_sign(const Counted<I>& x) { return Traits::upper_sign(x.value()); }
};

} // namespace corral

#endif
