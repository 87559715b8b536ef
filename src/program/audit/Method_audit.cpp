// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Method_audit.h"

#include "../bound/make_bounder.h"

#include <corral/polynomial/print.h>

#include <concepts>

namespace corral::program {

bool has_order(const std::string& bounder)
{
  bool result = false;
  Bounders::visit<Rational_interval, 1>(bounder, [&]<class B>(std::type_identity<B>) {
    result = std::constructible_from<B, const typename B::Polynomial&, const Bounder_options&>;
  });
  return result;
}

std::vector<Method> methods_over(const Audit_settings& settings, const std::string& number)
{
  std::vector<Method> methods;
  for (const auto& bounder : settings.bounders) {
    const Method method{.bounder = bounder, .number = number, .precision = settings.precision};
    if (!has_order(bounder)) {
      methods.push_back(method);
      continue;
    }
    for (const unsigned order : settings.orders) {
      methods.push_back(method);
      methods.back().order = order;
    }
  }
  return methods;
}

template <std::size_t D>
Counterexample counterexample(const Escape<D>& escape, const Method_audit& audit, const std::string& origin)
{
  Counterexample result;
  result.origin = origin;
  result.polynomial = to_string(escape.polynomial);
  for (std::size_t axis = 0; axis < D; ++axis) {
    const std::string separator = axis == 0 ? "" : ",";
    result.box += separator + to_string(escape.box[axis].lower()) + ':' + to_string(escape.box[axis].upper());
    result.point += separator + to_string(escape.point[axis]);
  }
  result.value = to_string(escape.value);
  result.lower = escape.lower ? to_string(*escape.lower) : "-inf";
  result.upper = escape.upper ? to_string(*escape.upper) : "inf";
  const Method& method = audit.method;
  result.command = "corral bound '" + result.polynomial + "' --box " + result.box + " --bounder " + method.bounder;
  if (audit.has_order) result.command += " --order " + std::to_string(method.order);
  result.command += " --number " + method.number;
  if (method.number == "mpfr") result.command += " --precision " + std::to_string(method.precision);
  result.command += " --at " + result.point;
  return result;
}

template Counterexample counterexample(const Escape<1>&, const Method_audit&, const std::string&);
template Counterexample counterexample(const Escape<2>&, const Method_audit&, const std::string&);
template Counterexample counterexample(const Escape<3>&, const Method_audit&, const std::string&);

} // namespace corral::program
