// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_GEOMETRY_REFERENCE_CURVES_H
#define CORRAL_TEST_GEOMETRY_REFERENCE_CURVES_H

#include <corral/polynomial/Box.h>
#include <corral/polynomial/parse.h>

#include <nlohmann/json.hpp>

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace corral::test {

/// A curve with a box around its compact part, and its counts.
struct Reference_curve
{
  std::string name;
  Polynomial<Rational, 2> f;
  Rational_box<2> box;
  std::size_t components;
  std::size_t closed;
  std::size_t isolated;
};

/// The list in reference_curves.json, in a folder.
inline std::vector<Reference_curve> reference_curves(const std::string& folder)
{
  std::ifstream file(folder + "/reference_curves.json");
  if (!file) throw std::runtime_error("reference_curves.json is not in " + folder);
  std::vector<Reference_curve> result;
  for (const auto& entry : nlohmann::json::parse(file)) {
    Reference_curve curve{entry["name"],
                          parse_polynomial<2>(entry["polynomial"].get<std::string>(), {"x", "y"}),
                          {},
                          entry["components"],
                          entry["closed_components"],
                          entry["isolated_points"]};
    for (std::size_t k = 0; k < 2; ++k)
      curve.box[k] = {parse_rational(entry["box"][k][0].get<std::string>()),
                      parse_rational(entry["box"][k][1].get<std::string>())};
    result.push_back(std::move(curve));
  }
  return result;
}

} // namespace corral::test

#endif
