// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_FAULT_H
#define CORRAL_CHECKER_FAULT_H

#include <corral_check/check.h>

#include <cstddef>
#include <optional>
#include <string>

namespace corral_check {

/// A place in the file: in words, and where the text has it.
struct Place
{
  std::string words;
  std::optional<std::size_t> byte{};
};

[[noreturn]] inline void reject(const Place& place, const std::string& why)
{
  throw Rejected(place.words, why, place.byte);
}

inline void require(bool condition, const Place& place, const char* why)
{
  if (!condition) reject(place, why);
}

/// Keeps to a limit of section 7.
inline void limit(bool condition, const Place& place, const char* why)
{
  if (!condition) throw Stopped(place.words, why, place.byte);
}

} // namespace corral_check

#endif
