// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/errors.h>
#include <corral/polynomial/square_free.h>

#include <flint/fmpz_mpoly.h>

namespace corral::detail {

namespace {

/// The ring of integer polynomials in some number of variables, in lexicographic order.
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

/// A polynomial of FLINT with an owner.
class Flint_polynomial
{
public:
  explicit Flint_polynomial(const Ring& ring) : context_(ring.context()) { fmpz_mpoly_init(value_, context_); }
  Flint_polynomial(const Flint_polynomial&) = delete;
  Flint_polynomial& operator=(const Flint_polynomial&) = delete;
  ~Flint_polynomial() { fmpz_mpoly_clear(value_, context_); }
  [[nodiscard]] fmpz_mpoly_struct* get() { return value_; }

private:
  const fmpz_mpoly_ctx_struct* context_;
  fmpz_mpoly_t value_;
};

void assign(fmpz_mpoly_struct* target, const Flat_terms& f, const Ring& ring)
{
  std::vector<ulong> exponents(f.dimension);
  fmpz_t coefficient;
  fmpz_init(coefficient);
  for (std::size_t i = 0; i < f.coefficients.size(); ++i) {
    std::copy_n(f.exponents.begin() + static_cast<std::ptrdiff_t>(i * f.dimension), f.dimension, exponents.begin());
    fmpz_set_mpz(coefficient, f.coefficients[i].get_mpz_t());
    fmpz_mpoly_push_term_fmpz_ui(target, coefficient, exponents.data(), ring.context());
  }
  fmpz_clear(coefficient);
  fmpz_mpoly_sort_terms(target, ring.context());
}

Flat_terms flat_terms(const fmpz_mpoly_struct* f, std::size_t dimension, const Ring& ring)
{
  Flat_terms result{dimension, {}, {}};
  std::vector<ulong> exponents(dimension);
  fmpz_t coefficient;
  fmpz_init(coefficient);
  for (slong i = 0; i < fmpz_mpoly_length(f, ring.context()); ++i) {
    fmpz_mpoly_get_term_exp_ui(exponents.data(), f, i, ring.context());
    for (const ulong exponent : exponents) result.exponents.push_back(static_cast<std::uint16_t>(exponent));
    fmpz_mpoly_get_term_coeff_fmpz(coefficient, f, i, ring.context());
    fmpz_get_mpz(result.coefficients.emplace_back().get_mpz_t(), coefficient);
  }
  fmpz_clear(coefficient);
  return result;
}

} // namespace

Flat_terms square_free_part(const Flat_terms& f)
{
  const Ring ring(f.dimension);
  const auto* context = ring.context();
  Flint_polynomial whole(ring);
  Flint_polynomial divisor(ring);
  Flint_polynomial slope(ring);
  assign(whole.get(), f, ring);
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
  return flat_terms(quotient.get(), f.dimension, ring);
}

} // namespace corral::detail
