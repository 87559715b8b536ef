// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Monomial_shape.h"

#include <corral/errors.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace corral::fast {

namespace {

constexpr std::uint32_t absent = 0xffffffffU;

template <std::size_t D>
unsigned total(const Exponents<D>& exponents)
{
  return std::accumulate(exponents.begin(), exponents.end(), 0U);
}

template <std::size_t D>
bool is_even(const Exponents<D>& exponents)
{
  return std::all_of(exponents.begin(), exponents.end(), [](auto e) { return e % 2 == 0; });
}

template <std::size_t D>
std::vector<Exponents<D>> exponents_of(const Polynomial<Rational, D>& f)
{
  std::vector<Exponents<D>> result;
  for (const auto& term : f.terms()) result.push_back(term.exponents);
  return result;
}

/// Where the engine may cut the degree: every degree while that is cheap, then in steps.
std::vector<unsigned> class_degrees(unsigned degree)
{
  std::vector<unsigned> result{degree};
  for (unsigned d = degree; d > 1;) {
    d = d <= 8 ? d - 1 : d <= 16 ? std::max(8U, d - 2) : d - std::max(3U, d / 8);
    result.push_back(d);
  }
  return result;
}

/// The lines without the positions from `size` on, which come last in each line.
template <std::size_t D>
typename Monomial_shape<D>::Lines shortened(const typename Monomial_shape<D>::Lines& lines, std::size_t size)
{
  typename Monomial_shape<D>::Lines result;
  result.lines.reserve(lines.lines.size());
  result.index.reserve(size);
  for (const auto& line : lines.lines) {
    const auto first = static_cast<std::uint32_t>(result.index.size());
    for (std::uint32_t k = 0; k <= line.degree && lines.index[line.first + k] < size; ++k)
      result.index.push_back(lines.index[line.first + k]);
    if (result.index.size() > first)
      result.lines.push_back({first, static_cast<std::uint32_t>(result.index.size() - first - 1), line.rest});
  }
  return result;
}

} // namespace

template <std::size_t D>
Monomial_shape<D>::Monomial_shape(const Polynomial<Rational, D>& f) : Monomial_shape(exponents_of(f))
{}

template <std::size_t D>
Monomial_shape<D>::Monomial_shape(const std::vector<Exponents<D>>& monomials)
{
  collect_divisors(monomials);
  const auto degrees = class_degrees(degree());
  classes_.reserve(degrees.size());
  for (const unsigned d : degrees) {
    classes_.push_back({d, degree_end_[d], {}, {}});
    Class& cut = classes_.back();
    for (std::size_t axis = 0; axis < D; ++axis)
      cut.lines[axis] = d == degree() ? lines_of(axis) : shortened<D>(classes_.front().lines[axis], cut.size);
    cut.slab.reserve(extent_[D - 1] + 1);
    const auto& lines = cut.lines[D - 2].lines;
    for (std::uint32_t k = 0; k < lines.size(); ++k)
      if (k == 0 || lines[k].rest[D - 1] != lines[k - 1].rest[D - 1]) cut.slab.push_back(k);
    cut.slab.push_back(static_cast<std::uint32_t>(lines.size()));
  }
}

template <std::size_t D>
std::size_t Monomial_shape<D>::pure_power(std::size_t axis, unsigned power) const
{
  if (power >= extent_[axis]) return size();
  Exponents<D> exponents{};
  exponents[axis] = static_cast<std::uint16_t>(power);
  return position(exponents); // a divisor of the monomial that has the highest exponent of this axis
}

template <std::size_t D>
void Monomial_shape<D>::collect_divisors(const std::vector<Exponents<D>>& monomials)
{
  constexpr std::size_t max_dense = 16 * max_size;
  std::size_t cells = 1;
  for (std::size_t axis = 0; axis < D; ++axis) {
    for (const auto& exponents : monomials) extent_[axis] = std::max(extent_[axis], exponents[axis] + std::size_t{1});
    if (cells > max_dense / extent_[axis])
      throw Budget_exceeded("localize_fast: the degrees of the polynomial multiply to more than "
                            + std::to_string(max_dense) + " monomials");
    cells *= extent_[axis];
  }
  position_.assign(cells, absent);
  for (const auto& exponents : monomials) position_[dense(exponents)] = 0;
  for (std::size_t axis = 0, stride = cells; axis < D; ++axis) {
    const std::size_t block = stride;
    stride /= extent_[axis];
    for (std::size_t cell = cells; cell-- > 0;)
      if (position_[cell] == 0 && cell % block >= stride) position_[cell - stride] = 0;
  }
  for (std::size_t cell = 0; cell < cells; ++cell)
    if (position_[cell] == 0) {
      Exponents<D> exponents;
      std::size_t rest = cell;
      for (std::size_t axis = D; axis-- > 0; rest /= extent_[axis])
        exponents[axis] = static_cast<std::uint16_t>(rest % extent_[axis]);
      exponents_.push_back(exponents);
    }
  if (exponents_.size() > max_size)
    throw Budget_exceeded("localize_fast: the polynomial needs " + std::to_string(exponents_.size())
                          + " coefficients; at most " + std::to_string(max_size) + " are supported");
  std::stable_sort(exponents_.begin(), exponents_.end(), [](const auto& a, const auto& b) {
    const unsigned da = total<D>(a);
    const unsigned db = total<D>(b);
    return da != db ? da < db : is_even<D>(a) > is_even<D>(b);
  });
  degree_end_.assign(total<D>(exponents_.back()) + 1, 0);
  even_end_ = degree_end_;
  for (std::size_t k = 0; k < exponents_.size(); ++k) {
    position_[dense(exponents_[k])] = static_cast<std::uint32_t>(k);
    const unsigned d = total<D>(exponents_[k]);
    if (degree_end_[d] == 0) even_end_[d] = k;
    degree_end_[d] = k + 1;
    if (is_even<D>(exponents_[k])) even_end_[d] = k + 1;
  }
}

template <std::size_t D>
auto Monomial_shape<D>::lines_of(std::size_t axis) const -> Lines
{
  Lines result;
  std::vector<Exponents<D>> rests;
  for (const auto& exponents : exponents_)
    if (exponents[axis] == 0) rests.push_back(exponents);
  std::sort(rests.begin(), rests.end(), [](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
  });
  result.lines.reserve(rests.size());
  result.index.reserve(size());
  for (const auto& rest : rests) {
    const auto first = static_cast<std::uint32_t>(result.index.size());
    auto monomial = rest;
    for (; monomial[axis] < extent_[axis] && position(monomial) != absent; ++monomial[axis])
      result.index.push_back(static_cast<std::uint32_t>(position(monomial)));
    result.lines.push_back({first, static_cast<std::uint32_t>(result.index.size() - first - 1), rest});
  }
  return result;
}

template class Monomial_shape<2>;
template class Monomial_shape<3>;

} // namespace corral::fast
