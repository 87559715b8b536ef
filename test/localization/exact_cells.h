// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_LOCALIZATION_EXACT_CELLS_H
#define CORRAL_TEST_LOCALIZATION_EXACT_CELLS_H

#include <corral/internal/polynomial/integer_form.h>
#include <corral/localization/Raster_builder.h>
#include <corral/polynomial/arithmetic.h>
#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/print.h>
#include <corral/polynomial/substitution.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// \file
/// Exact facts about cells, slow and simple, to compare verdicts with.
namespace corral::test {

/// f in x, y, z.
template <std::size_t D>
std::string text_of(const Polynomial<Rational, D>& f)
{
  std::array<std::string, D> names;
  for (std::size_t axis = 0; axis < D; ++axis) names[axis] = std::string(1, "xyz"[axis]);
  return to_string(f, names);
}

/// f in the coordinates u of [-1, 1]^D of a box, exactly.
template <std::size_t D>
Polynomial<Rational, D> in_box_coordinates(const Polynomial<Rational, D>& f, const Rational_box<D>& box)
{
  std::array<Rational, D> centre;
  std::array<Rational, D> radius;
  for (std::size_t axis = 0; axis < D; ++axis) {
    centre[axis] = (box[axis].lower() + box[axis].upper()) / 2;
    radius[axis] = (box[axis].upper() - box[axis].lower()) / 2;
  }
  return affine_substitution(f, centre, radius);
}

/// The sign of f on the whole box if the modified affine bound shows one, else 0.
template <std::size_t D>
int sign_by_bound(const Polynomial<Rational, D>& f, const Rational_box<D>& box)
{
  Rational low = 0;
  Rational high = 0;
  const auto form = in_box_coordinates(f, box);
  for (const auto& term : form.terms()) {
    bool even = true;
    bool constant = true;
    for (const auto e : term.exponents) {
      even = even && e % 2 == 0;
      constant = constant && e == 0;
    }
    const Rational size = abs(term.coefficient);
    if (constant || !even || sgn(term.coefficient) > 0) high += constant ? term.coefficient : size;
    if (constant || !even || sgn(term.coefficient) < 0) low -= constant ? Rational(-term.coefficient) : size;
  }
  return sgn(low) > 0 ? 1 : sgn(high) < 0 ? -1 : 0;
}

/// \brief What is true of a closed cell: `empty` or `hit` if subdividing it `depth` times shows it, else `unknown`.
/// \param bound  the sign of f on a box if it has one there and that is seen, else 0.
template <std::size_t D>
Verdict exact_verdict(const Polynomial<Rational, D>& f, const Rational_box<D>& box, int depth,
                      int (*bound)(const Polynomial<Rational, D>&, const Rational_box<D>&) = sign_by_bound<D>)
{
  if (bound(f, box) != 0) return Verdict::empty;
  bool positive = false;
  bool negative = false;
  for (unsigned corner = 0; corner < (1U << D); ++corner) {
    std::array<Rational, D> point;
    for (std::size_t axis = 0; axis < D; ++axis)
      point[axis] = (corner >> axis & 1) != 0 ? box[axis].upper() : box[axis].lower();
    const int sign = sgn(evaluate(f, point));
    positive = positive || sign >= 0;
    negative = negative || sign <= 0;
  }
  if (positive && negative) return Verdict::hit;
  if (depth == 0) return Verdict::unknown;
  bool all_empty = true;
  for (unsigned part = 0; part < (1U << D); ++part) {
    auto half = box;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const Rational middle = (box[axis].lower() + box[axis].upper()) / 2;
      half[axis] = (part >> axis & 1) != 0 ? Rational_interval(middle, box[axis].upper())
                                           : Rational_interval(box[axis].lower(), middle);
    }
    const Verdict verdict = exact_verdict(f, half, depth - 1, bound);
    if (verdict == Verdict::hit) return Verdict::hit;
    all_empty = all_empty && verdict == Verdict::empty;
  }
  return all_empty ? Verdict::empty : Verdict::unknown;
}

/// "" if the claim agrees with the truth, else a description of the case.
template <std::size_t D>
std::string contradiction(const Polynomial<Rational, D>& f, const Grid<D>& grid, const Cell<D>& cell, Verdict claimed)
{
  if (claimed == Verdict::unknown) return "";
  const auto box = grid.cell_box(cell);
  const Verdict truth = exact_verdict(f, box, 4);
  if (truth == claimed || truth == Verdict::unknown) return "";
  std::string text = "cell";
  for (std::size_t axis = 0; axis < D; ++axis)
    text += " [" + to_string(box[axis].lower()) + ", " + to_string(box[axis].upper()) + "]";
  return text + " was called " + std::string(to_string(claimed)) + " and is " + std::string(to_string(truth))
         + " for f = " + text_of(f);
}

/// The cells of one axis that hold a coordinate: two if it is a grid line.
template <std::size_t D>
std::vector<std::uint32_t> cells_at(const Grid<D>& grid, std::size_t axis, const Rational& coordinate)
{
  const Rational place = (coordinate - grid.box()[axis].lower()) / grid.step(axis);
  const auto floor = static_cast<std::uint32_t>(Integer(place.get_num() / place.get_den()).get_ui());
  std::vector<std::uint32_t> result;
  if (floor > 0 && place == floor) result.push_back(floor - 1);
  if (floor < grid.resolution()[axis]) result.push_back(floor);
  return result;
}

/// How many of the cells that hold a point of the box the set lacks.
template <std::size_t D>
std::size_t lost_cells(const Raster<D>& cells, const Grid<D>& grid, const std::array<Rational, D>& point)
{
  std::vector<Cell<D>> with_point{{}};
  for (std::size_t axis = 0; axis < D; ++axis) {
    std::vector<Cell<D>> longer;
    for (Cell<D> cell : with_point)
      for (const auto index : cells_at(grid, axis, point[axis])) {
        cell[axis] = index;
        longer.push_back(cell);
      }
    with_point = std::move(longer);
  }
  std::size_t lost = 0;
  for (const auto& cell : with_point) lost += cells.verdict(cell) == Verdict::empty ? 1U : 0U;
  return lost;
}

/// The exact signs of f at all grid points of a plane, rows of constant y, from integer differences.
class Grid_signs
{
public:
  Grid_signs(const Polynomial<Rational, 2>& f, const Grid<2>& grid) : width_(grid.resolution()[0] + std::size_t{1})
  {
    const std::array<Rational, 2> origin{grid.box()[0].lower(), grid.box()[1].lower()};
    const auto form = integer_form(affine_substitution(f, origin, {grid.step(0), grid.step(1)})).numerator;
    for (std::uint32_t y = 0; y <= grid.resolution()[1]; ++y) append_row(form, y);
  }
  [[nodiscard]] int at(std::uint32_t x, std::uint32_t y) const { return signs_[y * width_ + x]; }

private:
  void append_row(const Polynomial<Integer, 2>& form, std::uint32_t y)
  {
    std::vector<Integer> difference; // difference[k]: k-th forward difference at the current x
    for (unsigned k = 0; k <= form.degree(0); ++k) difference.push_back(evaluate<Integer, 2>(form, {k, y}));
    for (std::size_t order = 1; order < difference.size(); ++order)
      for (std::size_t k = difference.size(); k-- > order;) difference[k] -= difference[k - 1];
    for (std::size_t x = 0; x < width_; ++x) {
      signs_.push_back(static_cast<signed char>(sgn(difference[0])));
      for (std::size_t k = 0; k + 1 < difference.size(); ++k) difference[k] += difference[k + 1];
    }
  }
  std::size_t width_;
  std::vector<signed char> signs_;
};

} // namespace corral::test

#endif
