// SPDX-License-Identifier: LGPL-3.0-or-later
#include "algebra/root_cases.h"

#include <corral/algebra/real_roots.h>
#include <corral/audit/root_oracles.h>
#include <corral/polynomial/parse.h>

#include <corral/decision/ideal_raster.h>

#include <algebra/Plane_system.h>
#include <algebra/restriction.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace {

using namespace corral;

Rational tiny()
{
  Rational result(1);
  mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), 260);
  return result;
}

/// Where Corral's roots and an oracle's differ, or "".
std::string difference(std::vector<Real_root> ours, const std::vector<Oracle_root>& theirs)
{
  if (ours.size() != theirs.size())
    return std::to_string(ours.size()) + " roots against " + std::to_string(theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    ours[i].refine_to(tiny());
    if (ours[i].upper() < theirs[i].interval.lower() || theirs[i].interval.upper() < ours[i].lower())
      return "root " + std::to_string(i) + " lies elsewhere";
    if (ours[i].multiplicity() != theirs[i].multiplicity)
      return "multiplicity " + std::to_string(i) + ": " + std::to_string(ours[i].multiplicity()) + " against "
             + std::to_string(theirs[i].multiplicity);
  }
  return "";
}

unsigned rounds(unsigned count)
{
  const char* multiplier = std::getenv("CORRAL_TEST_MULTIPLIER");
  return count * (multiplier != nullptr ? static_cast<unsigned>(std::max(1, std::atoi(multiplier))) : 1);
}

TEST(Root_oracles, all_agree_on_hard_polynomials)
{
  for (const auto& [name, p] : root_cases::hard_cases()) {
    const auto ours = isolate_real_roots(p);
    for (const auto& oracle : root_oracles()) EXPECT_EQ(ours.size(), oracle.count(p)) << oracle.name << ", " << name;
    if (degree(p) == 0) continue;
    EXPECT_EQ(difference(ours, cgal_real_roots(p, tiny())), "") << name;
  }
}

TEST(Root_oracles, all_agree_on_random_polynomials)
{
  std::mt19937_64 random(3);
  for (unsigned round = 0; round < rounds(40); ++round) {
    auto p = root_cases::random_polynomial(random, 1 + round % 15, 1 + 40 * (round % 4));
    if (round % 3 == 0) p = multiply(p, root_cases::power(root_cases::random_polynomial(random, 2, 8), 2));
    const auto ours = isolate_real_roots(p);
    for (const auto& oracle : root_oracles()) EXPECT_EQ(ours.size(), oracle.count(p)) << oracle.name << ", " << round;
    EXPECT_EQ(difference(ours, cgal_real_roots(p, tiny())), "") << round;
  }
}

TEST(Root_oracles, notice_faulty_isolators)
{
  const auto p = root_cases::mignotte(18, Integer(1) << 20);
  const auto theirs = cgal_real_roots(p, tiny());
  auto lost = isolate_real_roots(p);
  lost.pop_back();
  EXPECT_NE(difference(lost, theirs), "");
  auto merged = isolate_real_roots(p); // takes two close roots for one
  merged[2] = merged[1];
  EXPECT_NE(difference(merged, theirs), "");
  const auto square = root_cases::power({-2, 0, 1}, 2);
  EXPECT_NE(difference(isolate_real_roots({-2, 0, 1}), cgal_real_roots(square, tiny())), "");
}

TEST(Root_oracles, agree_on_common_zeros_in_the_plane)
{
  const std::vector<std::string> curves = {
      "x^2+y^2-4",           "y^2-x^3+x",         "x*y-1",    "(x^2-2)^2+(y^2-3)^2", "x^4+y^4-3*x^2*y-2*y+1",
      "x^3-2*y^2+x*y-7*x+3", "y^5-x^2*y^2+3*x-1", "x^2-2*y^2"};
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (std::size_t j = i; j < curves.size(); ++j) {
      const auto f = integer_primitive(parse_polynomial<2>(curves[i], {"x", "y"}));
      const auto g = i == j ? derivative(f, 1) : integer_primitive(parse_polynomial<2>(curves[j], {"x", "y"}));
      const auto theirs = cgal_common_zeros(f, g, Rational(1, 1 << 20));
      exact::Plane_system system(f, g);
      const Rational_interval wide(-1000, 1000);
      const auto all = system.zeros_in({wide, wide}, false, true, {});
      EXPECT_EQ(all.size(), theirs.size()) << curves[i] << " and " << curves[j];
      for (const auto& box : theirs) {
        const Rational_box<2> around = {Rational_interval(box[0].lower() - 1, box[0].upper() + 1),
                                        Rational_interval(box[1].lower() - 1, box[1].upper() + 1)};
        EXPECT_FALSE(system.zeros_in(around, true, false, {}).empty()) << curves[i] << " and " << curves[j];
      }
    }
}

/// Whether p has a root in a closed interval, by CGAL. \pre p is not zero.
bool cgal_root_in(const Integer_polynomial& p, const Rational_interval& side)
{
  if (sign_at(p, side.lower()) == 0 || sign_at(p, side.upper()) == 0) return true;
  if (degree(p) == 0) return false;
  for (const auto& root : cgal_real_roots(p, tiny()))
    if (side.lower() < root.interval.lower() && root.interval.upper() < side.upper()) return true;
  return false;
}

/// A decision made of the oracles alone: a zero on an edge, or a point inside with a vertical tangent or a singularity.
bool cgal_hit(const Polynomial<Integer, 2>& g, const std::vector<Rational_box<2>>& extremes,
              const Rational_box<2>& cell)
{
  for (const std::size_t axis : {0U, 1U})
    for (const auto& value : {cell[axis].lower(), cell[axis].upper()}) {
      const auto edge = exact::restriction<2>(g, axis, value);
      const auto p = integer_polynomial(transform<Rational>(edge, [](const Integer& c) { return Rational(c); }));
      if (p.is_zero() || cgal_root_in(p, cell[1 - axis])) return true;
    }
  return std::any_of(extremes.begin(), extremes.end(), [&](const Rational_box<2>& box) {
    return cell[0].lower() < box[0].lower() && box[0].upper() < cell[0].upper() && cell[1].lower() < box[1].lower()
           && box[1].upper() < cell[1].upper();
  });
}

TEST(Root_oracles, agree_with_the_exact_decision_of_cells)
{
  std::vector<std::string> curves = {"(3*x-1)^2+(7*y-1)^2",
                                     "x^2+y^2-2",
                                     "((x^2-2)^2+(x*y-1)^2)*(x+3*y-1)",
                                     "y^2-x^3+x^2",
                                     "x^4+y^4-x^2*y",
                                     "(x-1/3)^2+(y-1/5)^2-1/1000",
                                     "y^4-2*y^2*x+x^2-x^4+1/9",
                                     "x^3+y^3-3*x*y+1",
                                     "(x^2+y^2)^3-4*x^2*y^2-1/100"};
  std::mt19937_64 random(17);
  for (unsigned round = 0; round < rounds(6); ++round) {
    std::string text = "0";
    for (unsigned i = 0; i <= 4; ++i)
      for (unsigned j = 0; i + j <= 4; ++j)
        text += "+(" + std::to_string(static_cast<int>(random() % 41) - 20) + ")*x^" + std::to_string(i) + "*y^"
                + std::to_string(j);
    curves.push_back(text);
  }
  const Rational_interval side(-2, 2);
  const Grid<2> grid({side, side}, {7, 6});
  for (const auto& text : curves) {
    const auto f = parse_polynomial<2>(text, {"x", "y"});
    Cell_decider<2> decider(f, grid, {}, Witnesses::simple);
    const auto& g = decider.square_free();
    const auto extremes = cgal_common_zeros(g, derivative(g, 1), tiny());
    std::size_t hits = 0;
    for (std::uint32_t i = 0; i < 7; ++i)
      for (std::uint32_t j = 0; j < 6; ++j) {
        const bool hit = decider.decide({i, j}).verdict == Verdict::hit;
        EXPECT_EQ(hit, cgal_hit(g, extremes, grid.cell_box({i, j}))) << text << " in " << i << ", " << j;
        hits += hit;
      }
    EXPECT_GT(hits, 0U) << text;
  }
}

} // namespace
