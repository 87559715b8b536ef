// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Evidence_text.h"

#include <corral/number/format.h>
#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/print.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

namespace corral::program {

namespace {

using Json = nlohmann::ordered_json;

template <std::size_t D>
std::string point_text(const Rational_point<D>& point)
{
  std::string text = "(";
  for (std::size_t axis = 0; axis < D; ++axis) text += (axis == 0 ? "" : ", ") + to_string(point[axis]);
  return text + ")";
}

template <std::size_t D>
Json point_json(const Rational_point<D>& point)
{
  Json result = Json::array();
  for (const Rational& x : point) result.push_back(to_string(x));
  return result;
}

// The signs that prove a hit, one for each polynomial, or of the one polynomial at both points. With a common factor
// of a system there is nothing to show: the factor changes its sign, not the polynomials.
template <std::size_t D>
std::vector<int> checked_signs(const Sign_change<D>& change, const std::vector<Polynomial<Rational, D>>& subjects)
{
  std::vector<int> signs;
  if (change.first == change.second) {
    for (const auto& f : subjects) signs.push_back(sgn(evaluate(f, change.first)));
    if (std::any_of(signs.begin(), signs.end(), [](int sign) { return sign != 0; }))
      throw std::logic_error("audit: a witness is no zero; please report this");
  } else if (subjects.size() == 1) {
    signs = {sgn(evaluate(subjects[0], change.first)), sgn(evaluate(subjects[0], change.second))};
    if (signs[0] * signs[1] > 0) throw std::logic_error("audit: a witness shows no change of sign; please report this");
  }
  return signs;
}

std::string relation(int sign) { return sign > 0 ? " > 0" : sign < 0 ? " < 0" : " = 0"; }

template <std::size_t D>
std::string hit_text(const Sign_change<D>& change, const std::vector<Polynomial<Rational, D>>& subjects,
                     const std::string& name)
{
  const auto signs = checked_signs(change, subjects);
  if (change.first == change.second) return "a zero at " + point_text<D>(change.first);
  if (signs.empty())
    return "a common factor changes sign between " + point_text<D>(change.first) + " and "
           + point_text<D>(change.second);
  return name + relation(signs[0]) + " at " + point_text<D>(change.first) + ", " + name + relation(signs[1]) + " at "
         + point_text<D>(change.second);
}

template <std::size_t D>
std::string hit_text(const Triangular_zero<D>& zero, const std::array<std::string, D>& variables)
{
  const auto is_point = [](const Rational_interval& side) { return side.lower() == side.upper(); };
  if (std::all_of(zero.box.begin(), zero.box.end(), is_point)) {
    Rational_point<D> point;
    for (std::size_t axis = 0; axis < D; ++axis) point[axis] = zero.box[axis].lower();
    return "a zero at " + point_text<D>(point);
  }
  constexpr int digits = 10;
  std::string text = "an algebraic zero with";
  for (std::size_t axis = 0; axis < D; ++axis) {
    const auto& side = zero.box[axis];
    text += (axis == 0 ? " " : ", ") + variables[axis];
    text += is_point(side) ? " = " + to_string(side.lower()) : " in " + decimal_text(side, digits);
  }
  return text;
}

} // namespace

template <std::size_t D>
std::string evidence_text(const Evidence<D>& evidence, const std::vector<Polynomial<Rational, D>>& subjects,
                          const std::array<std::string, D>& variables, const std::string& subject_name)
{
  const auto& decision = evidence.decision;
  if (decision.verdict == Verdict::unknown) return decision.reason;
  if (const auto* change = std::get_if<Sign_change<D>>(&decision.witness))
    return hit_text(*change, subjects, subject_name);
  if (const auto* zero = std::get_if<Triangular_zero<D>>(&decision.witness)) return hit_text<D>(*zero, variables);
  if (evidence.bounded) {
    constexpr int digits = 6;
    const std::string which = subjects.size() == 1 ? "" : std::to_string(*evidence.bounded + 1);
    return 'f' + which + " in " + decimal_text(evidence.bound, digits) + " there";
  }
  return std::string(decision.verdict == Verdict::hit ? "a zero" : "no zero") + ", decided by "
         + std::string(rung_names[static_cast<std::size_t>(decision.rung)]);
}

template <std::size_t D>
Json evidence_json(const Evidence<D>& evidence, const std::vector<Polynomial<Rational, D>>& subjects,
                   const std::array<std::string, D>& variables)
{
  const auto& decision = evidence.decision;
  if (decision.verdict == Verdict::unknown) return {{"reason", decision.reason}};
  Json result{{"rung", rung_names[static_cast<std::size_t>(decision.rung)]}};
  if (const auto* change = std::get_if<Sign_change<D>>(&decision.witness)) {
    result["points"] = Json::array({point_json<D>(change->first)});
    if (change->first != change->second) result["points"].push_back(point_json<D>(change->second));
    if (const auto signs = checked_signs(*change, subjects); !signs.empty()) result["signs"] = signs;
  } else if (const auto* zero = std::get_if<Triangular_zero<D>>(&decision.witness)) {
    Json& triangular = result["triangular"];
    triangular["order"] = zero->order;
    for (const auto& element : zero->chain) triangular["chain"].push_back(to_string(element, variables));
    for (const auto& side : zero->box) triangular["box"].push_back({to_string(side.lower()), to_string(side.upper())});
  } else if (evidence.bounded) {
    result["polynomial"] = *evidence.bounded + 1;
    result["bounder"] = "bernstein";
    result["bound"] = {to_string(evidence.bound.lower()), to_string(evidence.bound.upper())};
  }
  return result;
}

#define CORRAL_INSTANTIATE(D)                                                                                          \
  template std::string evidence_text(const Evidence<D>&, const std::vector<Polynomial<Rational, D>>&,                  \
                                     const std::array<std::string, D>&, const std::string&);                           \
  template Json evidence_json(const Evidence<D>&, const std::vector<Polynomial<Rational, D>>&,                         \
                              const std::array<std::string, D>&);
CORRAL_INSTANTIATE(1)
CORRAL_INSTANTIATE(2)
CORRAL_INSTANTIATE(3)

} // namespace corral::program
