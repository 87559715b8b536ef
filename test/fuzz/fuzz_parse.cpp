// SPDX-License-Identifier: LGPL-3.0-or-later
// libFuzzer: no text crashes the parser, and what is read prints and reads back the same.
#include <corral/polynomial/parse.h>
#include <corral/polynomial/print.h>

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::array<std::string, 2> variables = {"x", "y"};
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const auto f = corral::parse_polynomial<2>(text, variables);
    if (!(corral::parse_polynomial<2>(corral::to_string(f, variables), variables) == f)) std::abort();
  } catch (const corral::Parse_error&) {
  } catch (const corral::Budget_exceeded&) {
  }
  return 0;
}
