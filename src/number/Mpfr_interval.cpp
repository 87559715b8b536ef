// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/errors.h>
#include <corral/number/Mpfr_interval.h>

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

std::optional<Rational> Interval_traits<Mpfr_interval>::exact(mpfr_srcptr end)
{
  if (mpfr_number_p(end) == 0) return std::nullopt;
  Rational result;
  mpfr_get_q(result.get_mpq_t(), end);
  return result;
}

} // namespace corral
