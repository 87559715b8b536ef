// SPDX-License-Identifier: LGPL-3.0-or-later
#include "certificate.h"

#include <set>

namespace corral_check {
namespace {

constexpr std::uint64_t max_resolution = std::uint64_t{1} << 30;
constexpr std::uint64_t max_count = (std::uint64_t{1} << 63) - 1;
constexpr double max_cells = 4611686018427387904.0; // 2^62, so that counts cannot overflow

std::int64_t size_of(const Certificate& certificate) { return static_cast<std::int64_t>(certificate.dimension); }

void read_variables(const Json& value, const Certificate& certificate)
{
  std::set<std::string> names;
  for (const Json& name : list(value, size_of(certificate), "variables")) names.insert(text(name, "variables"));
  require(names.size() == certificate.dimension, "variables", "two names are the same");
}

void read_polynomials(const Json& value, Certificate& certificate)
{
  const std::size_t count = list(value, -1, "polynomials").size();
  require(count >= 1 && count <= certificate.dimension, "polynomials", "expected 1 to dimension polynomials");
  for (std::size_t j = 0; j < count; ++j)
    certificate.polynomials.push_back(
        read_polynomial(value[j], certificate.dimension, "polynomials[" + std::to_string(j) + "]"));
}

/// Section 2: g divides f, and f divides a power of g.
Polynomial read_square_free(const Json& value, const Certificate& certificate, const Polynomial& f,
                            const std::string& where, Budget& budget)
{
  if (value.is_null()) return f;
  require_keys(value, {"polynomial", "power"}, where);
  Polynomial g = read_polynomial(value["polynomial"], certificate.dimension, where);
  const std::uint64_t exponent = number(value["power"], 1, 1000, where + " power");
  require(divides(g, f, budget), where, "does not divide the polynomial");
  Polynomial power = g;
  for (std::uint64_t k = 1; k < exponent; ++k) power = multiply(power, g, budget);
  require(divides(f, power, budget), where, "the polynomial does not divide its power");
  return g;
}

void read_reduced(const Json& value, Certificate& certificate, Budget& budget)
{
  certificate.reduced = certificate.polynomials;
  if (value.is_null()) return;
  list(value, static_cast<std::int64_t>(certificate.polynomials.size()), "square_free");
  for (std::size_t j = 0; j < certificate.reduced.size(); ++j)
    certificate.reduced[j] = read_square_free(value[j], certificate, certificate.polynomials[j],
                                              "square_free[" + std::to_string(j) + "]", budget);
}

void read_grid(const Json& box, const Json& resolution, Certificate& certificate)
{
  list(box, size_of(certificate), "box");
  list(resolution, size_of(certificate), "resolution");
  double cells = 1;
  for (std::size_t axis = 0; axis < certificate.dimension; ++axis) {
    list(box[axis], 2, "box");
    Side side{exact(box[axis][0], "box"), exact(box[axis][1], "box")};
    require(side.lower < side.upper, "box", "a side is empty or a point");
    const std::uint64_t count = number(resolution[axis], 1, max_resolution, "resolution");
    cells *= static_cast<double>(count);
    certificate.step.emplace_back((side.upper - side.lower) / mpq_class(mpz_class(static_cast<unsigned long>(count))));
    certificate.resolution.push_back(count);
    certificate.box.push_back(std::move(side));
  }
  require(cells < max_cells, "resolution", "2^62 cells or more");
}

void read_reasons(const Json& value, Certificate& certificate)
{
  for (const Json& reason : list(value, -1, "reasons"))
    require(!text(reason, "reasons").empty(), "reasons", "is empty");
  certificate.reasons = value.size();
  require(certificate.reasons <= 10, "reasons", "more than 10 entries");
}

} // namespace

Certificate read_certificate(std::string_view bytes, Budget& budget)
{
  Json root = read_json(unpack(bytes));
  require(root.is_object(), "certificate", "expected an object");
  require(root.contains("format") && root["format"] == "corral-certificate", "format", "expected 'corral-certificate'");
  require(root.contains("version") && root["version"] == 1U, "version", "expected 1");
  require_keys(root,
               {"format", "version", "dimension", "variables", "polynomials", "square_free", "box", "resolution",
                "method", "tree", "witnesses", "reasons", "empty", "hit", "unknown"},
               "certificate");
  require(root["method"] == "bernstein", "method", "expected 'bernstein'");
  Certificate result;
  result.dimension = number(root["dimension"], 1, max_dimension, "dimension");
  read_variables(root["variables"], result);
  read_polynomials(root["polynomials"], result);
  read_reduced(root["square_free"], result, budget);
  read_grid(root["box"], root["resolution"], result);
  result.tree = text(root["tree"], "tree");
  result.witnesses = std::move(root["witnesses"]);
  list(result.witnesses, -1, "witnesses");
  read_reasons(root["reasons"], result);
  result.counts.empty = number(root["empty"], 0, max_count, "empty");
  result.counts.hit = number(root["hit"], 0, max_count, "hit");
  result.counts.unknown = number(root["unknown"], 0, max_count, "unknown");
  return result;
}

} // namespace corral_check
