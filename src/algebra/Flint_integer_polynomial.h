// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_ALGEBRA_FLINT_INTEGER_POLYNOMIAL_H
#define CORRAL_SRC_ALGEBRA_FLINT_INTEGER_POLYNOMIAL_H

#include <corral/algebra/Integer_polynomial.h>

#include <cstddef>
#include <flint/fmpz_poly.h>
#include <utility>
#include <vector>

namespace corral::exact {

/// Owner of a FLINT polynomial in one variable over the integers.
class Flint_integer_polynomial
{
public:
  Flint_integer_polynomial() { fmpz_poly_init(value_); }
  explicit Flint_integer_polynomial(const Integer_polynomial& p) : Flint_integer_polynomial()
  {
    for (std::size_t i = p.size(); i-- > 0;) fmpz_poly_set_coeff_mpz(value_, static_cast<slong>(i), p[i].get_mpz_t());
  }
  Flint_integer_polynomial(const Flint_integer_polynomial&) = delete;
  Flint_integer_polynomial& operator=(const Flint_integer_polynomial&) = delete;
  ~Flint_integer_polynomial() { fmpz_poly_clear(value_); }

  [[nodiscard]] fmpz_poly_struct* get() { return value_; }
  [[nodiscard]] const fmpz_poly_struct* get() const { return value_; }
  [[nodiscard]] Integer_polynomial coefficients() const { return coefficients(value_); }
  [[nodiscard]] static Integer_polynomial coefficients(const fmpz_poly_struct* p)
  {
    std::vector<Integer> result(static_cast<std::size_t>(fmpz_poly_length(p)));
    for (std::size_t i = 0; i < result.size(); ++i)
      fmpz_poly_get_coeff_mpz(result[i].get_mpz_t(), p, static_cast<slong>(i));
    return Integer_polynomial(std::move(result));
  }

private:
  fmpz_poly_t value_;
};

} // namespace corral::exact

#endif
