// SPDX-License-Identifier: LGPL-3.0-or-later
#include "multivariate.h"

#include <corral/errors.h>
#include <corral/internal/polynomial/integer_form.h>
#include <corral/polynomial/arithmetic.h>

#include <string>
#include <utility>
#include <vector>

namespace corral::exact {

using detail::Flat_terms;
using detail::Flint_functions;
using detail::Flint_polynomial;
using detail::Flint_ring;

namespace {

template <std::size_t D>
std::string terms_of(const Polynomial<Integer, D>& f)
{
  return std::to_string(f.terms().size());
}

/// FLINT's factors and their product.
class Factorization
{
public:
  explicit Factorization(const Flint_ring& ring) : ring_(ring) { fmpz_mpoly_factor_init(value_, ring.context()); }
  Factorization(const Factorization&) = delete;
  Factorization& operator=(const Factorization&) = delete;
  ~Factorization() { fmpz_mpoly_factor_clear(value_, ring_.context()); }

  [[nodiscard]] fmpz_mpoly_factor_struct* get() { return value_; }
  [[nodiscard]] slong length() const { return fmpz_mpoly_factor_length(value_, ring_.context()); }
  [[nodiscard]] slong exponent(slong k) { return fmpz_mpoly_factor_get_exp_si(value_, k, ring_.context()); }
  void base(Flint_polynomial& result, slong k) const
  {
    fmpz_mpoly_factor_get_base(result.get(), value_, k, ring_.context());
  }

private:
  const Flint_ring& ring_;
  fmpz_mpoly_factor_t value_;
};

/// \throw Wrong_answer unless the value of `result` at two points is the resultant of f and g there.
void require_resultant(const Flat_terms& result, const Flat_terms& f, const Flat_terms& g)
{
  int agreed = 0;
  for (int round = 0; round < detail::Test_point::max_rounds && agreed < 2; ++round) {
    detail::Test_point source(round);
    const Prime_field& field = source.field();
    std::vector<Prime_field::Element> point(3);
    for (auto& x : point) x = source.next();
    auto a = image_on_line(field, f, 2, point);
    auto b = image_on_line(field, g, 2, point);
    if (a.size() != degree(f, 2) + 1 || b.size() != degree(g, 2) + 1) continue; // the degree falls there
    const auto claimed = image_on_line(field, result, 2, point);                // a constant
    const auto value = modular_elimination(field, std::move(a), std::move(b)).resultant;
    if (claimed.size() > 1 || (claimed.empty() ? field.zero() : claimed[0]) != value) break;
    ++agreed;
  }
  if (agreed < 2)
    throw Wrong_answer("algebra: FLINT gives a wrong resultant of two polynomials of "
                       + std::to_string(f.coefficients.size()) + " and " + std::to_string(g.coefficients.size())
                       + " terms");
}

} // namespace

template <std::size_t D>
Common_factor<D> common_factor(const Polynomial<Integer, D>& f, const Polynomial<Integer, D>& g,
                               const Flint_functions& flint)
{
  const Flint_ring ring(D);
  const Flint_polynomial a(ring, detail::flat_terms(f));
  const Flint_polynomial b(ring, detail::flat_terms(g));
  Flint_polynomial divisor(ring);
  if (flint.gcd(divisor.get(), a.get(), b.get(), ring.context()) == 0)
    throw Budget_exceeded("exact decision: the greatest common divisor of two polynomials of " + terms_of(f) + " and "
                          + terms_of(g) + " terms does not fit in memory; expected smaller ones");
  Flint_polynomial a_rest(ring);
  Flint_polynomial b_rest(ring);
  detail::divide_exactly(a_rest, a, divisor, ring, flint);
  detail::divide_exactly(b_rest, b, divisor, ring, flint);
  auto f_rest = a_rest.terms();
  auto g_rest = b_rest.terms();
  detail::require_coprime(f_rest, g_rest);
  return {detail::from_flat_terms<D>(divisor.terms()), detail::from_flat_terms<D>(std::move(f_rest)),
          detail::from_flat_terms<D>(std::move(g_rest))};
}

template Common_factor<2> common_factor(const Polynomial<Integer, 2>&, const Polynomial<Integer, 2>&,
                                        const Flint_functions&);
template Common_factor<3> common_factor(const Polynomial<Integer, 3>&, const Polynomial<Integer, 3>&,
                                        const Flint_functions&);

template <std::size_t D>
std::vector<Polynomial<Integer, D>> irreducible_factors(const Polynomial<Integer, D>& f, const Flint_functions& flint)
{
  const Flint_ring ring(D);
  const Flint_polynomial whole(ring, detail::flat_terms(f));
  Factorization factors(ring);
  if (flint.factor(factors.get(), whole.get(), ring.context()) == 0)
    throw Budget_exceeded("exact decision: the factors of a polynomial of " + terms_of(f)
                          + " terms do not fit in memory; expected a smaller one");
  Flint_polynomial base(ring);
  Flint_polynomial product(ring);
  fmpz_mpoly_one(product.get(), ring.context());
  std::vector<Polynomial<Integer, D>> result;
  for (slong k = 0; k < factors.length(); ++k) {
    factors.base(base, k);
    for (slong left = factors.exponent(k); left > 0; --left)
      fmpz_mpoly_mul(product.get(), product.get(), base.get(), ring.context());
    result.push_back(detail::from_flat_terms<D>(base.terms()));
  }
  const auto factored = primitive_part(detail::from_flat_terms<D>(product.terms()));
  const auto expected = primitive_part(f);
  if (factored != expected && factored != -expected)
    throw Wrong_answer("algebra: the factors of a polynomial of " + terms_of(f)
                       + " terms that FLINT gives do not have it as their product");
  return result;
}

template std::vector<Polynomial<Integer, 2>> irreducible_factors(const Polynomial<Integer, 2>&, const Flint_functions&);
template std::vector<Polynomial<Integer, 3>> irreducible_factors(const Polynomial<Integer, 3>&, const Flint_functions&);

Polynomial<Integer, 2> resultant(const Polynomial<Integer, 3>& f, const Polynomial<Integer, 3>& g,
                                 const Flint_functions& flint)
{
  const Flint_ring ring(3);
  const auto f_terms = detail::flat_terms(f);
  const auto g_terms = detail::flat_terms(g);
  const Flint_polynomial a(ring, f_terms);
  const Flint_polynomial b(ring, g_terms);
  Flint_polynomial result(ring);
  if (flint.resultant(result.get(), a.get(), b.get(), 2, ring.context()) == 0)
    throw Budget_exceeded("exact decision: the resultant of two polynomials of " + terms_of(f) + " and " + terms_of(g)
                          + " terms does not fit in memory; expected smaller ones");
  auto eliminated = result.terms();
  require_resultant(eliminated, f_terms, g_terms);
  std::vector<Polynomial<Integer, 2>::Term> terms;
  for (std::size_t i = 0; i < eliminated.coefficients.size(); ++i)
    terms.push_back(
        {{eliminated.exponents[3 * i], eliminated.exponents[3 * i + 1]}, std::move(eliminated.coefficients[i])});
  return collect<Integer, 2>(std::move(terms));
}

} // namespace corral::exact
