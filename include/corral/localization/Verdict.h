// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_LOCALIZATION_VERDICT_H
#define CORRAL_LOCALIZATION_VERDICT_H

#include <cstdint>
#include <string_view>

namespace corral {

/// What is known of one closed cell. `unknown` is a value and not an error.
enum class Verdict : std::uint8_t {
  empty,   ///< proved: no real zero in the closed cell
  unknown, ///< neither proved
  hit      ///< proved: a real zero in the closed cell
};

[[nodiscard]] constexpr std::string_view to_string(Verdict verdict)
{
  switch (verdict) {
  case Verdict::empty:
    return "empty";
  case Verdict::hit:
    return "hit";
  case Verdict::unknown:
    break;
  }
  return "unknown";
}

} // namespace corral

#endif
