// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_POLYNOMIAL_VERIFICATION_H
#define CORRAL_SRC_POLYNOMIAL_VERIFICATION_H

#include "../number/Prime_field.h"
#include "Flint_ring.h"

#include <corral/internal/number/Wrong_answer.h>

#include <flint/fmpz_mpoly_factor.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// \file
/// FLINT's answers are not believed but verified: quotients by multiplication, what has no common and no repeated
/// factor by images modulo a prime. Why that suffices: doc/exact.md, section 8.
namespace corral::detail {

/// What is asked of FLINT. A test puts somebody who errs in its place.
struct Flint_functions
{
  using Binary = int (*)(fmpz_mpoly_struct*, const fmpz_mpoly_struct*, const fmpz_mpoly_struct*,
                         const fmpz_mpoly_ctx_struct*);
  Binary gcd = fmpz_mpoly_gcd;
  Binary divides = fmpz_mpoly_divides;
  int (*factor)(fmpz_mpoly_factor_struct*, const fmpz_mpoly_struct*, const fmpz_mpoly_ctx_struct*) = fmpz_mpoly_factor;
  int (*resultant)(fmpz_mpoly_struct*, const fmpz_mpoly_struct*, const fmpz_mpoly_struct*, slong,
                   const fmpz_mpoly_ctx_struct*) = fmpz_mpoly_resultant;
};

/// \brief quotient = a / b. \throw Wrong_answer unless quotient * b = a. \pre b divides a.
void divide_exactly(Flint_polynomial& quotient, const Flint_polynomial& a, const Flint_polynomial& b,
                    const Flint_ring& ring, const Flint_functions& flint);

/// \brief Places modulo a prime at which polynomials are looked at: another one for each round.
///
/// The first rounds take 2^61 - 1, which no computation here uses; further ones other primes, too.
class Test_point
{
public:
  static constexpr int max_rounds = 64;

  explicit Test_point(int round);
  [[nodiscard]] const exact::Prime_field& field() const { return field_; }
  [[nodiscard]] exact::Prime_field::Element next(); ///< a coordinate

private:
  exact::Prime_field field_;
  std::uint64_t state_;
};

/// f as a polynomial in the variable `axis` modulo the prime, with `point` for the others (that of `axis` is not used).
[[nodiscard]] exact::Modular_polynomial image_on_line(const exact::Prime_field& field, const Flat_terms& f,
                                                      std::size_t axis,
                                                      const std::vector<exact::Prime_field::Element>& point);

[[nodiscard]] std::size_t degree(const Flat_terms& f, std::size_t axis);

/// \brief \throw Wrong_answer unless f and g are shown to have no common factor but constants. \pre Neither is zero.
void require_coprime(const Flat_terms& f, const Flat_terms& g);

/// \brief Whether f is shown to have no repeated factor but constants, by a number of looks. \pre f is not zero.
///
/// One look suffices but for rare chance if f has none.
[[nodiscard]] bool is_shown_square_free(const Flat_terms& f, int rounds);

/// \brief \throw Wrong_answer unless f is shown to have no repeated factor but constants. \pre f is not zero.
void require_square_free(const Flat_terms& f);

} // namespace corral::detail

#endif
