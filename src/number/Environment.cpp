// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/errors.h>
#include <corral/number/Environment.h>

#include <string>

namespace corral {

std::string_view to_string(Environment_fault fault)
{
  switch (fault) {
  case Environment_fault::subnormal_operands:
    return "subnormal operands are read as zero (denormals-are-zero mode)";
  case Environment_fault::subnormal_results:
    return "subnormal results are replaced by zero (flush-to-zero mode)";
  case Environment_fault::rounding_mode:
    return "the rounding mode is not to nearest";
  case Environment_fault::directed_rounding:
    return "operations do not follow the rounding mode (compile with -frounding-math)";
  case Environment_fault::contraction:
    return "a*b+c is computed with one rounding (compile with -ffp-contract=off)";
  case Environment_fault::reassociation:
    return "sums are reordered by the compiler (compile without -ffast-math and -fassociative-math)";
  case Environment_fault::none:
    break;
  }
  return "";
}

void refuse_environment(Environment_fault fault)
{
  throw Unsafe_environment("floating-point environment: " + std::string(to_string(fault))
                           + "; expected IEEE 754 doubles, subnormals included");
}

} // namespace corral
