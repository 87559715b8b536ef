// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_LOCALIZATION_CORNER_JUDGE_H
#define CORRAL_TEST_LOCALIZATION_CORNER_JUDGE_H

#include "exact_cells.h"
#include "random_cases.h"

#include <corral/localization/Raster_builder.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// \file
/// Verdicts of whole grids confronted with the exact signs at all corners of cells.
namespace corral::test {

/// The exact signs of a polynomial at the points of a grid, and where it is zero but for a rounding error of doubles.
template <std::size_t D>
class Corner_signs
{
public:
  Corner_signs(const Polynomial<Rational, D>& f, const Grid<D>& grid)
  {
    std::vector<Rational> values;
    std::array<std::vector<std::vector<Rational>>, D> powers; // by axis, line and exponent
    for (std::size_t axis = 0; axis < D; ++axis) {
      points_[axis] = grid.resolution()[axis] + 1;
      for (std::uint32_t line = 0; line < points_[axis]; ++line) {
        auto& of_line = powers[axis].emplace_back(f.degree(axis) + std::size_t{1}, 1);
        for (std::size_t e = 1; e < of_line.size(); ++e) of_line[e] = of_line[e - 1] * grid.line(axis, line);
      }
    }
    Rational largest = 0;
    for_each_cell<D>(points_, [&](const Cell<D>& point) {
      Rational value = 0;
      for (const auto& term : f.terms()) {
        Rational product = term.coefficient;
        for (std::size_t axis = 0; axis < D; ++axis)
          if (const auto e = term.exponents[axis]; e > 0) product *= powers[axis][point[axis]][e];
        value += product;
      }
      if (abs(value) > largest) largest = abs(value);
      values.push_back(value);
    });
    mpq_div_2exp(largest.get_mpq_t(), largest.get_mpq_t(), 40);
    for (const auto& value : values) {
      signs_.push_back(static_cast<signed char>(sgn(value)));
      close_.push_back(abs(value) <= largest);
    }
  }

  [[nodiscard]] int sign(const Cell<D>& point) const { return signs_[index(point)]; }
  [[nodiscard]] bool is_close(const Cell<D>& point) const { return close_[index(point)]; }

private:
  [[nodiscard]] std::size_t index(const Cell<D>& point) const // as `for_each_cell` counts
  {
    std::size_t result = 0;
    for (std::size_t axis = D; axis-- > 0;) result = result * points_[axis] + point[axis];
    return result;
  }
  Resolution<D> points_;
  std::vector<signed char> signs_;
  std::vector<bool> close_;
};

/// What the corners of a cell say of the polynomials of a system.
struct Corner_facts
{
  bool is_close = false;    ///< to a zero, at some corner
  bool has_zero = false;    ///< certainly; of several polynomials: all of them at one corner
  bool has_one_sign = true; ///< at all corners
};

template <std::size_t D>
Corner_facts corner_facts(const std::vector<Corner_signs<D>>& system, const Cell<D>& cell)
{
  Corner_facts facts;
  bool positive = false;
  bool negative = false;
  for (unsigned side = 0; side < (1U << D); ++side) {
    Cell<D> corner = cell;
    for (std::size_t axis = 0; axis < D; ++axis) corner[axis] += side >> axis & 1;
    bool all_zero = true;
    for (const auto& signs : system) {
      all_zero = all_zero && signs.sign(corner) == 0;
      facts.is_close = facts.is_close || signs.is_close(corner);
    }
    facts.has_zero = facts.has_zero || all_zero;
    positive = positive || system.front().sign(corner) >= 0;
    negative = negative || system.front().sign(corner) <= 0;
  }
  if (system.size() == 1) facts.has_zero = facts.has_zero || (positive && negative);
  facts.has_one_sign = !facts.has_zero;
  return facts;
}

/// \brief The sign of f on a box if the sum of its terms over the box shows one, else 0. It suits a plane and few terms
/// of high degree, which `sign_by_bound` would expand.
template <std::size_t D>
int sign_by_terms(const Polynomial<Rational, D>& f, const Rational_box<D>& box)
{
  Rational_interval sum(0);
  for (const auto& term : f.terms()) {
    Rational_interval product(term.coefficient);
    for (std::size_t axis = 0; axis < D; ++axis)
      if (const auto e = term.exponents[axis]; e > 0) product *= power(box[axis], e);
    sum += product;
  }
  return sgn(sum.lower()) > 0 ? 1 : sgn(sum.upper()) < 0 ? -1 : 0;
}

/// What is found of some grids.
struct Judgement
{
  std::string wrong;         ///< the first false verdict
  std::uint64_t faults = 0;  ///< false verdicts
  std::uint64_t close = 0;   ///< proved verdicts of cells at a corner of which f is zero but for a rounding error
  std::uint64_t unknown = 0; ///< undecided cells of this kind
};

template <std::size_t D>
bool agrees(const Polynomial<Rational, D>& f, const Rational_box<D>& box, Verdict claimed)
{
  const bool is_sparse = 6 * f.terms().size() < std::size_t{f.total_degree()} * f.total_degree();
  const Verdict truth = is_sparse ? exact_verdict<D>(f, box, 3, sign_by_terms<D>) : exact_verdict<D>(f, box, 4);
  return truth == claimed || truth == Verdict::unknown;
}

/// Compares all verdicts with the signs at corners, and what these leave open with exact subdivision: every hit, and
/// each eighth cell that is empty although f is close to zero.
template <std::size_t D>
void judge(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid, const Raster<D>& cells,
           Judgement& judgement)
{
  std::vector<Corner_signs<D>> signs;
  for (const auto& f : system) signs.emplace_back(f, grid);
  const auto blame = [&](const Cell<D>& cell, const std::string& truth) {
    ++judgement.faults;
    if (!judgement.wrong.empty()) return;
    judgement.wrong = "cell";
    for (const auto index : cell) judgement.wrong += " " + std::to_string(index);
    judgement.wrong += " was called " + std::string(to_string(cells.verdict(cell))) + " and " + truth + " on";
    for (std::size_t axis = 0; axis < D; ++axis)
      judgement.wrong += " [" + to_string(grid.box()[axis].lower()) + ", " + to_string(grid.box()[axis].upper())
                         + "] at " + std::to_string(grid.resolution()[axis]);
    for (const auto& f : system) judgement.wrong += " for " + text_of(f);
  };
  for_each_cell<D>(grid.resolution(), [&](const Cell<D>& cell) {
    const auto facts = corner_facts(signs, cell);
    const Verdict verdict = cells.verdict(cell);
    if (facts.is_close) ++(verdict == Verdict::unknown ? judgement.unknown : judgement.close);
    if (facts.has_zero && verdict == Verdict::empty) blame(cell, "has a zero at a corner, or corners of both signs");
    if (facts.has_zero || system.size() > 1) return;
    const bool doubtful = verdict == Verdict::empty && facts.is_close && judgement.close % 8 == 0;
    if (verdict == Verdict::hit || doubtful)
      if (!agrees(system.front(), grid.cell_box(cell), verdict)) blame(cell, "is not");
  });
}

} // namespace corral::test

#endif
