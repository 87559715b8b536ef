// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/internal/localization/Subdivision.h>

#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace corral;
using Node = Subdivision_node<2>;

/// What the concept says and nothing else: not even a copy.
class Archetype
{
public:
  explicit Archetype(std::vector<Cell<2>>& cells) : cells_(cells) {}
  Archetype(const Archetype&) = delete;
  Archetype& operator=(const Archetype&) = delete;
  bool begin(const Node&) { return true; }
  bool decides(const Node& node) { return node.level == 0; }
  void decide(const Node& cell) { cells_.push_back(cell.corner); }
  unsigned split(const Node&, unsigned children) { return children; }
  void descend(const Node&, unsigned) {}

private:
  std::vector<Cell<2>>& cells_;
};
static_assert(SubdivisionForm<Archetype, 2>);

struct Without_begin
{
  bool decides(const Node&);
  void decide(const Node&);
  unsigned split(const Node&, unsigned);
  void descend(const Node&, unsigned);
};
struct Without_decides
{
  bool begin(const Node&);
  void decide(const Node&);
  unsigned split(const Node&, unsigned);
  void descend(const Node&, unsigned);
};
struct Without_decide
{
  bool begin(const Node&);
  bool decides(const Node&);
  unsigned split(const Node&, unsigned);
  void descend(const Node&, unsigned);
};
struct Split_tells_nothing
{
  bool begin(const Node&);
  bool decides(const Node&);
  void decide(const Node&);
  void split(const Node&, unsigned);
  void descend(const Node&, unsigned);
};
struct Without_descend
{
  bool begin(const Node&);
  bool decides(const Node&);
  void decide(const Node&);
  unsigned split(const Node&, unsigned);
};
static_assert(!SubdivisionForm<Without_begin, 2>);
static_assert(!SubdivisionForm<Without_decides, 2>);
static_assert(!SubdivisionForm<Without_decide, 2>);
static_assert(!SubdivisionForm<Split_tells_nothing, 2>);
static_assert(!SubdivisionForm<Without_descend, 2>);
static_assert(!SubdivisionForm<Archetype, 3>); // of another dimension

TEST(Concepts, a_form_that_offers_no_more_is_subdivided)
{
  std::vector<Cell<2>> cells;
  Archetype form(cells);
  subdivide(Subdivision_tree<2>({3, 5}), form);
  EXPECT_EQ(cells.size(), 15U);
}

} // namespace
