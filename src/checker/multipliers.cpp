// SPDX-License-Identifier: LGPL-3.0-or-later
#include "multipliers.h"

namespace corral_check {
namespace {

/// N of section 6.
Polynomial read_combination(const Value& a, const Value& b, std::size_t dimension, Multipliers& result,
                            const Polynomial& q, const std::string& where, Budget& budget)
{
  Sum sum(budget);
  if (!a.is_null()) sum.add_product(read_polynomial(a, dimension, where + " a"), q);
  const auto entries = b.list(static_cast<std::int64_t>(dimension), where + " b");
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    result.slopes.push_back(!entries[axis].is_null());
    if (entries[axis].is_null()) continue;
    const Polynomial slope = derivative(q, axis);
    require(!slope.empty(), entries[axis].place(where + " b"), "the polynomial lacks the variable of this axis");
    sum.add_product(read_polynomial(entries[axis], dimension, where + " b"), slope);
  }
  return std::move(sum).take();
}

/// Divides the combination by its factors; a number has to be left.
void read_factors(const Value& value, Polynomial rest, Contents& contents, Multipliers& result,
                  const std::string& where, Budget& budget)
{
  Items items(value, where);
  for (Value entry; items.next(entry);) {
    const auto parts = entry.list(2, where);
    Polynomial factor = read_polynomial(parts[0], contents.dimension(), where);
    const std::uint64_t exponent = parts[1].number(1, 1000, where);
    require(total_degree(factor) > 0, parts[0].place(where), "a factor is a number");
    for (std::uint64_t k = 0; k < exponent; ++k) {
      auto divided = divide(rest, factor, budget);
      require(divided.remainder.empty(), parts[0].place(where), "not a factor of the combination");
      rest = std::move(divided.quotient);
    }
    result.factors.push_back(contents.proved.size());
    contents.proved.push_back(std::move(factor));
  }
  require(total_degree(rest) == 0, value.place(where), "not all factors of the combination");
}

} // namespace

void read_multipliers(const Value& value, Contents& contents, const std::string& where, Budget& budget)
{
  const auto fields = value.fields({"of", "a", "b", "factors"}, where);
  Multipliers result;
  result.of = fields[0].number(0, contents.proved.size() - 1, where + " of");
  const Polynomial combination =
      read_combination(fields[1], fields[2], contents.dimension(), result, contents.proved[result.of], where, budget);
  require(!combination.empty(), value.place(where), "the combination is zero");
  read_factors(fields[3], combination, contents, result, where + " factors", budget);
  contents.multipliers.push_back(std::move(result));
}

} // namespace corral_check
