// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/algebra/real_roots.h>

namespace corral {

Rational simplest_rational(const Rational_interval& interval)
{
  if (interval.lower() <= 0 && interval.upper() >= 0) return 0;
  if (interval.upper() < 0) return -simplest_rational(-interval);
  // Continued fractions: the integer parts agree until one end is passed.
  Integer whole;
  mpz_cdiv_q(whole.get_mpz_t(), interval.lower().get_num_mpz_t(), interval.lower().get_den_mpz_t());
  if (whole <= interval.upper()) return whole;
  --whole;
  const Rational rest = simplest_rational({1 / (interval.upper() - whole), 1 / (interval.lower() - whole)});
  return whole + 1 / rest;
}

} // namespace corral
