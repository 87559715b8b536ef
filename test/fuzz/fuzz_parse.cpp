// SPDX-License-Identifier: LGPL-3.0-or-later
// libFuzzer: no text crashes the parser, what is read prints and reads back the same, and a polynomial is read the same
// as a quotient.
#include <corral/polynomial/parse.h>
#include <corral/polynomial/print.h>

#include <cstdint>
#include <cstdlib>

namespace {

void require(bool condition)
{
  if (!condition) std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::array<std::string, 3> variables = {"x", "y", "xy1"};
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const auto f = corral::parse_rational_function<3>(text, variables);
    require(!f.denominator.is_zero());
    require(corral::parse_polynomial<3>(corral::to_string(f.numerator, variables), variables) == f.numerator);
    if (!f.has_poles()) require(corral::parse_polynomial<3>(text, variables) == f.numerator);
    static_cast<void>(corral::variables_in(text));
  } catch (const corral::Parse_error& error) {
    require(error.position <= size);
  } catch (const corral::Budget_exceeded&) {
  }
  return 0;
}
