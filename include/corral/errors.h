// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_ERRORS_H
#define CORRAL_ERRORS_H

#include <corral/build_mode.h>

#include <cstddef>
#include <stdexcept>
#include <string>

/// \file
/// The errors of the library, one class for each kind of failure. Every message says who
/// complains, what was given and what was expected, on one line.
namespace corral {

/// The caller broke a documented precondition. Never thrown for input that is merely hard.
struct Invalid_input : std::invalid_argument
{
  using std::invalid_argument::invalid_argument;
};

/// A text is not a number or a polynomial. `position` is the offset in bytes of the first
/// character that cannot be read.
struct Parse_error : Invalid_input
{
  Parse_error(const std::string& message, std::size_t where) : Invalid_input(message), position(where) {}
  std::size_t position;
};

/// A result would not fit the stated budget (cells, terms, memory). The request is well formed.
struct Budget_exceeded : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// The caller asked to stop a computation of which no part is worth keeping.
struct Cancelled : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// The floating-point environment does not round as IEEE 754 says, so that no bound computed
/// in it could be trusted.
struct Unsafe_environment : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// A file could not be written whole. Nothing is left under the requested name.
struct Output_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

namespace detail {

/// \throw Invalid_input always.
[[noreturn]] inline void refuse_input(const char* complaint) { throw Invalid_input(complaint); }

/// "1 side", "2 sides", for messages.
[[nodiscard]] inline std::string quantity(std::size_t count, const std::string& noun)
{
  return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

} // namespace detail

} // namespace corral

/// \def CORRAL_PRECONDITION(condition, complaint)
/// Throws `Invalid_input` with the complaint unless the condition holds. For preconditions that are dear to check, and
/// so only where assertions are on: without NDEBUG, or with CORRAL_CHECK_PRECONDITIONS. Cheap ones are always checked.
#if !defined NDEBUG || defined CORRAL_CHECK_PRECONDITIONS
#define CORRAL_PRECONDITION(condition, complaint)                                                                      \
  (static_cast<bool>(condition) ? static_cast<void>(0) : ::corral::detail::refuse_input(complaint))
#else
#define CORRAL_PRECONDITION(condition, complaint) static_cast<void>(sizeof(static_cast<bool>(condition)))
#endif

#endif
