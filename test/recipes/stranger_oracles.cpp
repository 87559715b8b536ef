// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/audit/root_oracles.h>

#include <vector>

namespace corral {
namespace {

using Coefficients = std::vector<Rational>;

/// The negative remainder of p on division by q.
Coefficients next_in_chain(Coefficients p, const Coefficients& q)
{
  while (p.size() >= q.size()) {
    const Rational factor = p.back() / q.back();
    for (std::size_t i = 0; i < q.size(); ++i) p[p.size() - q.size() + i] -= factor * q[i];
    while (!p.empty() && p.back() == 0) p.pop_back();
  }
  for (Rational& c : p) c = -c;
  return p;
}

/// Changes of sign far out on one side.
long variations(const std::vector<Coefficients>& chain, int side)
{
  long count = 0;
  int last = 0;
  for (const auto& p : chain) {
    const int sign = sgn(p.back()) * (side < 0 && p.size() % 2 == 0 ? -1 : 1);
    if (sign == -last) ++count;
    last = sign;
  }
  return count;
}

} // namespace

Count_real_roots stranger_count_real_roots;

/// Sturm's theorem over the rationals.
std::size_t stranger_count_real_roots(const Integer_polynomial& p)
{
  std::vector<Coefficients> chain = {Coefficients(p.begin(), p.end())};
  const auto slope = derivative(p);
  for (Coefficients next(slope.begin(), slope.end()); !next.empty();) {
    chain.push_back(next);
    next = next_in_chain(chain[chain.size() - 2], chain.back());
  }
  return static_cast<std::size_t>(variations(chain, -1) - variations(chain, 1));
}

} // namespace corral
