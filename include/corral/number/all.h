// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_ALL_H
#define CORRAL_NUMBER_ALL_H

#include <corral/errors.h>
#include <corral/number/Cgal_interval.h>
#include <corral/number/Counted.h>
#include <corral/number/Mpfr_interval.h>
#include <corral/number/Nearest_interval.h>
#include <corral/number/Outward_interval.h>
#include <corral/number/Rational_interval.h>

#include <string>
#include <string_view>
#include <type_traits>

/// \file
/// The list of all number types: one line each.
namespace corral {

/// A list of interval numbers that can be chosen by name.
template <IntervalNumber... I>
struct Number_type_list
{
  /// Calls `function(std::type_identity<I>{})` for each type, in order.
  template <class Function>
  static void for_each(const Function& function)
  {
    (function(std::type_identity<I>{}), ...);
  }

  /// \brief Calls `function(std::type_identity<I>{})` for the type of this name and returns its result.
  /// \throw Invalid_input if no type has the name.
  template <class Function>
  static decltype(auto) visit(std::string_view name, const Function& function)
  {
    return visit_first<Function, I...>(name, function);
  }

  /// The names, separated by ", ".
  static std::string names()
  {
    std::string result;
    ((result.append(result.empty() ? "" : ", ").append(Interval_traits<I>::name)), ...);
    return result;
  }

private:
  template <class Function, class First, class... Rest>
  static decltype(auto) visit_first(std::string_view name, const Function& function)
  {
    if (name == Interval_traits<First>::name) return function(std::type_identity<First>{});
    if constexpr (sizeof...(Rest) > 0)
      return visit_first<Function, Rest...>(name, function);
    else
      throw Invalid_input("number type: given '" + std::string(name) + "'; expected one of " + names());
  }
};

/// All number types, each once.
using Number_types = Number_type_list<Nearest_interval,           //
                                      Outward_interval,           //
                                      Cgal_interval,              //
                                      Mpfr_interval,              //
                                      Rational_interval,          //
                                      Counted<Outward_interval>>; //

} // namespace corral

#endif
