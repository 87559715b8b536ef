// SPDX-License-Identifier: LGPL-3.0-or-later
#include "square_free.h"

#include <corral/errors.h>

#include <memory>
#include <string>
#include <vector>

namespace corral::detail {

/// The greatest common divisor of a polynomial and its derivatives divides all of them, so that the quotient has every
/// factor; that the quotient has none twice says that it is the greatest.
Flat_terms square_free_part(const Flat_terms& f, const Flint_functions& flint)
{
  const Flint_ring ring(f.dimension);
  const auto* context = ring.context();
  const Flint_polynomial whole(ring, f);
  if (fmpz_mpoly_is_fmpz(whole.get(), context)) return {f.dimension, f.exponents, {sgn(f.coefficients[0])}};
  Flint_polynomial divisor(ring);
  Flint_polynomial quotient(ring);
  std::vector<std::unique_ptr<Flint_polynomial>> slopes;
  fmpz_mpoly_set(divisor.get(), whole.get(), context);
  // A repeated factor divides every derivative, so that one coprime derivative ends the search.
  for (std::size_t axis = 0; axis < f.dimension && !fmpz_mpoly_is_fmpz(divisor.get(), context); ++axis) {
    auto& slope = *slopes.emplace_back(std::make_unique<Flint_polynomial>(ring));
    fmpz_mpoly_derivative(slope.get(), whole.get(), static_cast<slong>(axis), context);
    if (flint.gcd(divisor.get(), divisor.get(), slope.get(), context) == 0)
      throw Budget_exceeded("square_free_part: the greatest common divisor of a polynomial of "
                            + std::to_string(f.coefficients.size())
                            + " terms and its derivative does not fit in memory; expected a smaller polynomial");
  }
  if (!fmpz_mpoly_is_fmpz(divisor.get(), context))
    for (const auto& slope : slopes) divide_exactly(quotient, *slope, divisor, ring, flint);
  divide_exactly(quotient, whole, divisor, ring, flint);
  auto result = quotient.terms();
  require_square_free(result);
  return result;
}

bool is_surely_square_free(const Flat_terms& f) { return is_shown_square_free(f, 1); }

Flat_terms square_free_part(const Flat_terms& f) { return square_free_part(f, Flint_functions()); }

} // namespace corral::detail
