// SPDX-License-Identifier: LGPL-3.0-or-later
// The only test of geometry that includes CGAL's algebraic kernel: it takes more than a minute to compile.
#define CGAL_USE_MPFI 1

#include "cgal_topology.h"

#include <CGAL/Algebraic_kernel_d_1.h>
#include <CGAL/Algebraic_kernel_d_2.h>
#include <CGAL/Gmpz.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace corral::test {

namespace {

using Kernel_1 = CGAL::Algebraic_kernel_d_1<CGAL::Gmpz>;
using Kernel_2 = CGAL::Algebraic_kernel_d_2<CGAL::Gmpz>;
using Curve = Kernel_2::Curve_analysis_2;
using Line = Curve::Status_line_1;

Curve analysis(const Polynomial<Integer, 2>& f, std::size_t first)
{
  std::vector<std::pair<CGAL::Exponent_vector, CGAL::Gmpz>> terms;
  for (const auto& term : f.terms())
    terms.emplace_back(CGAL::Exponent_vector(int{term.exponents[first]}, int{term.exponents[1 - first]}),
                       CGAL::Gmpz(term.coefficient.get_mpz_t()));
  const auto polynomial =
      CGAL::Polynomial_traits_d<Kernel_2::Polynomial_2>::Construct_polynomial()(terms.begin(), terms.end());
  return Kernel_2().construct_curve_2_object()(polynomial);
}

/// Points, arcs and vertical lines that hang together.
class Pieces
{
public:
  std::size_t add()
  {
    parent_.push_back(parent_.size());
    unbounded_.push_back(false);
    return parent_.size() - 1;
  }
  void unite(std::size_t a, std::size_t b)
  {
    a = find(a);
    b = find(b);
    parent_[a] = b;
    unbounded_[b] = unbounded_[a] || unbounded_[b];
  }
  /// Another end of the piece lies at infinity.
  void mark_unbounded(std::size_t piece)
  {
    unbounded_[find(piece)] = true;
    ++ends_;
  }
  void count(Plane_topology& topology)
  {
    topology.ends = ends_;
    topology.euler += static_cast<long>(ends_);
    for (std::size_t piece = 0; piece < parent_.size(); ++piece)
      if (find(piece) == piece) {
        ++topology.components;
        topology.closed += unbounded_[piece] ? 0 : 1;
      }
  }

private:
  std::size_t find(std::size_t piece)
  {
    while (parent_[piece] != piece) piece = parent_[piece] = parent_[parent_[piece]];
    return piece;
  }

  std::vector<std::size_t> parent_;
  std::vector<bool> unbounded_;
  std::size_t ends_ = 0;
};

/// One side, left or right, of a line with events: which arc ends where.
class Arcs_at_line
{
public:
  Arcs_at_line(Pieces& pieces, const std::vector<std::size_t>& arcs, int from_below, int to_above)
      : pieces_(pieces), arcs_(arcs), next_(static_cast<std::size_t>(from_below))
  {
    for (std::size_t k = 0; k < next_; ++k) pieces.mark_unbounded(arcs[k]);
    for (std::size_t k = arcs.size() - static_cast<std::size_t>(to_above); k < arcs.size(); ++k)
      pieces.mark_unbounded(arcs[k]);
  }
  void end_at(std::size_t point, int count)
  {
    for (int k = 0; k < count; ++k) pieces_.unite(arcs_[next_++], point);
  }

private:
  Pieces& pieces_;
  const std::vector<std::size_t>& arcs_;
  std::size_t next_;
};

void join(Pieces& pieces, const Line& line, const std::vector<std::size_t>& left, const std::vector<std::size_t>& right,
          Plane_topology& topology)
{
  const auto below = line.number_of_branches_approaching_minus_infinity();
  const auto above = line.number_of_branches_approaching_plus_infinity();
  Arcs_at_line from_left(pieces, left, static_cast<int>(below.first), static_cast<int>(above.first));
  Arcs_at_line to_right(pieces, right, static_cast<int>(below.second), static_cast<int>(above.second));
  std::size_t vertical = 0;
  if (line.covers_line()) {
    vertical = pieces.add();
    for (int end = 0; end < 2; ++end) pieces.mark_unbounded(vertical);
    topology.euler -= static_cast<long>(line.number_of_events()) + 1;
  }
  for (int j = 0; j < line.number_of_events(); ++j) {
    const auto [arcs_left, arcs_right] = line.number_of_incident_branches(j);
    const std::size_t point = pieces.add();
    ++topology.euler;
    from_left.end_at(point, static_cast<int>(arcs_left));
    to_right.end_at(point, static_cast<int>(arcs_right));
    if (line.covers_line())
      pieces.unite(point, vertical);
    else if (arcs_left + arcs_right == 0)
      ++topology.isolated;
  }
}

/// The largest absolute value of real numbers, rounded up.
template <class Reals>
Integer above_all(const Reals& reals)
{
  Integer result = 0;
  for (const auto& x : reals)
    for (const auto& bound : {x.low(), x.high()}) {
      const Rational value(bound.mpq());
      result = std::max(result, Integer(abs(value.get_num()) / value.get_den() + 1));
    }
  return result;
}

Integer reach_of_events(const Curve& curve)
{
  std::vector<Kernel_1::Algebraic_real_1> events;
  for (int i = 0; i < curve.number_of_status_lines_with_event(); ++i)
    events.push_back(curve.status_line_at_event(i).x());
  return above_all(events);
}

/// Where f(t, sign t) vanishes. \pre not everywhere, or that is no matter.
Integer reach_on_diagonal(const Polynomial<Integer, 2>& f, int sign)
{
  std::vector<CGAL::Gmpz> coefficients(f.total_degree() + 1U);
  for (const auto& term : f.terms()) {
    const Integer c = sign < 0 && term.exponents[1] % 2 == 1 ? Integer(-term.coefficient) : term.coefficient;
    coefficients[term.exponents[0] + std::size_t{term.exponents[1]}] += CGAL::Gmpz(c.get_mpz_t());
  }
  while (!coefficients.empty() && coefficients.back() == 0) coefficients.pop_back();
  std::vector<Kernel_1::Algebraic_real_1> roots;
  if (coefficients.size() > 1) {
    const Kernel_1 kernel;
    const auto p = kernel.make_square_free_1_object()(Kernel_1::Polynomial_1(coefficients.begin(), coefficients.end()));
    kernel.solve_1_object()(p, true, std::back_inserter(roots));
  }
  return above_all(roots);
}

} // namespace

std::string to_string(const Plane_topology& topology)
{
  return std::to_string(topology.components) + " components, " + std::to_string(topology.closed) + " closed, "
         + std::to_string(topology.isolated) + " isolated points, " + std::to_string(topology.ends)
         + " ends, Euler characteristic " + std::to_string(topology.euler);
}

Plane_topology cgal_topology(const Polynomial<Integer, 2>& f)
{
  const Curve curve = analysis(f, 0);
  const int events = static_cast<int>(curve.number_of_status_lines_with_event());
  Plane_topology topology;
  Pieces pieces;
  std::vector<std::size_t> left;
  for (int i = 0; i <= events; ++i) {
    std::vector<std::size_t> right;
    const auto arcs = curve.status_line_of_interval(i).number_of_events();
    for (int k = 0; k < static_cast<int>(arcs); ++k) {
      right.push_back(pieces.add());
      if (i == 0) pieces.mark_unbounded(right.back());
      if (i == events) pieces.mark_unbounded(right.back());
    }
    topology.euler -= static_cast<long>(arcs);
    if (i > 0) join(pieces, curve.status_line_at_event(i - 1), left, right, topology);
    left = std::move(right);
  }
  pieces.count(topology);
  return topology;
}

Integer cgal_reach(const Polynomial<Integer, 2>& f)
{
  Integer reach = 1;
  for (const std::size_t first : {0U, 1U}) reach = std::max(reach, reach_of_events(analysis(f, first)));
  for (const int sign : {1, -1}) reach = std::max(reach, reach_on_diagonal(f, sign));
  return reach + 1;
}

} // namespace corral::test
