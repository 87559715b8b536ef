// SPDX-License-Identifier: LGPL-3.0-or-later
#include "decision/decide_cells.h"
#include "decision/recheck.h"

#include <corral/polynomial/Polynomial.h>

#include <gtest/gtest.h>

#include <memory>

namespace {

using namespace corral;

/// What the concept says and nothing else: no default, no copy, no assignment of a copy.
class Archetype
{
public:
  explicit Archetype(Checkpoint checkpoint) : checkpoint_(std::make_unique<Checkpoint>(std::move(checkpoint))) {}
  Cell_decision<2> decide(const Cell<2>& cell)
  {
    (*checkpoint_)();
    return {cell[0] == 1 ? Verdict::empty : Verdict::unknown, Rung::integers, {}, "a reason"};
  }

private:
  std::unique_ptr<Checkpoint> checkpoint_;
};
static_assert(CellDecider<Archetype, 2>);
static_assert(!std::copyable<Archetype>);

struct Decides_nothing
{
};
struct Decides_by_a_verdict
{
  Verdict decide(const Cell<2>&);
};
struct Cannot_be_moved
{
  Cannot_be_moved(Cannot_be_moved&&) = delete;
  Cell_decision<2> decide(const Cell<2>&);
};
static_assert(!CellDecider<Decides_nothing, 2>);
static_assert(!CellDecider<Decides_by_a_verdict, 2>);
static_assert(!CellDecider<Cannot_be_moved, 2>);
static_assert(!CellDecider<Archetype, 3>); // of another dimension

TEST(Concepts, a_decider_that_offers_no_more_decides_rasters)
{
  const Grid grid({{0, 4}, {0, 1}}, {4, 1});
  Raster_builder<2> cells;
  cells.append({0, 0}, Verdict::unknown);
  cells.append({1, 0}, Verdict::unknown);
  cells.append({2, 0}, Verdict::hit);
  const auto raster = std::move(cells).finish(grid, true);
  const auto make = [](Checkpoint checkpoint) { return Archetype(std::move(checkpoint)); };
  for (const unsigned threads : {1U, 2U}) {
    auto ideal = exact::decide_cells(raster, {.threads = threads}, {}, make);
    EXPECT_EQ(ideal.raster.verdict({0, 0}), Verdict::unknown);
    EXPECT_EQ(ideal.raster.verdict({1, 0}), Verdict::empty);
    EXPECT_EQ(ideal.raster.verdict({2, 0}), Verdict::hit);
    exact::recheck(ideal, {collect<Integer, 2>({{{1, 0}, 2}, {{0, 0}, -5}})}, {}, {}, make);
    EXPECT_EQ(ideal.rechecked, 4);
  }
}

} // namespace
