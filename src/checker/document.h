// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_DOCUMENT_H
#define CORRAL_CHECKER_DOCUMENT_H

#include "failure.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace corral_check {

using Json = nlohmann::json;

/// The JSON text in the bytes of a file, which may be gzip. \throw Rejected if it is damaged or too long.
[[nodiscard]] std::string unpack(std::string_view bytes);

/// Reads a JSON text by the rules of section 1: no duplicate key, no number but a small natural one, bounded nesting.
/// \throw Rejected for anything else.
[[nodiscard]] Json read_json(std::string_view text);

/// An object with just these keys.
void require_keys(const Json& value, std::initializer_list<const char*> keys, const std::string& where);

/// A list; if `size` is not negative, of that many entries.
const Json& list(const Json& value, std::int64_t size, const std::string& where);

/// A JSON number from `least` to `most`.
[[nodiscard]] std::uint64_t number(const Json& value, std::uint64_t least, std::uint64_t most,
                                   const std::string& where);

[[nodiscard]] const std::string& text(const Json& value, const std::string& where);

/// An exact text.
[[nodiscard]] mpq_class exact(const Json& value, const std::string& where);

} // namespace corral_check

#endif
