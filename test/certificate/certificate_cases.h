// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_CERTIFICATE_CERTIFICATE_CASES_H
#define CORRAL_TEST_CERTIFICATE_CERTIFICATE_CASES_H

#include <corral/certificate/certificate.h>
#include <corral/polynomial/parse.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

/// \file
/// Polynomials whose certificates need every kind of proof, and the hand-written files.
namespace certificate_test {

using namespace corral;

template <std::size_t D>
std::array<std::string, D> names()
{
  const std::string all[] = {"x", "y", "z"};
  std::array<std::string, D> result;
  std::copy_n(all, D, result.begin());
  return result;
}

/// The cube [lower, upper]^D with the same number of cells along each axis.
template <std::size_t D>
Grid<D> cube(const char* lower, const char* upper, std::uint32_t cells)
{
  Rational_box<D> box;
  box.fill(Rational_interval(parse_rational(lower), parse_rational(upper)));
  Resolution<D> resolution;
  resolution.fill(cells);
  return Grid<D>(box, resolution);
}

struct Case
{
  std::size_t dimension;
  const char* polynomial; ///< two, with a semicolon between, for their common zeros
  const char* lower;
  const char* upper;
  std::uint32_t cells;
  std::uint64_t hits; ///< counted by hand
};

/// Each has no unknown cell.
inline const std::vector<Case> cases = {
    {1, "x^2 - 2", "0", "2", 4, 1},
    {1, "(x - 1)^2*(x^2 - 2)^2", "0", "2", 5, 2},
    {1, "x^2 + 1e-30", "-1", "2", 7, 0},
    {1, "(x - 1/3)*(x - 1/2)", "0", "1", 6, 3}, // two zeros on grid points
    {1, "5", "0", "1", 1, 0},
    {2, "x^2 + y^2", "-1", "1", 4, 4},                       // an isolated point on a grid point
    {2, "x^2 + y^2", "-1", "1", 3, 1},                       // inside a cell
    {2, "(x - 1/7)^2 + (y - 2/7)^2", "0", "1", 4, 1},        // in a cell, at no dyadic point
    {2, "(x^2 - 2)^2 + (y^2 - 3)^2", "1", "2", 4, 1},        // an isolated point with irrational coordinates
    {2, "(y - x^2)*(y - x^2 - 1e-12)", "0", "1", 3, 5},      // two branches 1e-12 apart
    {2, "(x - y)^2", "0", "1", 5, 13},                       // a double line along the diagonal
    {2, "(x - 1/2)^3", "0", "1", 4, 8},                      // a grid line
    {2, "x^2 + y^2 + 1e-30", "-1", "1", 3, 0},               // no real point
    {2, "y - (x^2 - 2)^2", "-2", "2", 4, 10},                // touches grid lines at irrational points
    {2, "1/3*x^3 - 7/11*x*y + y^2 - 1/13", "-1", "1", 8, 0}, // hits: not counted by hand
    {2, "x^9 - x^7*y + 3*x^2*y^6 - y^3 + y^5 + y^4*x - 4*y^4*x^3", "0", "1", 16, 0},
    {2, "(y - x^5)^2 + 1e-14", "-1", "1", 3, 0}, // near misses all along a curve
    {2, "(x^2 + y^2 - 1)^2 - 1e-18*x", "-1", "1", 4, 0},
    {2, "(x^2 + y^2 - 1)^2*(x - y)^2 - 1e-12*(x^3 + y)", "-1", "1", 4, 0},
    {2, "(x*y + y^2 - 1/3)^2 + 1e-20; x - y", "-1", "1", 3, 0},
    {3, "(x + y + z)^2 + 1e-30", "-1", "1", 3, 0},
    {3, "(x*y - z^2)^2 + 1e-16", "-1", "1", 2, 0},
    {3, "((x^2 + y^2 + z^2 - 1)^2 + 1e-14)^2 + (x - y)^2", "-1", "1", 2, 0},
    {3, "x^2 + y^2 + z^2 - 1", "-2", "2", 4, 0},
    {3, "x*y*z", "-1", "1", 3, 0},
    {3, "(x - 1/3)^2*(y^2 + z^2)", "-1", "1", 4, 0},
    {3, "x^2 - y^2*z", "-1", "1", 4, 0},                              // Whitney's umbrella
    {3, "(x^2 - 2)^2 + (y^2 - 3)^2 + (z^2 - 5)^2", "-3", "3", 3, 8},  // isolated points with irrational coordinates
    {3, "(x^2 + y^2 - 1/100)^2 + (z^2 - 2)^2", "-3", "3", 3, 2},      // closed curves inside cells
    {2, "x^2 - 2; y^2 - 3", "-2", "2", 4, 4},                         // from here on systems
    {2, "(x^2 - 2)^2*(y - 1); y^2 - 3", "-2", "2", 4, 4},             // with a square-free part
    {2, "(3*x - 1)*(y - x); (3*x - 1)*(x + y - 1)", "-2", "2", 4, 4}, // a line and a point, (1/2, 1/2)
    {2, "(x^2 + y^2 - 3)*(y - x); (x^2 + y^2 - 3)*(x + y - 1)", "-2", "2", 7, 0}, // a circle and a point
    {2, "x^2 + y^2 - 1; x^2 + y^2 - 1 - 1/20", "-2", "2", 3, 0},                  // close, but without a common zero
    {3, "x^2 + y^2 + z^2 - 4; (x - 1)^2 + y^2 - 1", "-2", "2", 4, 0},             // Viviani's curve
    {3, "100*(x^2 + y^2 + z^2) - 1; 3*x + 5*y + 7*z - 1/10", "-2", "2", 3, 1},    // a circle inside a cell
    {3, "7*z - 1; 7*z - 1 - (x^2 - 2)^2 - (y^2 - 3)^2", "-2", "2", 3, 4},         // contacts at irrational points
};

/// The polynomials of a case.
template <std::size_t D>
std::vector<Polynomial<Rational, D>> system_of(const Case& c)
{
  std::vector<Polynomial<Rational, D>> system;
  const std::string text = c.polynomial;
  for (std::size_t from = 0; from != std::string::npos;) {
    const auto end = text.find(';', from);
    system.push_back(parse_polynomial<D>(text.substr(from, end - from), names<D>()));
    from = end == std::string::npos ? end : end + 1;
  }
  return system;
}

/// The text of a case's certificate.
template <std::size_t D>
std::string make_text(const Case& c)
{
  return to_json(certify(system_of<D>(c), cube<D>(c.lower, c.upper, c.cells)), names<D>());
}

inline std::string make_text(const Case& c)
{
  return c.dimension == 1 ? make_text<1>(c) : c.dimension == 2 ? make_text<2>(c) : make_text<3>(c);
}

inline std::string read(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline const std::vector<std::string> hand_written = {"minimal",     "unknown", "irrational_touch",
                                                      "double_line", "system",  "system_point"};

inline std::string hand_written_text(const std::string& name)
{
  return read(std::string(CORRAL_CERTIFICATE_FILES) + "/" + name + ".json");
}

} // namespace certificate_test

#endif
