// SPDX-License-Identifier: LGPL-3.0-or-later
#include "multivariate.h"

#include <corral/errors.h>
#include <corral/polynomial/integer_form.h>
#include <corral/polynomial/square_free.h>

#include <flint/fmpz_mpoly.h>

#include <algorithm>
#include <array>
#include <vector>

namespace corral::exact {

namespace {

/// The ring of integer polynomials in D variables.
class Ring
{
public:
  explicit Ring(std::size_t dimension) { fmpz_mpoly_ctx_init(context_, static_cast<slong>(dimension), ORD_LEX); }
  Ring(const Ring&) = delete;
  Ring& operator=(const Ring&) = delete;
  ~Ring() { fmpz_mpoly_ctx_clear(context_); }
  [[nodiscard]] const fmpz_mpoly_ctx_struct* context() const { return context_; }

private:
  fmpz_mpoly_ctx_t context_;
};

/// Owner of an element of the ring.
template <std::size_t D>
class Element
{
public:
  explicit Element(const Ring& ring) : context_(ring.context()) { fmpz_mpoly_init(value_, context_); }
  Element(const Ring& ring, const Polynomial<Integer, D>& f) : Element(ring)
  {
    std::array<ulong, D> exponents;
    fmpz_t coefficient;
    fmpz_init(coefficient);
    for (const auto& term : f.terms()) {
      std::copy(term.exponents.begin(), term.exponents.end(), exponents.begin());
      fmpz_set_mpz(coefficient, term.coefficient.get_mpz_t());
      fmpz_mpoly_push_term_fmpz_ui(value_, coefficient, exponents.data(), context_);
    }
    fmpz_clear(coefficient);
    fmpz_mpoly_sort_terms(value_, context_);
  }
  Element(const Element&) = delete;
  Element& operator=(const Element&) = delete;
  ~Element() { fmpz_mpoly_clear(value_, context_); }

  [[nodiscard]] fmpz_mpoly_struct* get() { return value_; }
  [[nodiscard]] Polynomial<Integer, D> polynomial() const
  {
    std::vector<typename Polynomial<Integer, D>::Term> terms(
        static_cast<std::size_t>(fmpz_mpoly_length(value_, context_)));
    std::array<ulong, D> exponents;
    fmpz_t coefficient;
    fmpz_init(coefficient);
    for (std::size_t i = 0; i < terms.size(); ++i) {
      fmpz_mpoly_get_term_exp_ui(exponents.data(), value_, static_cast<slong>(i), context_);
      for (std::size_t k = 0; k < D; ++k) terms[i].exponents[k] = static_cast<std::uint16_t>(exponents[k]);
      fmpz_mpoly_get_term_coeff_fmpz(coefficient, value_, static_cast<slong>(i), context_);
      fmpz_get_mpz(terms[i].coefficient.get_mpz_t(), coefficient);
    }
    fmpz_clear(coefficient);
    return collect<Integer, D>(std::move(terms));
  }

private:
  const fmpz_mpoly_ctx_struct* context_;
  fmpz_mpoly_t value_;
};

} // namespace

template <std::size_t D>
Common_factor<D> common_factor(const Polynomial<Integer, D>& f, const Polynomial<Integer, D>& g)
{
  const Ring ring(D);
  Element<D> a(ring, f);
  Element<D> b(ring, g);
  Element<D> divisor(ring);
  if (fmpz_mpoly_gcd(divisor.get(), a.get(), b.get(), ring.context()) == 0)
    throw Budget_exceeded("exact decision: the greatest common divisor of two polynomials of "
                          + std::to_string(f.terms().size()) + " and " + std::to_string(g.terms().size())
                          + " terms does not fit in memory; expected smaller ones");
  fmpz_mpoly_divides(a.get(), a.get(), divisor.get(), ring.context());
  fmpz_mpoly_divides(b.get(), b.get(), divisor.get(), ring.context());
  return {divisor.polynomial(), a.polynomial(), b.polynomial()};
}

template Common_factor<2> common_factor(const Polynomial<Integer, 2>&, const Polynomial<Integer, 2>&);
template Common_factor<3> common_factor(const Polynomial<Integer, 3>&, const Polynomial<Integer, 3>&);

std::optional<Polynomial<Integer, 2>> projection(const Polynomial<Integer, 3>& f, const Polynomial<Integer, 3>& g)
{
  const Ring ring(3);
  Element<3> a(ring, f);
  Element<3> b(ring, g);
  Element<3> result(ring);
  if (fmpz_mpoly_resultant(result.get(), a.get(), b.get(), 2, ring.context()) == 0) return std::nullopt;
  const auto eliminated = result.polynomial();
  std::vector<Polynomial<Integer, 2>::Term> terms;
  for (const auto& term : eliminated.terms())
    terms.push_back({{term.exponents[0], term.exponents[1]}, term.coefficient});
  return square_free_part(collect<Integer, 2>(std::move(terms)));
}

} // namespace corral::exact
