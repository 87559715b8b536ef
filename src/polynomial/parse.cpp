// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/internal/polynomial/Polynomial_lexer.h>
#include <corral/polynomial/parse.h>

#include "names.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>

namespace corral {

std::vector<std::string> variables_in(std::string_view text)
{
  std::set<std::string, std::less<>> names;
  for (detail::Polynomial_lexer lexer(text); lexer.token().kind != detail::Token::end;) {
    if (lexer.token().kind == detail::Token::name) names.emplace(lexer.token().text);
    if (lexer.token().kind == detail::Token::caret)
      static_cast<void>(lexer.exponent());
    else
      lexer.advance();
  }
  return {names.begin(), names.end()};
}

namespace detail {

std::vector<std::string> without_products(const std::vector<std::string>& names)
{
  std::vector<std::string> result;
  const auto is_product = [&](const std::string& name) {
    auto others = names;
    std::erase(others, name);
    return !readings_of(name, others).empty();
  };
  std::copy_if(names.begin(), names.end(), std::back_inserter(result), std::not_fn(is_product));
  return result;
}

std::string meaning_of_name(std::string_view name, const std::vector<std::string>& variables)
{
  return is_function_name(name) ? "; " + why_no_polynomial(name) : what_may_be_meant(name, variables);
}

} // namespace detail

} // namespace corral
