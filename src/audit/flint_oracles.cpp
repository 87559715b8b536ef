// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/audit/root_oracles.h>

#include <flint/fmpz_poly.h>

namespace corral {

Count_real_roots flint_count_real_roots;

std::size_t flint_count_real_roots(const Integer_polynomial& p)
{
  fmpz_poly_t polynomial;
  fmpz_poly_t repeated;
  fmpz_poly_init(polynomial);
  fmpz_poly_init(repeated);
  for (std::size_t i = 0; i < p.size(); ++i)
    fmpz_poly_set_coeff_mpz(polynomial, static_cast<slong>(i), p[i].get_mpz_t());
  // Sturm sequences of FLINT want a square-free polynomial.
  fmpz_poly_derivative(repeated, polynomial);
  fmpz_poly_gcd(repeated, repeated, polynomial);
  fmpz_poly_div(polynomial, polynomial, repeated);
  const auto count = static_cast<std::size_t>(fmpz_poly_num_real_roots_sturm(polynomial));
  fmpz_poly_clear(repeated);
  fmpz_poly_clear(polynomial);
  return count;
}

} // namespace corral
