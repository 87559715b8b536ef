// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/polynomial/substitution.h>

namespace corral::detail {

namespace {

std::vector<Integer> powers(const Integer& x, unsigned highest)
{
  std::vector<Integer> result(highest + 1, 1);
  for (unsigned k = 1; k <= highest; ++k) result[k] = result[k - 1] * x;
  return result;
}

} // namespace

// With offset p/q and scale a/b q in lowest terms, G(v) = q^n f(v/q) has integer coefficients
// c_k q^(n-k). Its Taylor coefficients T_k at p give f(p/q + scale u) = sum T_k (a/b)^k u^k / q^n,
// because v = p + q scale u.
Line_substitution::Line_substitution(const Rational& offset, const Rational& scale, unsigned degree)
    : offset_(offset.get_num()), offset_denominator_powers_(powers(offset.get_den(), degree))
{
  const Rational step = scale * offset.get_den();
  factors_ = powers(step.get_num(), degree);
  const auto divisors = powers(step.get_den(), degree);
  for (unsigned k = 0; k <= degree; ++k) factors_[k] *= divisors[degree - k];
}

Integer Line_substitution::denominator() const
{
  return offset_denominator_powers_.back() * factors_.front(); // q^n b^n
}

void Line_substitution::apply(std::vector<Integer>& coefficients) const
{
  CORRAL_PRECONDITION(coefficients.size() == factors_.size(), "Line_substitution: expected degree + 1 coefficients");
  std::size_t size = coefficients.size();
  const std::size_t degree = size - 1;
  while (size > 0 && coefficients[size - 1] == 0) --size;
  for (std::size_t k = 0; k < size; ++k)
    if (coefficients[k] != 0) coefficients[k] *= offset_denominator_powers_[degree - k];
  if (offset_ != 0)
    for (std::size_t first = 0; first + 1 < size; ++first)
      for (std::size_t k = size - 1; k-- > first;)
        mpz_addmul(coefficients[k].get_mpz_t(), coefficients[k + 1].get_mpz_t(), offset_.get_mpz_t());
  for (std::size_t k = 0; k < size; ++k)
    if (coefficients[k] != 0) coefficients[k] *= factors_[k];
}

} // namespace corral::detail
