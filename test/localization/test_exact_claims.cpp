// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/localization/localize.h>
#include <corral/number/Environment.h>
#include <corral/polynomial/parse.h>

#include "close_cases.h"
#include "corner_judge.h"
#include "localization/fast/Exact_limits.h"
#include "localization/fast/Root_seed.h"
#include "localization/fast/Rough_nodes.h"
#include "localization/fast/Subdivider.h"
#include "localization/fast/Term_bounds.h"
#include "localization/fast/tasks.h"
#include "rounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

/// \file
/// Where the fast engine leaves an error out because nothing was rounded: curves and surfaces through corners of cells,
/// or past them by a rounding error, on every path through the engine.
namespace {

using namespace corral;
using fast::Seed;
using fast::Term_form;
using test::Judgement;

template <std::size_t D>
struct Case
{
  std::vector<Polynomial<Rational, D>> system;
  Grid<D> grid;
};

/// What the dense form of a polynomial hands over on its way down the tree.
template <std::size_t D>
fast::Harvest<D> handed_over(const Polynomial<Rational, D>& f, const Grid<D>& grid)
{
  const Nearest_scope environment;
  const fast::Plan<D> plan(fast::Monomial_shape<D>(f), grid);
  fast::Pulse pulse({});
  const Seed<D> root = fast::root_seed(plan, f, grid, pulse);
  fast::Harvest<D> harvest;
  fast::make_subdivider(plan, pulse)->run(plan.root_level, {&root, 1}, 0, harvest);
  return harvest;
}

/// The ways that a node can go, in the plane or in space.
template <std::size_t D>
struct Path
{
  const char* name;
  Case<D> (*make)(Trouble_source&);
  bool (*is_taken)(const Case<D>&);
};

template <std::size_t D>
std::uint32_t side(Trouble_source& random)
{
  return D == 2 ? (random.chance(2) ? 16 : 24) : (random.chance(2) ? 8 : 6);
}

template <std::size_t D>
bool is_by_terms(const Case<D>& c)
{
  return std::ranges::any_of(c.system, [&](const auto& f) { return Term_form<D>::suits(f, c.grid); });
}

template <std::size_t D>
bool is_dense(const Case<D>& c)
{
  return !is_by_terms(c);
}

template <std::size_t D>
bool is_rough(const Case<D>& c)
{
  return is_dense(c) && !handed_over(c.system[0], c.grid).rough.empty();
}

template <std::size_t D>
bool is_hidden(const Case<D>& c)
{
  return is_dense(c) && !handed_over(c.system[0], c.grid).hidden.empty();
}

template <std::size_t D>
const std::vector<Path<D>>& paths()
{
  static const std::vector<Path<D>> all = {
      {"a dense root",
       [](Trouble_source& random) {
         const auto grid = test::close_grid<D>(random, side<D>(random));
         return Case<D>{{test::close_product<D>(random, grid, random.chance(3) ? 2 : 1)}, grid};
       },
       is_dense<D>},
      {"few terms",
       [](Trouble_source& random) {
         const auto grid = test::close_grid<D>(random, side<D>(random));
         return Case<D>{{test::close_and_sparse<D>(random, grid)}, grid};
       },
       is_by_terms<D>},
      {"rough nodes on a finer grid",
       [](Trouble_source& random) {
         const auto grid = test::close_grid<D>(random, side<D>(random));
         return Case<D>{{test::close_product<D>(random, grid, 3)}, grid};
       },
       [](const Case<D>& c) { return is_rough(c) && !Term_form<D>::has_few_terms(c.system[0]); }},
      {"rough nodes by terms",
       [](Trouble_source& random) {
         Rational_box<D> box;
         box.fill(Rational_interval(1, 2));
         Resolution<D> resolution;
         resolution.fill(D == 2 ? static_cast<std::uint32_t>(random.integer(16, 64)) : 12);
         return Case<D>{{test::close_powers<D>(random)}, Grid<D>(box, resolution)};
       },
       [](const Case<D>& c) { return is_rough(c) && Term_form<D>::has_few_terms(c.system[0]); }},
      {"hidden nodes",
       [](Trouble_source& random) {
         Rational_box<D> box;
         box.fill(Rational_interval(0, 1));
         Resolution<D> resolution;
         resolution.fill(D == 2 ? 64 : 32);
         const Grid<D> grid(box, resolution);
         return Case<D>{{test::close_and_hidden<D>(random, grid)}, grid};
       },
       is_hidden<D>},
      {"systems",
       [](Trouble_source& random) {
         const auto grid = test::close_grid<D>(random, side<D>(random));
         return Case<D>{{test::close_product<D>(random, grid, 1), test::close_product<D>(random, grid, 2)}, grid};
       },
       is_dense<D>},
      {"systems with few terms",
       [](Trouble_source& random) {
         const auto grid = test::close_grid<D>(random, side<D>(random));
         auto f = test::close_and_sparse<D>(random, grid);
         const auto plane = test::close_plane<D>(random, grid, 53);
         return Case<D>{{f, random.chance(2) ? plane : f * constant<Rational, D>(3)}, grid};
       },
       is_by_terms<D>}};
  return all;
}

template <std::size_t D>
class Exact_claims : public testing::TestWithParam<std::size_t>
{
protected:
  void judge_path() const
  {
    const Path<D>& path = paths<D>()[GetParam()];
    const auto least = static_cast<std::uint64_t>(test::rounds(10000));
    Trouble_source random(GetParam() + 31 * D);
    Judgement judgement;
    int cases = 0;
    for (int round = 0; judgement.close < least && judgement.wrong.empty() && round < test::rounds(4000); ++round) {
      const Case<D> c = path.make(random);
      if (!path.is_taken(c)) continue;
      ++cases;
      test::judge(c.system, c.grid, localize(c.system, c.grid), judgement);
    }
    RecordProperty("close_verdicts", std::to_string(judgement.close)); // --gtest_output=xml writes it down
    EXPECT_EQ(judgement.wrong, "") << path.name;
    EXPECT_GE(judgement.close, least) << path.name << ": " << cases << " cases, " << judgement.unknown << " unknown";
  }
};

std::string name_of(const testing::TestParamInfo<std::size_t>& info)
{
  std::string name = paths<2>()[info.param].name; // the same in space
  std::ranges::replace(name, ' ', '_');
  return name;
}

/// The largest power of two that divides a number; infinity for 0.
double quantum_of(double c)
{
  if (c == 0) return std::numeric_limits<double>::infinity();
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(c, &exponent), 53));
  return std::ldexp(static_cast<double>(mantissa & -mantissa), exponent - 53);
}

template <std::size_t D>
Seed<D> seed_of(const Polynomial<Rational, D>& p, const fast::Monomial_shape<D>& shape, const Cell<D>& corner)
{
  Seed<D> seed;
  seed.corner = corner;
  seed.coefficients.resize(shape.size());
  seed.quantum = std::numeric_limits<double>::infinity();
  for (const auto& term : p.terms()) {
    const double c = term.coefficient.get_d();
    EXPECT_EQ(Rational(c), term.coefficient);
    seed.coefficients[shape.position(term.exponents)] = c;
    seed.quantum = std::min(seed.quantum, quantum_of(c));
    seed.norm += std::abs(c) * (1 + 0x1p-40);
  }
  return seed;
}

enum class Quantum { unknown, true_one, mixed, false_one };

/// \brief Runs a plan on seeds that come from nowhere, one polynomial a node, and judges what becomes of each.
template <std::size_t D>
Judgement judge_seeds(std::uint64_t number, std::uint64_t least, Quantum quantum)
{
  constexpr std::uint32_t cells = D == 2 ? 16 : 8; // of a node
  constexpr unsigned degree = 5;
  const Nearest_scope environment;
  Trouble_source random(number);
  std::vector<Exponents<D>> monomials;
  Resolution<D> powers;
  powers.fill(degree + 1);
  test::for_each_cell<D>(powers, [&](const Cell<D>& e) {
    Exponents<D> exponents;
    unsigned total = 0;
    for (std::size_t axis = 0; axis < D; ++axis) total += exponents[axis] = static_cast<std::uint16_t>(e[axis]);
    if (total <= degree) monomials.push_back(exponents);
  });
  Rational_box<D> box;
  box.fill(Rational_interval(-1, 1));
  Resolution<D> resolution;
  resolution.fill(cells);
  const Grid<D> node(box, resolution); // in its own coordinates
  resolution.fill(2 * cells);
  fast::Plan<D> plan(fast::Monomial_shape<D>(monomials), Grid<D>(box, resolution));
  plan.tells_rough = plan.tells_hidden = false;
  fast::Pulse pulse({});
  Judgement judgement;
  for (int round = 0; judgement.close < least && judgement.faults == 0 && round < test::rounds(4000); ++round) {
    std::vector<Polynomial<Rational, D>> polynomials;
    std::vector<Seed<D>> seeds;
    for (unsigned k = 0; k < (1U << D); ++k) {
      Cell<D> corner;
      for (std::size_t axis = 0; axis < D; ++axis) corner[axis] = (k >> axis & 1) != 0 ? cells : 0;
      polynomials.push_back(test::rounded(test::close_product<D>(random, node, random.chance(3) ? 2 : 1), 53));
      if (polynomials.back().is_zero()) polynomials.back() = constant<Rational, D>(1);
      seeds.push_back(seed_of(polynomials.back(), plan.shape, corner));
      if (quantum == Quantum::unknown || (quantum == Quantum::mixed && random.chance(4))) seeds.back().quantum = 0;
      if (quantum == Quantum::false_one) seeds.back().quantum = 1;
    }
    fast::Harvest<D> harvest;
    fast::make_subdivider(plan, pulse)->run(plan.root_level - 1, seeds, 0, harvest);
    std::vector<Raster_builder<D>> found(seeds.size());
    for (auto block : harvest.blocks.sorted()) {
      std::size_t k = 0;
      for (std::size_t axis = 0; axis < D; ++axis)
        if (auto& index = block.index[axis]; index >= cells / block_side<D>) {
          index -= cells / block_side<D>;
          k |= std::size_t{1} << axis;
        }
      found[k].append(block);
    }
    for (std::size_t k = 0; k < seeds.size(); ++k) {
      test::judge<D>({polynomials[k]}, node, std::move(found[k]).finish(node, true), judgement);
    }
  }
  return judgement;
}

template <std::size_t D>
void expect_right_seeds(Quantum quantum)
{
  const auto least = static_cast<std::uint64_t>(test::rounds(10000));
  const auto judgement = judge_seeds<D>(5 + D, least, quantum);
  const std::string key = "close_verdicts_" + std::to_string(D) + "_" + std::to_string(static_cast<int>(quantum));
  testing::Test::RecordProperty(key, std::to_string(judgement.close));
  EXPECT_EQ(judgement.wrong, "");
  EXPECT_GE(judgement.close, least);
}

TEST(Exact_claims, seeds_from_nowhere_are_right)
{
  for (const auto quantum : {Quantum::unknown, Quantum::true_one, Quantum::mixed}) {
    expect_right_seeds<2>(quantum);
    expect_right_seeds<3>(quantum);
  }
}

// Negative control: what the engine did when it counted seeds of any doubles as multiples of some plan's quantum.
TEST(Exact_claims, a_rounding_counted_as_exact_is_found)
{
#ifdef NDEBUG
  EXPECT_GT(judge_seeds<2>(7, 100000, Quantum::false_one).faults, 0U);
  EXPECT_GT(judge_seeds<3>(8, 100000, Quantum::false_one).faults, 0U);
#else
  EXPECT_DEATH((void)judge_seeds<2>(7, 100000, Quantum::false_one), "is_exact");
  EXPECT_DEATH((void)judge_seeds<3>(8, 100000, Quantum::false_one), "is_exact");
#endif
}

TEST(Exact_claims, limits_are_those_of_the_least_quantum)
{
  const std::vector<Seed<2>> seeds{{0, 0x1p-4, 0, 0, {}, {}}, {0, 0x1p-9, 0, 0, {}, {}}};
  EXPECT_EQ(fast::common_quantum<2>(seeds), 0x1p-9);
  const std::vector<Seed<2>> more{seeds[0], Seed<2>{}};
  EXPECT_EQ(fast::common_quantum<2>(more), 0);
  fast::Exact_limits limits;
  limits.reset(3, 6, 4, 0x1p-9);
  EXPECT_EQ(limits.split(5), 0x1p+40);
  EXPECT_EQ(limits.split(4), 0x1p+37);
  EXPECT_EQ(limits.corner(), 0x1p+31);
  EXPECT_EQ(limits.probe(), 0x1p+25);
  EXPECT_EQ(limits.quantum(4), 0x1p-15);
  EXPECT_EQ(fast::exact_limit(0x1p-1000, 0), 0x1p-948);
  EXPECT_EQ(fast::exact_limit(0x1p-1000, 1), 0); // else a weight times a coefficient may be subnormal
  EXPECT_EQ(fast::exact_limit(0x1p-9, 1U << 20), 0);
  EXPECT_EQ(fast::exact_limit(0, 0), 0);
}

/// Inputs of which some cells were called empty, or hit, although they are not.
template <std::size_t D>
void expect_right(const std::vector<std::string>& texts, const Rational& half_side, std::uint32_t cells,
                  std::uint64_t plotted)
{
  std::array<std::string, D> names;
  for (std::size_t axis = 0; axis < D; ++axis) names[axis] = std::string(1, "xyz"[axis]);
  Rational_box<D> box;
  box.fill(Rational_interval(-half_side, half_side));
  Resolution<D> resolution;
  resolution.fill(cells);
  std::vector<Polynomial<Rational, D>> system;
  for (const auto& text : texts) system.push_back(parse_polynomial<D>(text, names));
  const Grid<D> grid(box, resolution);
  const auto found = localize(system, grid);
  Judgement judgement;
  test::judge(system, grid, found, judgement);
  EXPECT_EQ(judgement.wrong, "");
  EXPECT_GE(found.plotted(), plotted) << texts.front();
}

TEST(Exact_claims, no_cell_around_an_exact_zero_is_lost)
{
  expect_right<2>({"x^10*y^10 + x + 0x1.999999999999ap-4*y"}, Rational(1, 16), 16, 18);
  expect_right<2>({"x^10*y^10 + 16*x + 3/2^51*y + 5/2^56"}, Rational(1, 16), 16, 32);
  const std::string space = "x^12*y^12*z^12 + 0x1.7851eb851eb85p+0*x + 0x1.e666666666666p+0*y + 0x1.428f5c28f5c29p+0*z";
  expect_right<3>({space}, Rational(1, 16), 8, 8);
  expect_right<3>({space, "x-2*y"}, Rational(1, 16), 8, 4);
}

TEST(Exact_claims, no_cell_beside_a_near_zero_is_hit)
{
  expect_right<2>({"x^10*y^10 + 754746360430811/562949953421312*x + 6037970883105047/4503599627370496*y"
                   " + 6037970882422165/576460752303423488"},
                  Rational(1, 16), 16, 16);
}

class In_the_plane : public Exact_claims<2>
{
};
class In_space : public Exact_claims<3>
{
};
TEST_P(In_the_plane, no_verdict_is_false) { judge_path(); }
TEST_P(In_space, no_verdict_is_false) { judge_path(); }
INSTANTIATE_TEST_SUITE_P(Exact_claims, In_the_plane, testing::Range(std::size_t{0}, paths<2>().size()), name_of);
INSTANTIATE_TEST_SUITE_P(Exact_claims, In_space, testing::Range(std::size_t{0}, paths<3>().size()), name_of);

} // namespace
