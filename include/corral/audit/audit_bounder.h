// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_AUDIT_AUDIT_BOUNDER_H
#define CORRAL_AUDIT_AUDIT_BOUNDER_H

#include <corral/Run_options.h>
#include <corral/algebra/exact_range.h>
#include <corral/audit/Audit_options.h>
#include <corral/audit/audit_cases.h>
#include <corral/bounders/Range_bounder.h>
#include <corral/errors.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

/// \file
/// The audit of bounders: the contract of inclusion against exact rational truth, without tolerance; see doc/audit.md.
namespace corral {

/// A counterexample to inclusion: `value` is the exact value of `polynomial` at `point`, which lies in `box`.
template <std::size_t D>
struct Escape
{
  std::uint64_t case_number = 0;
  Polynomial<Rational, D> polynomial;
  Rational_box<D> box;
  Rational_point<D> point;
  Rational value;
  std::optional<Rational> lower; ///< of the bound; nothing where it is unbounded (or no number)
  std::optional<Rational> upper;
};

/// How much wider one bound is than what it encloses.
struct Tightness_sample
{
  unsigned degree = 0;  ///< the total degree
  double box_width = 0; ///< the widest side
  double ratio = 1;     ///< width(bound) / width(range) >= 1; infinite for an unbounded bound
};

/// What an audit saw.
template <std::size_t D>
struct Bounder_audit
{
  std::string bounder;
  std::string number;
  unsigned order = 0;        ///< of a Taylor method; 0 where it has none. For the caller to fill in
  std::uint64_t cases = 0;   ///< polynomials
  std::uint64_t checks = 0;  ///< exact values looked for in bounds
  std::uint64_t escapes = 0; ///< boxes with a value outside the bound
  std::optional<Escape<D>> first_escape;
  std::vector<Tightness_sample> tightness;
  bool was_stopped = false; ///< before all cases were tried
};

namespace detail {

template <IntervalNumber I, std::size_t D>
[[nodiscard]] Polynomial<I, D> enclose_coefficients(const Polynomial<Rational, D>& f)
{
  return transform<I>(f, [](const Rational& c) { return enclose<I>(c); });
}

/// The name that the bounder gives itself, or nothing.
template <class B>
[[nodiscard]] std::string name_of(const B& bounder)
{
  if constexpr (requires { std::string(bounder.method()); })
    return std::string(bounder.method());
  else if constexpr (requires { std::string(B::name); })
    return std::string(B::name);
  else
    return {};
}

template <IntervalNumber I, std::size_t D, class Make>
void audit_inclusion(const Make& make, const Audit_case<D>& example, std::uint64_t number, Bounder_audit<D>& audit)
{
  const Arithmetic_scope<I> scope;
  auto bounder = make(enclose_coefficients<I>(example.polynomial));
  if (audit.bounder.empty()) audit.bounder = name_of(bounder);
  ++audit.cases;
  for (const auto& probed : example.boxes) {
    const I bound = bounder.bound(enclose<I>(probed.box));
    audit.checks += probed.points;
    const bool lost_least = !contains(bound, probed.least);
    if (!lost_least && contains(bound, probed.greatest)) continue;
    ++audit.escapes;
    if (!audit.first_escape)
      audit.first_escape = Escape<D>{number,
                                     example.polynomial,
                                     probed.box,
                                     lost_least ? probed.lowest : probed.highest,
                                     lost_least ? probed.least : probed.greatest,
                                     exact_lower(bound),
                                     exact_upper(bound)};
  }
}

/// \brief Compares the bound of the first box with the exact range there, up to a millionth of its width. Nothing is
/// added where the range is a point or could not be had within the budget of `exact_range`.
template <IntervalNumber I, std::size_t D, class Make>
void measure_tightness(const Make& make, const Audit_case<D>& example, Bounder_audit<D>& audit)
{
  const auto& probed = example.boxes.front();
  const Rational seen = probed.greatest - probed.least;
  if (seen == 0) return;
  Rational range;
  try {
    const auto inner = exact_range(example.polynomial, probed.box, Rational(seen / 1000000)).inner;
    range = inner.upper() - inner.lower();
  } catch (const Budget_exceeded&) {
    return;
  }
  Rational box_width;
  for (const auto& side : probed.box) box_width = std::max(box_width, Rational(side.upper() - side.lower()));
  const Arithmetic_scope<I> scope;
  auto bounder = make(enclose_coefficients<I>(example.polynomial));
  const I bound = bounder.bound(enclose<I>(probed.box));
  const auto low = exact_lower(bound);
  const auto high = exact_upper(bound);
  const double ratio = low && high ? Rational((*high - *low) / range).get_d() : HUGE_VAL;
  audit.tightness.push_back({example.polynomial.total_degree(), box_width.get_d(), ratio});
}

/// \param inclusion_case,tightness  a function from the number of a case to the case, for either purpose.
template <IntervalNumber I, std::size_t D, class Make, class Inclusion_case, class Tightness_case>
[[nodiscard]] Bounder_audit<D> audit_over(const Make& make, const Audit_options& options, const Run_options& run,
                                          const Inclusion_case& inclusion_case, const Tightness_case& tightness)
{
  Bounder_audit<D> audit;
  audit.number = std::string(Interval_traits<I>::name);
  const std::uint64_t tightness_cases = D <= 3 ? options.tightness_cases : 0;
  const auto total = static_cast<double>(options.cases + tightness_cases);
  std::uint64_t done = 0;
  const auto goes_on = [&] {
    if (run.progress) run.progress(static_cast<double>(done++) / total);
    audit.was_stopped = run.stop.stop_requested();
    return !audit.was_stopped;
  };
  for (std::uint64_t i = 0; i < options.cases; ++i) {
    if (!goes_on()) return audit;
    const std::uint64_t number = options.first_case + i;
    audit_inclusion<I>(make, inclusion_case(number), number, audit);
    if (options.stop_at_first && audit.first_escape) return audit;
  }
  if constexpr (D <= 3)
    for (std::uint64_t i = 0; i < tightness_cases && goes_on(); ++i)
      measure_tightness<I>(make, tightness(options.first_case + i), audit);
  return audit;
}

} // namespace detail

/// \brief Looks for values that a bounder loses, on generated cases.
///
/// `make(f)` for a `Polynomial<I, D>` returns something whose `bound(box)` takes a `Box<I, D>` and returns an `I`; one
/// object is asked for all boxes of a case. Whatever either throws comes out. When it is stopped, before a case, what
/// was counted by then is returned. \par Complexity  Per case some dozens of exact evaluations, which outweigh most
/// bounds.
template <IntervalNumber I, std::size_t D, class Make>
[[nodiscard]] Bounder_audit<D> audit_bounder(const Make& make, const Audit_options& options = {},
                                             const Run_options& run = {})
{
  return detail::audit_over<I, D>(
      make, options, run, [&](std::uint64_t number) { return generated_case<D>(options.seed, number); },
      [&](std::uint64_t number) { return tightness_case<D>(options.seed, number); });
}

/// \brief As above on given polynomials, in turn, and boxes of their grids. \pre `subjects` is not empty.
template <IntervalNumber I, std::size_t D, class Make>
[[nodiscard]] Bounder_audit<D> audit_bounder(const Make& make, std::span<const Audit_subject<D>> subjects,
                                             const Audit_options& options = {}, const Run_options& run = {})
{
  const auto of_subject = [&](std::uint64_t number) {
    return subject_case(subjects[number % subjects.size()], options.seed, number);
  };
  return detail::audit_over<I, D>(make, options, run, of_subject, of_subject);
}

/// As above for a model of `RangeBounder`, on generated cases.
template <RangeBounder B>
[[nodiscard]] Bounder_audit<B::dimension> audit_bounder(const Audit_options& options = {}, const Run_options& run = {})
{
  return audit_bounder<typename B::Interval, B::dimension>([](const typename B::Polynomial& f) { return B(f); },
                                                           options, run);
}

/// The whole counterexample on several lines, every number exactly.
template <std::size_t D>
[[nodiscard]] std::string to_string(const Escape<D>& escape)
{
  std::string point;
  for (const Rational& x : escape.point) point += (point.empty() ? "(" : ", ") + to_string(x);
  return "  f = " + to_string(escape.polynomial) + "\n  X = " + to_string(escape.box) + "\n  x = " + point
         + ")\n  f(x) = " + to_string(escape.value) + "\n  bound(X) = ["
         + (escape.lower ? to_string(*escape.lower) : "-inf") + ", " + (escape.upper ? to_string(*escape.upper) : "inf")
         + "]\n  (case " + std::to_string(escape.case_number) + ")";
}

} // namespace corral

#endif
