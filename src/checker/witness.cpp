// SPDX-License-Identifier: LGPL-3.0-or-later
#include "witness.h"

#include "bernstein.h"

#include <algorithm>
#include <span>

namespace corral_check {
namespace {

/// One witness on its way through the checks.
struct Case
{
  const Contents& contents;
  const Box& cell;
  const Place& place;
  Budget& budget;

  [[nodiscard]] std::int64_t dimension() const { return static_cast<std::int64_t>(cell.size()); }
  [[nodiscard]] std::span<const Polynomial> polynomials() const
  {
    return std::span(contents.proved).first(contents.given);
  }
  void require(bool condition, const char* why) const { corral_check::require(condition, place, why); }
};

/// From the cell's own coordinate u in [0, 1] to x.
mpq_class to_space(const mpq_class& u, const Side& side) { return side.lower + u * (side.upper - side.lower); }

void check_points(const Value& value, const Case& c)
{
  const auto points = value.list(-1, c.place.words);
  c.require(points.size() == 1 || points.size() == 2, "expected one or two points");
  c.require(points.size() == 1 || c.contents.given == 1, "two points prove nothing of several polynomials");
  std::vector<int> signs;
  for (const Value& entry : points) {
    Point point;
    for (const Value& coordinate : entry.list(c.dimension(), c.place.words)) {
      const mpq_class u = coordinate.exact(c.place.words);
      c.require(u >= 0 && u <= 1, "a point is outside the cell");
      point.push_back(to_space(u, c.cell[point.size()]));
    }
    for (const Polynomial& g : c.polynomials()) signs.push_back(sgn(evaluate(g, point, c.budget)));
  }
  if (points.size() == 1)
    c.require(std::all_of(signs.begin(), signs.end(), [](int sign) { return sign == 0; }), "the point is not a zero");
  else
    c.require(signs[0] * signs[1] < 0, "the two points do not have opposite signs");
}

Box read_box(const Value& value, const Case& c)
{
  Box box;
  for (const Value& side : value.list(c.dimension(), c.place.words)) {
    const auto ends = side.list(2, c.place.words);
    box.push_back({ends[0].exact(c.place.words), ends[1].exact(c.place.words)});
    c.require(box.back().lower <= box.back().upper, "a side of the box is empty");
  }
  return box;
}

/// Whether g has one strict sign on one facet of the axis and the opposite one on the other.
bool changes_sign_along(const Polynomial& g, std::size_t axis, const Box& box, Budget& budget)
{
  Box lower = box;
  Box upper = box;
  lower[axis].upper = box[axis].lower;
  upper[axis].lower = box[axis].upper;
  return strict_sign(g, lower, budget) * strict_sign(g, upper, budget) < 0;
}

std::vector<std::size_t> read_order(const Value& value, const Case& c)
{
  std::vector<std::size_t> order;
  for (const Value& entry : value.list(c.dimension(), c.place.words))
    order.push_back(entry.number(0, c.cell.size() - 1, c.place.words + " order"));
  std::vector<std::size_t> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  c.require(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end(), "an axis is twice in the order");
  return order;
}

/// Condition 1: only the variables of the first axes of the order, and monic in that of the last one.
void require_monic(const Polynomial& t, const std::vector<std::size_t>& order, std::size_t last, const Case& c)
{
  const Exponents highest = degrees(t);
  for (std::size_t later = last + 1; later < order.size(); ++later)
    c.require(highest[order[later]] == 0, "the chain is not triangular");
  Exponents lead{};
  lead[order[last]] = highest[order[last]];
  c.require(lead[order[last]] > 0, "an element of the chain lacks its variable");
  for (const auto& [exponents, coefficient] : t)
    if (exponents[order[last]] == lead[order[last]])
      c.require(exponents == lead && coefficient == 1, "an element of the chain is not monic");
}

void check_triangular(const Value& value, const Case& c)
{
  const auto fields = value.fields({"order", "chain", "box"}, c.place.words);
  const std::vector<std::size_t> order = read_order(fields[0], c);
  const Box box = read_box(fields[2], c);
  for (std::size_t axis = 0; axis < box.size(); ++axis)
    c.require(c.cell[axis].lower <= box[axis].lower && box[axis].upper <= c.cell[axis].upper,
              "the box is not inside the cell");
  std::vector<Polynomial> chain;
  for (const Value& entry : fields[1].list(c.dimension(), c.place.words))
    chain.push_back(read_polynomial(entry, c.cell.size(), c.place.words));
  for (std::size_t r = 0; r < order.size(); ++r) {
    require_monic(chain[r], order, r, c);
    const Side& side = box[order[r]];
    if (!side.is_flat()) {
      c.require(changes_sign_along(chain[r], order[r], box, c.budget), "the chain does not change sign over the box");
      continue;
    }
    Exponents variable{};
    variable[order[r]] = 1;
    Polynomial expected{{variable, 1}};
    if (side.lower != 0) expected[Exponents{}] = -side.lower;
    c.require(chain[r] == expected, "an element of the chain does not fix its coordinate");
  }
  for (Polynomial g : c.polynomials()) {
    for (std::size_t r = order.size(); r-- > 0;) g = remainder(std::move(g), chain[r], order[r], c.budget);
    c.require(g.empty(), "a polynomial does not reduce to zero by the chain");
  }
}

/// Whether the determinant is not 0, by elimination.
bool is_regular(std::vector<std::vector<mpq_class>> rows)
{
  for (std::size_t column = 0; column < rows.size(); ++column) {
    std::size_t pivot = column;
    while (pivot < rows.size() && rows[pivot][column] == 0) ++pivot;
    if (pivot == rows.size()) return false;
    std::swap(rows[pivot], rows[column]);
    for (std::size_t row = column + 1; row < rows.size(); ++row) {
      const mpq_class factor = rows[row][column] / rows[column][column];
      for (std::size_t k = column; k < rows.size(); ++k) rows[row][k] -= factor * rows[column][k];
    }
  }
  return true;
}

std::vector<std::vector<mpq_class>> read_matrix(const Value& value, const Case& c)
{
  const auto m = static_cast<std::int64_t>(c.contents.given);
  std::vector<std::vector<mpq_class>> matrix;
  double word_count = 0;
  for (const Value& row : value.list(m, c.place.words)) {
    matrix.emplace_back();
    for (const Value& entry : row.list(m, c.place.words)) {
      matrix.back().push_back(entry.exact(c.place.words));
      word_count += length(matrix.back().back());
    }
  }
  for (std::int64_t step = 0; step < m * m * m; ++step) c.budget.fractions(word_count);
  return matrix;
}

void check_miranda(const Value& value, const Case& c)
{
  const auto fields = value.fields({"box", "matrix"}, c.place.words);
  Box box = read_box(fields[0], c);
  std::vector<std::size_t> axes;
  for (std::size_t axis = 0; axis < box.size(); ++axis) {
    c.require(box[axis].lower >= 0 && box[axis].upper <= 1, "the box is not inside the cell");
    box[axis] = {to_space(box[axis].lower, c.cell[axis]), to_space(box[axis].upper, c.cell[axis])};
    if (!box[axis].is_flat()) axes.push_back(axis);
  }
  c.require(axes.size() == c.contents.given, "the box does not have as many sides as there are polynomials");
  const auto matrix = read_matrix(fields[1], c);
  c.require(is_regular(matrix), "the matrix is singular");
  for (std::size_t r = 0; r < axes.size(); ++r) {
    Sum sum(c.budget);
    for (std::size_t j = 0; j < axes.size(); ++j)
      if (matrix[r][j] != 0) sum.add(c.polynomials()[j], matrix[r][j], Exponents{});
    c.require(changes_sign_along(sum.value(), axes[r], box, c.budget), "no change of sign between opposite facets");
  }
}

} // namespace

void check_witness(const Value& witness, const Contents& contents, const Box& cell, const std::string& where,
                   Budget& budget)
{
  const Place place = witness.place(where);
  const Case c{contents, cell, place, budget};
  const auto [kind, value] = witness.only_field(where);
  if (kind == "points") return check_points(value, c);
  if (kind == "triangular") return check_triangular(value, c);
  if (kind == "miranda") return check_miranda(value, c);
  reject(place, "an unknown kind of witness");
}

} // namespace corral_check
