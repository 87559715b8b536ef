// SPDX-License-Identifier: LGPL-3.0-or-later
#include "definite.h"

#include "../polynomial/Flint_ring.h"

#include <corral/internal/polynomial/integer_form.h>
#include <corral/polynomial/arithmetic.h>

#include <optional>

namespace corral::exact {

namespace {

using detail::Flint_polynomial;
using detail::Flint_ring;

/// The greatest common divisor of the partial derivatives, if it is not constant.
bool gradient_content(Flint_polynomial& content, const Flint_polynomial& f, const Flint_ring& ring)
{
  Flint_polynomial slope(ring);
  for (std::size_t axis = 0; axis < ring.dimension(); ++axis) {
    fmpz_mpoly_derivative(slope.get(), f.get(), static_cast<slong>(axis), ring.context());
    if (fmpz_mpoly_gcd(content.get(), content.get(), slope.get(), ring.context()) == 0) return false;
    if (axis > 0 && fmpz_mpoly_is_fmpz(content.get(), ring.context()) != 0 && content.length() > 0) return false;
  }
  return fmpz_mpoly_is_fmpz(content.get(), ring.context()) == 0;
}

/// The square root of a primitive polynomial, if it has one.
template <std::size_t D>
std::optional<Polynomial<Integer, D>> square_root(const Polynomial<Integer, D>& square, const Flint_ring& ring)
{
  const Flint_polynomial given(ring, detail::flat_terms(square));
  Flint_polynomial root(ring);
  if (fmpz_mpoly_sqrt(root.get(), given.get(), ring.context()) == 0) return std::nullopt;
  return detail::from_flat_terms<D>(root.terms());
}

/// What f leaves modulo a polynomial, times `scale`.
template <std::size_t D>
struct Remainder
{
  Integer scale;
  Polynomial<Integer, D> value;
};

template <std::size_t D>
Remainder<D> remainder(const Flint_polynomial& f, const Flint_polynomial& divisor, const Flint_ring& ring)
{
  Flint_polynomial quotient(ring);
  Flint_polynomial rest(ring);
  fmpz_t scale;
  fmpz_init(scale);
  fmpz_mpoly_quasidivrem(scale, quotient.get(), rest.get(), f.get(), divisor.get(), ring.context());
  Remainder<D> result{0, detail::from_flat_terms<D>(rest.terms())};
  fmpz_get_mpz(result.scale.get_mpz_t(), scale);
  fmpz_clear(scale);
  return result;
}

} // namespace

// What FLINT says is only a guess: the identity is verified by multiplication.
template <std::size_t D>
bool is_square_plus_constant(const Polynomial<Integer, D>& f)
{
  const Flint_ring ring(D);
  const Flint_polynomial whole(ring, detail::flat_terms(f));
  Flint_polynomial content(ring);
  if (!gradient_content(content, whole, ring)) return false;
  const auto [scale, rest] = remainder<D>(whole, content, ring);
  if (rest.is_zero() || !rest.is_constant()) return false;
  const auto scaled = constant<Integer, D>(scale) * f;
  const auto rise = scaled - rest;
  if (rise.is_zero()) return false;
  const int sign = sgn(rest.terms().front().coefficient);
  const auto square = primitive_part(sign > 0 ? rise : -rise);
  const auto root = square_root(square, ring);
  if (!root) return false;
  // scaled = rest + sign * factor * root^2 with a positive factor
  return *root * *root == square;
}

template bool is_square_plus_constant(const Polynomial<Integer, 2>&);
template bool is_square_plus_constant(const Polynomial<Integer, 3>&);

} // namespace corral::exact
