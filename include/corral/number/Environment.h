// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_NUMBER_ENVIRONMENT_H
#define CORRAL_NUMBER_ENVIRONMENT_H

#include <corral/build_mode.h>

#include <cfloat>
#include <limits>
#include <string_view>

/// \file
/// The self-check of the floating-point environment. Bounds in doubles are proved for IEEE 754 arithmetic; a process
/// may not have it: a library linked with -ffast-math sets flush-to-zero for everybody, another forgets to restore the
/// rounding mode, a compiler option contracts a*b+c. Then no bound is better than a guess, and Corral refuses.
namespace corral {

static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0,
              "Corral needs IEEE 754 doubles without excess precision (on 32-bit x86: -msse2 -mfpmath=sse)");

/// Why doubles cannot be trusted.
enum class Environment_fault {
  none,
  subnormal_operands, ///< subnormal operands are read as zero (DAZ)
  subnormal_results,  ///< subnormal results are flushed to zero (FTZ)
  rounding_mode,      ///< operations do not round to nearest
  directed_rounding,  ///< operations do not follow the rounding mode
  contraction,        ///< a*b+c is rounded once
  reassociation       ///< the compiler reorders sums
};

/// What is wrong, in words; empty for `none`.
[[nodiscard]] std::string_view to_string(Environment_fault fault);

/// \throw Unsafe_environment always, naming the fault.
[[noreturn]] void refuse_environment(Environment_fault fault);

/// \brief Whether subnormal numbers are lost.
///
/// All checks are inlined so that they see the options of the translation unit that computes, and work on volatile
/// data so that the processor and not the compiler answers.
[[nodiscard, gnu::always_inline]] inline Environment_fault find_subnormal_fault()
{
  volatile double smallest = std::numeric_limits<double>::denorm_min();
  volatile double smallest_normal = std::numeric_limits<double>::min();
  volatile double large = 0x1p1000;
  volatile double half = 0.5;
  if (smallest * large == 0) return Environment_fault::subnormal_operands;
  if (smallest_normal * half == 0) return Environment_fault::subnormal_results;
  return Environment_fault::none;
}

/// Whether the thread rounds sums to nearest.
[[nodiscard, gnu::always_inline]] inline bool rounds_to_nearest()
{
  volatile double one_again = 1;
  volatile double tiny_again = 0x1p-60;
  const double one = one_again;
  const double tiny = tiny_again;
  volatile double sum = one + tiny;
  volatile double difference = one - tiny;
  return sum == one && difference == one;
}

/// Whether the thread rounds sums upward.
[[nodiscard, gnu::always_inline]] inline bool rounds_upward()
{
  volatile double one = 1;
  volatile double tiny = 0x1p-60;
  volatile double sum = one + tiny;
  return sum > 1;
}

/// \brief The first fault of the current thread's environment.
/// \par Complexity  A dozen floating-point operations.
[[nodiscard, gnu::always_inline]] inline Environment_fault find_environment_fault()
{
  if (const auto fault = find_subnormal_fault(); fault != Environment_fault::none) return fault;
  volatile double one_again = 1;
  volatile double tiny_again = 0x1p-60;
  volatile double factor_again = 1 + 0x1p-30;
  volatile double rounded_square = 1 + 0x1p-29;
  const double one = one_again;
  const double tiny = tiny_again;
  if (!rounds_to_nearest()) return Environment_fault::rounding_mode;
  if ((one + tiny) - one != 0) return Environment_fault::reassociation;
  const double factor = factor_again; // its square is 1 + 2^-29 + 2^-60
  if (factor * factor - rounded_square != 0) return Environment_fault::contraction;
  return Environment_fault::none;
}

/// \brief The guard of number types that need nothing but IEEE 754 doubles rounding to nearest.
struct Nearest_scope
{
  /// \throw Unsafe_environment if the thread's doubles are anything else.
  [[gnu::always_inline]] Nearest_scope()
  {
    if (const auto fault = find_environment_fault(); fault != Environment_fault::none) refuse_environment(fault);
  }
};

} // namespace corral

#endif
