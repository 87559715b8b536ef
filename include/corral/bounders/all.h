// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BOUNDERS_ALL_H
#define CORRAL_BOUNDERS_ALL_H

#include <corral/bounders/Affine_bounder.h>
#include <corral/bounders/Bernstein_bounder.h>
#include <corral/bounders/Centred_bounder.h>
#include <corral/bounders/Horner_bounder.h>
#include <corral/bounders/Intersection_bounder.h>
#include <corral/bounders/Mean_value_bounder.h>
#include <corral/bounders/Modified_affine_bounder.h>
#include <corral/bounders/Natural_bounder.h>
#include <corral/bounders/Recursive_taylor_bounder.h>
#include <corral/errors.h>
#include <corral/number/Rational_interval.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>

/// \file
/// The list of all bounders: one line each. It feeds the conformance tests and the choice by name.
namespace corral {

/// A list of bounders that can be chosen by name.
template <template <IntervalNumber, std::size_t> class... B>
struct Bounder_list
{
  static_assert(sizeof...(B) > 0);

  /// The bounders of one number type and dimension as the arguments of a template.
  template <template <class...> class Pack, IntervalNumber I, std::size_t D>
  using apply = Pack<B<I, D>...>;

  /// Calls `function(std::type_identity<B<I, D>>{})` for each bounder, in order.
  template <IntervalNumber I, std::size_t D, class Function>
  static void for_each(const Function& function)
  {
    (function(std::type_identity<B<I, D>>{}), ...);
  }

  /// \brief Calls `function(std::type_identity<B<I, D>>{})` for the bounder of this name.
  /// \throw Invalid_input if no bounder has the name.
  template <IntervalNumber I, std::size_t D, class Function>
  static void visit(std::string_view name, const Function& function)
  {
    const auto is_it = [&](auto bounder) {
      if (name != decltype(bounder)::type::name) return false;
      function(bounder);
      return true;
    };
    if (!(is_it(std::type_identity<B<I, D>>{}) || ...))
      throw Invalid_input("bounder: given '" + std::string(name) + "'; expected one of " + names());
  }

  /// The names, separated by ", ".
  static std::string names()
  {
    std::string result;
    for_each<Rational_interval, 1>(
        [&](auto bounder) { result.append(result.empty() ? "" : ", ").append(decltype(bounder)::type::name); });
    return result;
  }
};

/// The intersection of the two methods whose bounds complement each other best.
template <IntervalNumber I, std::size_t D>
using Best_intersection = Intersection_bounder<Modified_affine_bounder<I, D>, Bernstein_bounder<I, D>>;

/// All bounders, each once.
using Bounders = Bounder_list<Recursive_taylor_bounder, //
                              Modified_affine_bounder,  //
                              Natural_bounder,          //
                              Horner_bounder,           //
                              Centred_bounder,          //
                              Affine_bounder,           //
                              Bernstein_bounder,        //
                              Mean_value_bounder,       //
                              Best_intersection>;       //

} // namespace corral

#endif
