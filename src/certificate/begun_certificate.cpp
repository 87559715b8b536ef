// SPDX-License-Identifier: LGPL-3.0-or-later
#include "begun_certificate.h"

#include "Checking_cost.h"
#include "validate.h"

#include <corral/errors.h>
#include <corral/internal/polynomial/integer_form.h>
#include <corral/polynomial/arithmetic.h>
#include <corral/polynomial/square_free.h>

#include <string>
#include <utility>

namespace corral::certificate {

namespace {

template <std::size_t D>
void require_limits(const Polynomial<Rational, D>& f, const char* what)
{
  double dense = 1;
  for (std::size_t axis = 0; axis < D; ++axis) {
    dense *= f.degree(axis) + 1;
    if (f.degree(axis) > 1000)
      throw Budget_exceeded("certificate: " + std::string(what) + " has the degree " + std::to_string(f.degree(axis))
                            + " in one variable; expected at most 1000");
  }
  if (dense > 65536)
    throw Budget_exceeded("certificate: " + std::string(what)
                          + " has too high a degree; expected (degree + 1) of all variables multiplied to be at most "
                            "65536");
  if (longest(f) * digits_of_a_word > 100000)
    throw Budget_exceeded("certificate: " + std::string(what)
                          + " has a coefficient of more than 90,000 digits; expected a shorter one");
}

/// f with its square-free part, or with itself where a checker would take too long to compare the two.
template <std::size_t D>
Certified_polynomial<D> certified_polynomial(const Polynomial<Rational, D>& f, double& work)
{
  Certified_polynomial<D> entry{f, square_free_part(f)};
  auto primitive = integer_primitive(f);
  if (primitive == entry.square_free) return entry;
  entry.power = highest_multiplicity(f);
  const auto g = transform<Rational>(entry.square_free, [](const Integer& c) { return Rational(c); });
  const double needed = square_free_work(f, g, entry.power);
  if (needed > max_work / 4) return {f, std::move(primitive)};
  work += needed;
  return entry;
}

} // namespace

template <std::size_t D>
Certificate<D> begun_certificate(const std::vector<Polynomial<Rational, D>>& system, const Grid<D>& grid, double& work)
{
  constexpr double max_cells = 4611686018427387904.0; // 2^62
  if (grid.cell_count() >= max_cells)
    throw Invalid_input("certificate: the grid has 2^62 cells or more; expected fewer");
  if (system.empty() || system.size() > (D == 1 ? 1U : 2U))
    throw Invalid_input("certificate: given " + detail::quantity(system.size(), "polynomial") + " in "
                        + detail::quantity(D, "dimension") + "; expected 1, or 2 in two or three dimensions");
  for (const auto& side : grid.box())
    for (const Rational& end : {side.lower(), side.upper()})
      if (length(end) * digits_of_a_word > 100000)
        throw Budget_exceeded("certificate: the box has a corner of more than 90,000 digits; expected a shorter one");
  Certificate<D> result{{}, grid};
  for (const auto& f : system) {
    if (f.is_zero())
      throw Invalid_input("certificate: a polynomial is zero, so that every point is a zero; expected one that is not");
    require_limits(f, "the polynomial");
    result.polynomials.push_back(certified_polynomial(f, work));
  }
  return result;
}

template Certificate<1> begun_certificate(const std::vector<Polynomial<Rational, 1>>&, const Grid<1>&, double&);
template Certificate<2> begun_certificate(const std::vector<Polynomial<Rational, 2>>&, const Grid<2>&, double&);
template Certificate<3> begun_certificate(const std::vector<Polynomial<Rational, 3>>&, const Grid<3>&, double&);

} // namespace corral::certificate
