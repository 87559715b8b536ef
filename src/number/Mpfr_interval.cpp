// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/errors.h>
#include <corral/number/Mpfr_interval.h>

#include <cmath>
#include <limits>
#include <string>

namespace corral {

Mpfr_precision_scope::Mpfr_precision_scope(long bits) : outer_(current())
{
  if (bits < least || bits > greatest)
    throw Invalid_input("mpfr: given a precision of " + std::to_string(bits) + " bits; expected "
                        + std::to_string(least) + " to " + std::to_string(greatest));
  current() = bits;
}

Mpfr_range_scope::Mpfr_range_scope() : least_(mpfr_get_emin()), greatest_(mpfr_get_emax())
{
  mpfr_set_emin(MPFR_EMIN_DEFAULT);
  mpfr_set_emax(MPFR_EMAX_DEFAULT);
}

Mpfr_range_scope::~Mpfr_range_scope()
{
  mpfr_set_emin(least_);
  mpfr_set_emax(greatest_);
}

void Mpfr_interval::set(double value)
{
  constexpr double largest = std::numeric_limits<double>::max();
  if (std::isinf(value))
    mpfi_interv_d(value_, std::fmin(value, largest), std::fmax(value, -largest));
  else
    mpfi_set_d(value_, value);
}

Mpfr_interval Interval_traits<Mpfr_interval>::intersection(const Mpfr_interval& a, const Mpfr_interval& b)
{
  Mpfr_interval result(Mpfr_interval::Bits{std::max(a.precision(), b.precision())});
  mpfr_max(&result.value_->left, a.lower(), b.lower(), MPFR_RNDD);
  mpfr_min(&result.value_->right, a.upper(), b.upper(), MPFR_RNDU);
  if (mpfr_greater_p(result.lower(), result.upper()) != 0) mpfr_swap(&result.value_->left, &result.value_->right);
  return result;
}

std::optional<Rational> Interval_traits<Mpfr_interval>::exact(mpfr_srcptr end)
{
  if (mpfr_number_p(end) == 0) return std::nullopt;
  Rational result;
  mpfr_get_q(result.get_mpq_t(), end);
  return result;
}

} // namespace corral
