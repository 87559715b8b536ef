// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_BALL_H
#define CORRAL_SRC_ALGEBRA_BALL_H

#include <corral/algebra/Integer_polynomial.h>

#include <cstddef>

namespace corral::exact {

/// A number m 2^-bits up to r 2^-bits.
struct Ball
{
  Integer m;
  Integer r;
};

/// p at every point of an interval, by Horner's rule in fixed point.
inline Ball evaluate(const Integer_polynomial& p, const Ball& x, mp_bitcnt_t bits)
{
  Ball value{0, 0};
  Integer radius;
  for (std::size_t i = p.size(); i-- > 0;) {
    radius = abs(value.m) * x.r + value.r * (abs(x.m) + x.r);
    mpz_cdiv_q_2exp(radius.get_mpz_t(), radius.get_mpz_t(), bits);
    value.m *= x.m;
    mpz_fdiv_q_2exp(value.m.get_mpz_t(), value.m.get_mpz_t(), bits);
    value.r = radius + 1;
    value.m += p[i] << bits;
  }
  return value;
}

} // namespace corral::exact

#endif
