// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/localization/localize.h>

#include <cstdint>
#include <iostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// \file
/// Prints what the fast engine says of some problems, a line each, so that two platforms can be compared bit for bit.
namespace {

using namespace corral;

class Problems
{
public:
  /// Full mantissas and small integers, dense and with few terms.
  template <std::size_t D>
  Polynomial<Rational, D> polynomial(unsigned degree)
  {
    const bool is_dense = below(2) == 0;
    std::vector<typename Polynomial<Rational, D>::Term> terms{{{}, coefficient()}};
    for (unsigned count = is_dense ? 12 * degree : 3 + degree; count > 0; --count) {
      Exponents<D> exponents{};
      for (unsigned rest = degree; auto& exponent : exponents) {
        exponent = static_cast<std::uint16_t>(below(rest + 1));
        rest -= exponent;
      }
      terms.push_back({exponents, coefficient()});
    }
    return collect<Rational, D>(std::move(terms));
  }
  template <std::size_t D>
  Grid<D> grid(std::uint32_t most)
  {
    Rational_box<D> box;
    Resolution<D> resolution;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const auto numerator = static_cast<long>(below(20));
      const auto denominator = static_cast<long>(7 + below(9));
      Rational lower(-numerator, denominator);
      lower.canonicalize();
      box[axis] = Rational_interval(lower, Rational(lower + Rational(1 + static_cast<long>(below(30)), 9)));
      resolution[axis] = 1 + below(most);
    }
    return Grid<D>(box, resolution);
  }

private:
  unsigned below(unsigned end) { return static_cast<unsigned>(numbers_() % end); }
  Rational coefficient()
  {
    if (below(3) == 0) return static_cast<long>(below(19)) - 9;
    const auto mantissa = static_cast<long>(numbers_() >> 11) - (1L << 52);
    Rational result(mantissa, 1L << 50);
    result.canonicalize();
    return result;
  }

  std::mt19937_64 numbers_{20261127};
};

/// The degrees are those of the polynomials of the system. What is drawn at random is drawn in a fixed order.
template <std::size_t D>
void print(Problems& problems, const std::vector<unsigned>& degrees, std::uint32_t most)
{
  std::vector<Polynomial<Rational, D>> system;
  for (const unsigned degree : degrees) system.push_back(problems.polynomial<D>(degree));
  const Grid<D> grid = problems.grid<D>(most);
  const auto found = system.size() == 1 ? localize(system[0], grid) : localize(system, grid);
  std::uint64_t hash = 14695981039346656037U; // FNV-1a of what is plotted
  const auto add = [&](std::uint64_t value) { hash = (hash ^ value) * 1099511628211U; };
  for (const auto& [cell, verdict] : found) {
    for (const auto index : cell) add(index);
    add(static_cast<std::uint64_t>(verdict));
  }
  std::cout << D << ' ' << system.size() << ' ' << found.plotted() << ' ' << found.hit() << ' ' << hash << '\n';
}

} // namespace

int main()
{
  Problems problems;
  for (int round = 0; round < 60; ++round) {
    const unsigned degree = 1 + static_cast<unsigned>(round) % 9;
    print<2>(problems, {degree}, 200);
    print<3>(problems, {1 + degree / 2}, 24);
    print<2>(problems, {degree, 2}, 100);
    print<3>(problems, {2, 1 + degree / 3}, 24);
  }
  print<2>(problems, {60}, 64); // few terms of high degree
}
