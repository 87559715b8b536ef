// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_AUDIT_METHOD_AUDIT_H
#define CORRAL_SRC_PROGRAM_AUDIT_METHOD_AUDIT_H

#include "../localize/engine.h"

#include <corral/audit/audit_bounder.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace corral::program {

/// What to audit, and for how long.
struct Audit_settings
{
  std::vector<std::string> numbers;
  std::vector<std::string> bounders;
  std::vector<unsigned> orders; ///< of the bounders that have one
  std::vector<std::size_t> dimensions;
  long precision = 128; ///< of number type mpfr
  std::uint64_t seed = 1;
  std::uint64_t cases = 300;           ///< generated, for each method and dimension
  std::uint64_t paper_cases = 100;     ///< on the paper's examples, as well
  std::uint64_t tightness_cases = 600; ///< as well
};

/// A value that a bound does not contain, as text.
struct Counterexample
{
  std::string origin; ///< where the case comes from
  std::string polynomial;
  std::string box;   ///< as the program reads it
  std::string point; ///< as well
  std::string value;
  std::string lower; ///< of the bound
  std::string upper;
  std::string command; ///< shows it again
};

/// What the audit saw of one bounder over one number type in one dimension.
struct Method_audit
{
  Method method;
  bool has_order = false;
  bool is_guaranteed = false;
  std::size_t dimension = 0;
  std::uint64_t cases = 0;
  std::uint64_t checks = 0;
  std::uint64_t escapes = 0;
  std::optional<Counterexample> first_escape;
  std::vector<Tightness_sample> tightness;

  /// The bounder with its order, such as `rt 2`.
  [[nodiscard]] std::string bounder_name() const
  {
    return has_order ? method.bounder + ' ' + std::to_string(method.order) : method.bounder;
  }
};

/// Whether a bounder heeds its order. \throw Invalid_input if there is no such bounder.
[[nodiscard]] bool has_order(const std::string& bounder);

/// The methods of one number type to audit, all orders of a bounder in succession.
[[nodiscard]] std::vector<Method> methods_over(const Audit_settings& settings, const std::string& number);

/// A value that a bound of `audit.method` lost, with the command that shows it again.
template <std::size_t D>
[[nodiscard]] Counterexample counterexample(const Escape<D>& escape, const Method_audit& audit,
                                            const std::string& origin);

/// \brief Audits all methods of one number type in all dimensions, dimension by dimension. Each type is compiled in a
/// source of its own, which the build makes.
/// \throw Cancelled if it is stopped.
template <IntervalNumber I>
[[nodiscard]] std::vector<Method_audit> audit_over(const Audit_settings& settings, const Run_options& run);

} // namespace corral::program

#endif
