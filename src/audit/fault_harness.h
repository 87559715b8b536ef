// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_AUDIT_FAULT_HARNESS_H
#define CORRAL_AUDIT_FAULT_HARNESS_H

#include "Fault_finding.h"

#include <corral/audit/Audit_options.h>
#include <corral/number/Rational_interval.h>
#include <corral/polynomial/Box.h>
#include <corral/polynomial/Polynomial.h>

#include <functional>
#include <string>
#include <vector>

/// \file
/// What the lists of faults share. Faults of a method are planted in bounders over exact rationals, where no rounding
/// hides them, of polynomials in two variables.
namespace corral::audit {

using Exact_box = Rational_box<2>;
using Exact_polynomial = Polynomial<Rational, 2>;

/// A bounder of any class, as a value.
struct Exact_bounder
{
  std::function<Rational_interval(const Exact_box&)> function;
  [[nodiscard]] Rational_interval bound(const Exact_box& box) { return function(box); }
};

/// Makes the bounder of a polynomial.
using Exact_maker = std::function<Exact_bounder(const Exact_polynomial&)>;

/// A bounder with a fault, or a sound one as a control.
struct Planted_bounder
{
  std::string name;
  std::string description;
  Exact_maker make;
};

/// The maker of a class that has a constructor from a polynomial, `bound`, `name` and `description`.
template <class Bounder>
[[nodiscard]] Planted_bounder planted()
{
  const auto make = [](const Exact_polynomial& f) {
    return Exact_bounder{[bounder = Bounder(f)](const Exact_box& box) mutable { return bounder.bound(box); }};
  };
  return {std::string(Bounder::name), std::string(Bounder::description), make};
}

/// Audits one bounder until the first escape.
[[nodiscard]] Fault_finding look_for(const Planted_bounder& bounder, const Audit_options& options);

// One list for each kind of fault, and what each was made from.
[[nodiscard]] std::vector<Fault_finding> seed_number_faults(const Audit_options& options);
[[nodiscard]] std::vector<Fault_finding> seed_no_number_fault(const Audit_options& options);
[[nodiscard]] std::vector<Planted_bounder> expansion_faults();
[[nodiscard]] std::vector<Planted_bounder> sound_expansions();
[[nodiscard]] std::vector<Planted_bounder> method_faults();
[[nodiscard]] std::vector<Planted_bounder> sound_methods();
[[nodiscard]] std::vector<Planted_bounder> taylor_form_faults();
[[nodiscard]] std::vector<Planted_bounder> sound_taylor_forms();

} // namespace corral::audit

#endif
