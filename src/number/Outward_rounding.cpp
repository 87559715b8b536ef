// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/number/Outward_rounding.h>

namespace corral {

double Outward_rounding::multiply_up_scaled(double a, double b)
{
  if (a == 0 || b == 0) return 0;
  const double product = a * b;
  if (!std::isfinite(product)) return step_up_unless(false, product);
  int a_exponent = 0;
  int b_exponent = 0;
  const double a_mantissa = std::frexp(a, &a_exponent);
  const double b_mantissa = std::frexp(b, &b_exponent);
  const double mantissa = a_mantissa * b_mantissa;
  // The product in the scale of the mantissas; it is 0 or within a factor of two of `mantissa`, so that their
  // difference is exact, and the sum below has the sign of a * b - product.
  const double rounded = std::ldexp(product, -(a_exponent + b_exponent));
  const double error = (mantissa - rounded) + product_error(a_mantissa, b_mantissa, mantissa);
  return step_up_unless(error <= 0, product);
}

} // namespace corral
