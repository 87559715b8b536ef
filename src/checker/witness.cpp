// SPDX-License-Identifier: LGPL-3.0-or-later
#include "witness.h"

#include "bernstein.h"

#include <algorithm>

namespace corral_check {
namespace {

/// One witness on its way through the checks.
struct Case
{
  const Certificate& certificate;
  const Box& cell;
  const std::string& where;
  Budget& budget;

  [[nodiscard]] std::int64_t dimension() const { return static_cast<std::int64_t>(cell.size()); }
  void require(bool condition, const char* why) const { corral_check::require(condition, where, why); }
};

/// From the cell's own coordinate u in [0, 1] to x.
mpq_class to_space(const mpq_class& u, const Side& side) { return side.lower + u * (side.upper - side.lower); }

void check_points(const Json& points, const Case& c)
{
  c.require(points.is_array() && (points.size() == 1 || points.size() == 2), "expected one or two points");
  c.require(points.size() == 1 || c.certificate.reduced.size() == 1, "two points prove nothing of several polynomials");
  std::vector<int> signs;
  for (const Json& entry : points) {
    list(entry, c.dimension(), c.where);
    Point point;
    for (std::size_t axis = 0; axis < c.cell.size(); ++axis) {
      const mpq_class u = exact(entry[axis], c.where);
      c.require(u >= 0 && u <= 1, "a point is outside the cell");
      point.push_back(to_space(u, c.cell[axis]));
    }
    for (const Polynomial& g : c.certificate.reduced) signs.push_back(sgn(evaluate(g, point, c.budget)));
  }
  if (points.size() == 1)
    c.require(std::all_of(signs.begin(), signs.end(), [](int sign) { return sign == 0; }), "the point is not a zero");
  else
    c.require(signs[0] * signs[1] < 0, "the two points do not have opposite signs");
}

Box read_box(const Json& value, const Case& c)
{
  Box box;
  for (const Json& side : list(value, c.dimension(), c.where)) {
    list(side, 2, c.where);
    box.push_back({exact(side[0], c.where), exact(side[1], c.where)});
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

std::vector<std::size_t> read_order(const Json& value, const Case& c)
{
  std::vector<std::size_t> order;
  for (const Json& entry : list(value, c.dimension(), c.where))
    order.push_back(number(entry, 0, c.cell.size() - 1, c.where + " order"));
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

void check_triangular(const Json& value, const Case& c)
{
  require_keys(value, {"order", "chain", "box"}, c.where);
  const std::vector<std::size_t> order = read_order(value["order"], c);
  const Box box = read_box(value["box"], c);
  for (std::size_t axis = 0; axis < box.size(); ++axis)
    c.require(c.cell[axis].lower <= box[axis].lower && box[axis].upper <= c.cell[axis].upper,
              "the box is not inside the cell");
  std::vector<Polynomial> chain;
  for (const Json& entry : list(value["chain"], c.dimension(), c.where))
    chain.push_back(read_polynomial(entry, c.cell.size(), c.where));
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
  for (Polynomial g : c.certificate.reduced) {
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

void check_miranda(const Json& value, const Case& c)
{
  require_keys(value, {"box", "matrix"}, c.where);
  const std::size_t m = c.certificate.reduced.size();
  Box box = read_box(value["box"], c);
  std::vector<std::size_t> axes;
  for (std::size_t axis = 0; axis < box.size(); ++axis) {
    c.require(box[axis].lower >= 0 && box[axis].upper <= 1, "the box is not inside the cell");
    box[axis] = {to_space(box[axis].lower, c.cell[axis]), to_space(box[axis].upper, c.cell[axis])};
    if (!box[axis].is_flat()) axes.push_back(axis);
  }
  c.require(axes.size() == m, "the box does not have as many sides as there are polynomials");
  std::vector<std::vector<mpq_class>> matrix;
  for (const Json& row : list(value["matrix"], static_cast<std::int64_t>(m), c.where)) {
    matrix.emplace_back();
    for (const Json& entry : list(row, static_cast<std::int64_t>(m), c.where))
      matrix.back().push_back(exact(entry, c.where));
  }
  c.require(is_regular(matrix), "the matrix is singular");
  for (std::size_t r = 0; r < m; ++r) {
    Polynomial g;
    for (std::size_t j = 0; j < m; ++j)
      if (matrix[r][j] != 0) add_multiple(g, c.certificate.reduced[j], matrix[r][j], Exponents{}, c.budget);
    c.require(changes_sign_along(g, axes[r], box, c.budget), "no change of sign between opposite facets");
  }
}

} // namespace

void check_witness(const Json& witness, const Certificate& certificate, const Box& cell, const std::string& where,
                   Budget& budget)
{
  const Case c{certificate, cell, where, budget};
  c.require(witness.is_object() && witness.size() == 1, "a witness is an object with one key");
  const std::string& kind = witness.begin().key();
  const Json& value = witness.begin().value();
  if (kind == "points") return check_points(value, c);
  if (kind == "triangular") return check_triangular(value, c);
  if (kind == "miranda") return check_miranda(value, c);
  reject(where, "an unknown kind of witness");
}

} // namespace corral_check
