// SPDX-License-Identifier: LGPL-3.0-or-later
#include "method_options.h"

#include "whole_number.h"

namespace corral::program {

void add_method_options(CLI::App& command, Method& method)
{
  command.add_option("--bounder", method.bounder, "how ranges are bounded; see corral list")->capture_default_str();
  command.add_option("--order", method.order, "order of the recursive Taylor method")
      ->check(whole_number(1))
      ->capture_default_str();
  command.add_option("--number", method.number, "number type; see corral list")->capture_default_str();
  command.add_option("--precision", method.precision, "bits of number type mpfr")
      ->check(whole_number(1))
      ->capture_default_str();
}

} // namespace corral::program
