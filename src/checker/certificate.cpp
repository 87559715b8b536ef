// SPDX-License-Identifier: LGPL-3.0-or-later
#include "certificate.h"

#include "multipliers.h"
#include "unpack.h"

#include <algorithm>
#include <set>

namespace corral_check {
namespace {

constexpr std::uint64_t max_resolution = std::uint64_t{1} << 30;
constexpr std::uint64_t max_count = (std::uint64_t{1} << 63) - 1;
constexpr double max_cells = 4611686018427387904.0; // 2^62, so that counts cannot overflow
constexpr std::size_t max_keys = 17;

using Members = std::vector<std::pair<std::string, Value>>;

std::int64_t size_of(const Contents& contents) { return static_cast<std::int64_t>(contents.dimension()); }

std::string indexed(std::string name, std::size_t index)
{
  name.append("[").append(std::to_string(index)).append("]");
  return name;
}

const Value* find(const Members& members, std::string_view key)
{
  const auto found = std::find_if(members.begin(), members.end(), [&](const auto& m) { return m.first == key; });
  return found == members.end() ? nullptr : &found->second;
}

const Value& get(const Members& members, const std::string& key)
{
  const Value* found = find(members, key);
  if (found == nullptr) reject({"certificate"}, "the key '" + key + "' is missing");
  return *found;
}

void read_variables(const Value& value, Contents& contents)
{
  for (const Value& name : value.list(size_of(contents), "variables"))
    contents.claims.variables.push_back(name.string("variables"));
  const auto& names = contents.claims.variables;
  require(std::set<std::string>(names.begin(), names.end()).size() == names.size(), value.place("variables"),
          "two names are the same");
}

/// Section 2: g divides f, and f divides a power of g.
Polynomial read_square_free(const Value& value, std::size_t dimension, const Polynomial& f, const std::string& where,
                            Budget& budget)
{
  if (value.is_null()) return f;
  const auto fields = value.fields({"polynomial", "power"}, where);
  Polynomial g = read_polynomial(fields[0], dimension, where);
  const std::uint64_t power = fields[1].number(1, 1000, where + " power");
  require(divide(f, g, budget).remainder.empty(), fields[0].place(where), "does not divide the polynomial");
  require(divides_power(f, g, power, budget), fields[1].place(where), "the polynomial does not divide its power");
  return g;
}

void read_polynomials(const Value& given, const Value& square_free, Contents& contents, Budget& budget)
{
  const auto polynomials = given.list(-1, "polynomials");
  contents.given = polynomials.size();
  require(contents.given >= 1 && contents.given <= contents.dimension(), given.place("polynomials"),
          "expected 1 to dimension polynomials");
  std::vector<Value> parts(contents.given);
  if (!square_free.is_null()) parts = square_free.list(static_cast<std::int64_t>(contents.given), "square_free");
  for (std::size_t j = 0; j < contents.given; ++j) {
    const std::string index = indexed("", j);
    const Polynomial f = read_polynomial(polynomials[j], contents.dimension(), "polynomials" + index);
    contents.claims.polynomials.push_back(to_text(f, contents.claims.variables));
    contents.proved.push_back(read_square_free(parts[j], contents.dimension(), f, "square_free" + index, budget));
  }
}

void read_grid(const Value& box, const Value& resolution, Contents& contents)
{
  const auto sides = box.list(size_of(contents), "box");
  const auto counts = resolution.list(size_of(contents), "resolution");
  double cells = 1;
  for (std::size_t axis = 0; axis < contents.dimension(); ++axis) {
    const auto ends = sides[axis].list(2, "box");
    Side side{ends[0].exact("box"), ends[1].exact("box")};
    require(side.lower < side.upper, sides[axis].place("box"), "a side is empty or a point");
    const std::uint64_t count = counts[axis].number(1, max_resolution, "resolution");
    cells *= static_cast<double>(count);
    contents.step.emplace_back((side.upper - side.lower) / mpq_class(mpz_class(static_cast<unsigned long>(count))));
    contents.claims.resolution.push_back(count);
    contents.claims.box.push_back(side.lower.get_str());
    contents.claims.box.push_back(side.upper.get_str());
    contents.box.push_back(std::move(side));
  }
  require(cells < max_cells, resolution.place("resolution"), "2^62 cells or more");
}

void read_reasons(const Value& value, Contents& contents)
{
  const auto reasons = value.list(-1, "reasons");
  for (const Value& reason : reasons) require(!reason.string("reasons").empty(), reason.place("reasons"), "is empty");
  contents.reasons = reasons.size();
  require(contents.reasons <= 10, value.place("reasons"), "more than 10 entries");
}

void read_multipliers(const Members& members, Contents& contents, Budget& budget)
{
  contents.critical = get(members, "critical");
  (void)Items(*contents.critical, "critical");
  const Value& multipliers = get(members, "multipliers");
  Items items(multipliers, "multipliers");
  for (Value entry; items.next(entry);)
    read_multipliers(entry, contents, indexed("multipliers", contents.multipliers.size()), budget);
}

void require_string(const Members& members, const char* key, const char* expected)
{
  const Value* value = find(members, key);
  const Place place = value == nullptr ? Place{key} : value->place(key);
  if (value == nullptr || value->string(key) != expected) reject(place, "expected '" + std::string(expected) + "'");
}

} // namespace

void read_contents(std::string bytes, Contents& contents)
{
  contents.text = unpack(std::move(bytes));
  Budget budget;
  const auto members = read_json(contents.text).members(max_keys, "certificate");
  require_string(members, "format", "corral-certificate");
  const std::uint64_t version = get(members, "version").number(1, 2, "version");
  const std::size_t keys = version == 1 ? max_keys - 2 : max_keys;
  require_string(members, "method", "bernstein");
  contents.claims.dimension = get(members, "dimension").number(1, max_dimension, "dimension");
  read_variables(get(members, "variables"), contents);
  read_polynomials(get(members, "polynomials"), get(members, "square_free"), contents, budget);
  if (version == 2) read_multipliers(members, contents, budget);
  read_grid(get(members, "box"), get(members, "resolution"), contents);
  contents.tree_value = get(members, "tree");
  contents.tree = contents.tree_value.string("tree");
  contents.witnesses = get(members, "witnesses");
  (void)Items(contents.witnesses, "witnesses");
  read_reasons(get(members, "reasons"), contents);
  auto& counts = contents.claims.counts;
  counts.empty = get(members, "empty").number(0, max_count, "empty");
  counts.hit = get(members, "hit").number(0, max_count, "hit");
  counts.unknown = get(members, "unknown").number(0, max_count, "unknown");
  require(members.size() == keys, {"certificate"}, "has a key that is not in the specification");
  contents.work = budget.spent();
}

} // namespace corral_check
