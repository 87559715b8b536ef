// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_AUDIT_NUMBER_FAULTS_H
#define CORRAL_AUDIT_NUMBER_FAULTS_H

#include "Faulty_interval.h"

#include <cmath>
#include <limits>

/// \file
/// Number types with one fault each, in the order of the operations.
namespace corral::audit {

struct Sum_upper_rounded_down : No_fault
{
  static constexpr std::string_view name = "sum_upper_rounded_down";
  static constexpr std::string_view description = "the upper end of a sum is rounded down";
  static X add(const X& a, const X& b)
  {
    return X::from_ends(Outward_rounding::add_down(a.lower(), b.lower()),
                        Outward_rounding::add_down(a.upper(), b.upper()));
  }
};

struct Sum_lower_rounded_up : No_fault
{
  static constexpr std::string_view name = "sum_lower_rounded_up";
  static constexpr std::string_view description = "the lower end of a sum is rounded up";
  static X add(const X& a, const X& b)
  {
    return X::from_ends(Outward_rounding::add_up(a.lower(), b.lower()), Outward_rounding::add_up(a.upper(), b.upper()));
  }
};

struct Difference_to_nearest : No_fault
{
  static constexpr std::string_view name = "difference_to_nearest";
  static constexpr std::string_view description = "a difference is rounded to nearest, as if it were always exact";
  static X subtract(const X& a, const X& b) { return X::from_ends(a.lower() - b.upper(), a.upper() - b.lower()); }
};

struct Difference_of_like_ends : No_fault
{
  static constexpr std::string_view name = "difference_of_like_ends";
  static constexpr std::string_view description = "lower minus lower and upper minus upper";
  static X subtract(const X& a, const X& b)
  {
    const double first = Outward_rounding::add_down(a.lower(), -b.lower());
    const double second = Outward_rounding::add_up(a.upper(), -b.upper());
    return X::from_ends(std::min(first, second), std::max(first, second));
  }
};

struct Product_upper_rounded_down : No_fault
{
  static constexpr std::string_view name = "product_upper_rounded_down";
  static constexpr std::string_view description = "the upper end of a product of positive intervals is rounded down";
  static X multiply(const X& a, const X& b)
  {
    if (!(a.lower() > 0 && b.lower() > 0)) return a * b;
    return X::from_ends((a * b).lower(), Outward_rounding::multiply_down(a.upper(), b.upper()));
  }
};

struct Product_lower_rounded_up : No_fault
{
  static constexpr std::string_view name = "product_lower_rounded_up";
  static constexpr std::string_view description = "the lower end of a product of positive intervals is rounded up";
  static X multiply(const X& a, const X& b)
  {
    if (!(a.lower() > 0 && b.lower() > 0)) return a * b;
    return X::from_ends(Outward_rounding::multiply_up(a.lower(), b.lower()), (a * b).upper());
  }
};

struct Product_of_two_corners : No_fault
{
  static constexpr std::string_view name = "product_of_two_corners";
  static constexpr std::string_view description = "a product of mixed signs looks at two of the four corner products";
  static X multiply(const X& a, const X& b)
  {
    const bool mixed = a.lower() < 0 && a.upper() > 0 && b.lower() < 0 && b.upper() > 0;
    if (!mixed) return a * b;
    return X::from_ends(Outward_rounding::multiply_down(a.lower(), b.upper()),
                        Outward_rounding::multiply_up(a.upper(), b.upper()));
  }
};

struct Product_shrinks : No_fault
{
  static constexpr std::string_view name = "product_shrinks";
  static constexpr std::string_view description =
      "the lower end of a wide product is one unit in the last place too high";
  static X multiply(const X& a, const X& b)
  {
    const X product = a * b;
    if (!(product.lower() < product.upper())) return product;
    return X::from_ends(std::nextafter(product.lower(), product.upper()), product.upper());
  }
};

struct Product_error_underflows : No_fault
{
  static constexpr std::string_view name = "product_error_underflows";
  static constexpr std::string_view description =
      "the error of a product, by which the step outward is decided, is computed where it underflows to zero";
  static double up(double a, double b)
  {
    const double product = a * b;
    const double error = std::fma(a, b, -product);
    return error <= 0 ? product : std::nextafter(product, std::numeric_limits<double>::infinity());
  }
  static X multiply(const X& a, const X& b)
  {
    if (a.lower() != a.upper() || b.lower() != b.upper() || !std::isfinite(a.lower() * b.lower())) return a * b;
    return X::from_ends(-up(-a.lower(), b.lower()), up(a.lower(), b.lower()));
  }
};

struct Square_loses_zero : No_fault
{
  static constexpr std::string_view name = "square_loses_zero";
  static constexpr std::string_view description = "the square of an interval of both signs does not reach zero";
  static X square_of(const X& a)
  {
    const X low = square(X(a.lower()));
    const X high = square(X(a.upper()));
    return X::from_ends(std::min(low.lower(), high.lower()), std::max(low.upper(), high.upper()));
  }
};

struct Square_keeps_order : No_fault
{
  static constexpr std::string_view name = "square_keeps_order";
  static constexpr std::string_view description =
      "the square of a negative interval is [lower^2, upper^2], upside down";
  static X square_of(const X& a)
  {
    if (!(a.upper() < 0)) return square(a);
    return X::from_ends(square(X(a.lower())).lower(), square(X(a.upper())).upper());
  }
};

struct No_outward_step : No_fault
{
  static constexpr std::string_view name = "no_outward_step";
  static constexpr std::string_view description = "sums and products are rounded to nearest and never stepped outward";
  static X add(const X& a, const X& b) { return X::from_ends(a.lower() + b.lower(), a.upper() + b.upper()); }
  static X subtract(const X& a, const X& b) { return add(a, -b); }
  static X multiply(const X& a, const X& b)
  {
    const double products[] = {a.lower() * b.lower(), a.lower() * b.upper(), a.upper() * b.lower(),
                               a.upper() * b.upper()};
    const auto [low, high] = std::minmax_element(std::begin(products), std::end(products));
    return X::from_ends(*low, *high);
  }
};

struct One_end_stepped : No_fault
{
  static constexpr std::string_view name = "one_end_stepped";
  static constexpr std::string_view description = "only lower ends are stepped outward";
  static X add(const X& a, const X& b) { return X::from_ends((a + b).lower(), a.upper() + b.upper()); }
  static X multiply(const X& a, const X& b)
  {
    return X::from_ends((a * b).lower(), No_outward_step::multiply(a, b).upper());
  }
};

struct Step_by_a_factor : No_fault
{
  static constexpr std::string_view name = "step_by_a_factor";
  static constexpr std::string_view description =
      "products are widened by 2^-52 of their size, which is nothing at subnormals";
  static X multiply(const X& a, const X& b)
  {
    const X nearest = No_outward_step::multiply(a, b);
    if (!std::isfinite(nearest.lower()) || !std::isfinite(nearest.upper())) return a * b;
    return X::from_ends(nearest.lower() - std::fabs(nearest.lower()) * 0x1p-52,
                        nearest.upper() + std::fabs(nearest.upper()) * 0x1p-52);
  }
};

struct Flush_to_zero : No_fault
{
  static constexpr std::string_view name = "flush_to_zero";
  static constexpr std::string_view description = "subnormal results become zero, as with the processor's FTZ mode";
  static double flushed(double x) { return std::fabs(x) < std::numeric_limits<double>::min() ? 0 : x; }
  static X flushed(const X& x) { return X::from_ends(flushed(x.lower()), flushed(x.upper())); }
  static X add(const X& a, const X& b) { return flushed(a + b); }
  static X multiply(const X& a, const X& b) { return flushed(a * b); }
  static X square_of(const X& a) { return flushed(square(a)); }
};

struct Overflow_saturates : No_fault
{
  static constexpr std::string_view name = "overflow_saturates";
  static constexpr std::string_view description = "what exceeds the largest double becomes the largest double";
  static X multiply(const X& a, const X& b)
  {
    constexpr double largest = std::numeric_limits<double>::max();
    const X product = a * b;
    return X::from_ends(std::clamp(product.lower(), -largest, largest), std::clamp(product.upper(), -largest, largest));
  }
};

struct Hull_drops_an_end : No_fault
{
  static constexpr std::string_view name = "hull_drops_an_end";
  static constexpr std::string_view description = "the hull takes the upper end of its first operand";
  static X hull(const X& a, const X& b) { return X::from_ends(std::min(a.lower(), b.lower()), a.upper()); }
};

struct Enclose_to_nearest : No_fault
{
  static constexpr std::string_view name = "enclose_to_nearest";
  static constexpr std::string_view description = "a fraction is replaced by the nearest double";
  static X enclose(const Rational& value) { return X(bracket(value).nearest); }
};

struct Enclose_subnormals_as_zero : No_fault
{
  static constexpr std::string_view name = "enclose_subnormals_as_zero";
  static constexpr std::string_view description = "exact numbers below the smallest normal double become [0, 0]";
  static X enclose(const Rational& value) { return Flush_to_zero::flushed(No_fault::enclose(value)); }
};

} // namespace corral::audit

#endif
