// SPDX-License-Identifier: LGPL-3.0-or-later
#include "multivariate.h"

#include "../polynomial/Flint_ring.h"

#include <corral/errors.h>

#include <flint/fmpz_mpoly_factor.h>

#include <string>
#include <vector>

namespace corral::exact {

using detail::Flint_polynomial;
using detail::Flint_ring;

template <std::size_t D>
Common_factor<D> common_factor(const Polynomial<Integer, D>& f, const Polynomial<Integer, D>& g)
{
  const Flint_ring ring(D);
  Flint_polynomial a(ring, detail::flat_terms(f));
  Flint_polynomial b(ring, detail::flat_terms(g));
  Flint_polynomial divisor(ring);
  if (fmpz_mpoly_gcd(divisor.get(), a.get(), b.get(), ring.context()) == 0)
    throw Budget_exceeded("exact decision: the greatest common divisor of two polynomials of "
                          + std::to_string(f.terms().size()) + " and " + std::to_string(g.terms().size())
                          + " terms does not fit in memory; expected smaller ones");
  fmpz_mpoly_divides(a.get(), a.get(), divisor.get(), ring.context());
  fmpz_mpoly_divides(b.get(), b.get(), divisor.get(), ring.context());
  const auto taken = [](const Flint_polynomial& p) { return detail::from_flat_terms<D>(p.terms()); };
  return {taken(divisor), taken(a), taken(b)};
}

template Common_factor<2> common_factor(const Polynomial<Integer, 2>&, const Polynomial<Integer, 2>&);
template Common_factor<3> common_factor(const Polynomial<Integer, 3>&, const Polynomial<Integer, 3>&);

std::vector<Polynomial<Integer, 3>> irreducible_factors(const Polynomial<Integer, 3>& f)
{
  const Flint_ring ring(3);
  Flint_polynomial whole(ring, detail::flat_terms(f));
  Flint_polynomial base(ring);
  fmpz_mpoly_factor_t factors;
  fmpz_mpoly_factor_init(factors, ring.context());
  const bool is_done = fmpz_mpoly_factor(factors, whole.get(), ring.context()) != 0;
  std::vector<Polynomial<Integer, 3>> result;
  for (slong k = 0; is_done && k < fmpz_mpoly_factor_length(factors, ring.context()); ++k) {
    fmpz_mpoly_factor_get_base(base.get(), factors, k, ring.context());
    result.push_back(detail::from_flat_terms<3>(base.terms()));
  }
  fmpz_mpoly_factor_clear(factors, ring.context());
  if (!is_done)
    throw Budget_exceeded("exact decision: the factors of a polynomial of " + std::to_string(f.terms().size())
                          + " terms do not fit in memory; expected a smaller one");
  return result;
}

Polynomial<Integer, 2> resultant(const Polynomial<Integer, 3>& f, const Polynomial<Integer, 3>& g)
{
  const Flint_ring ring(3);
  Flint_polynomial a(ring, detail::flat_terms(f));
  Flint_polynomial b(ring, detail::flat_terms(g));
  Flint_polynomial result(ring);
  if (fmpz_mpoly_resultant(result.get(), a.get(), b.get(), 2, ring.context()) == 0)
    throw Budget_exceeded("exact decision: the resultant of two polynomials of " + std::to_string(f.terms().size())
                          + " and " + std::to_string(g.terms().size())
                          + " terms does not fit in memory; expected smaller ones");
  const auto eliminated = detail::from_flat_terms<3>(result.terms());
  std::vector<Polynomial<Integer, 2>::Term> terms;
  for (const auto& term : eliminated.terms())
    terms.push_back({{term.exponents[0], term.exponents[1]}, term.coefficient});
  return collect<Integer, 2>(std::move(terms));
}

} // namespace corral::exact
