// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_POLYNOMIAL_FLINT_RING_H
#define CORRAL_SRC_POLYNOMIAL_FLINT_RING_H

#include "to_exponent.h"

#include <corral/internal/polynomial/Flat_terms.h>

#include <flint/fmpz_mpoly.h>

#include <algorithm>
#include <cstddef>
#include <vector>

/// \file
/// FLINT's polynomials in several variables with owners. Only translation units that link FLINT include this.
namespace corral::detail {

/// The ring of integer polynomials in some number of variables, in lexicographic order.
class Flint_ring
{
public:
  explicit Flint_ring(std::size_t dimension) : dimension_(dimension)
  {
    fmpz_mpoly_ctx_init(context_, static_cast<slong>(dimension), ORD_LEX);
  }
  Flint_ring(const Flint_ring&) = delete;
  Flint_ring& operator=(const Flint_ring&) = delete;
  ~Flint_ring() { fmpz_mpoly_ctx_clear(context_); }

  [[nodiscard]] const fmpz_mpoly_ctx_struct* context() const { return context_; }
  [[nodiscard]] std::size_t dimension() const { return dimension_; }

private:
  std::size_t dimension_;
  fmpz_mpoly_ctx_t context_;
};

/// A polynomial of a ring, which must outlive it.
class Flint_polynomial
{
public:
  explicit Flint_polynomial(const Flint_ring& ring) : ring_(ring) { fmpz_mpoly_init(value_, ring.context()); }
  Flint_polynomial(const Flint_ring& ring, const Flat_terms& f) : Flint_polynomial(ring)
  {
    std::vector<ulong> exponents(f.dimension);
    fmpz_t coefficient;
    fmpz_init(coefficient);
    for (std::size_t i = 0; i < f.coefficients.size(); ++i) {
      std::copy_n(f.exponents.begin() + static_cast<std::ptrdiff_t>(i * f.dimension), f.dimension, exponents.begin());
      fmpz_set_mpz(coefficient, f.coefficients[i].get_mpz_t());
      fmpz_mpoly_push_term_fmpz_ui(value_, coefficient, exponents.data(), ring.context());
    }
    fmpz_clear(coefficient);
    fmpz_mpoly_sort_terms(value_, ring.context());
  }
  Flint_polynomial(const Flint_polynomial&) = delete;
  Flint_polynomial& operator=(const Flint_polynomial&) = delete;
  ~Flint_polynomial() { fmpz_mpoly_clear(value_, ring_.context()); }

  [[nodiscard]] fmpz_mpoly_struct* get() { return value_; }
  [[nodiscard]] const fmpz_mpoly_struct* get() const { return value_; }
  [[nodiscard]] slong length() const { return fmpz_mpoly_length(value_, ring_.context()); }
  /// \throw Budget_exceeded if an exponent is above 65535.
  [[nodiscard]] Flat_terms terms() const
  {
    Flat_terms result{ring_.dimension(), {}, {}};
    std::vector<ulong> exponents(ring_.dimension());
    fmpz_t coefficient;
    fmpz_init(coefficient);
    for (slong i = 0; i < length(); ++i) {
      fmpz_mpoly_get_term_exp_ui(exponents.data(), value_, i, ring_.context());
      for (const ulong exponent : exponents) result.exponents.push_back(to_exponent(exponent));
      fmpz_mpoly_get_term_coeff_fmpz(coefficient, value_, i, ring_.context());
      fmpz_get_mpz(result.coefficients.emplace_back().get_mpz_t(), coefficient);
    }
    fmpz_clear(coefficient);
    return result;
  }

private:
  const Flint_ring& ring_;
  fmpz_mpoly_t value_;
};

} // namespace corral::detail

#endif
