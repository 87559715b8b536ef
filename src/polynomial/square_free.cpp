// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Flint_ring.h"

#include <corral/errors.h>

#include <string>

namespace corral::detail {

Flat_terms square_free_part(const Flat_terms& f)
{
  const Flint_ring ring(f.dimension);
  const auto* context = ring.context();
  Flint_polynomial whole(ring, f);
  Flint_polynomial divisor(ring);
  Flint_polynomial slope(ring);
  fmpz_mpoly_set(divisor.get(), whole.get(), context);
  // A repeated factor divides every derivative, so that one coprime derivative ends the search.
  for (std::size_t axis = 0; axis < f.dimension && !fmpz_mpoly_is_fmpz(divisor.get(), context); ++axis) {
    fmpz_mpoly_derivative(slope.get(), whole.get(), static_cast<slong>(axis), context);
    if (fmpz_mpoly_gcd(divisor.get(), divisor.get(), slope.get(), context) == 0)
      throw Budget_exceeded("square_free_part: the greatest common divisor of a polynomial of "
                            + std::to_string(f.coefficients.size())
                            + " terms and its derivative does not fit in memory; expected a smaller polynomial");
  }
  if (fmpz_mpoly_is_fmpz(whole.get(), context)) return {f.dimension, f.exponents, {sgn(f.coefficients[0])}};
  Flint_polynomial quotient(ring);
  fmpz_mpoly_divides(quotient.get(), whole.get(), divisor.get(), context);
  return quotient.terms();
}

} // namespace corral::detail
