// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Formula.h"

#include "one_line.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string_view>

namespace corral::program {

namespace {

constexpr std::size_t max_file_size = std::size_t{64} << 20;
constexpr std::string_view blanks = " \t\r\n\v\f";

std::string read_all(std::istream& in, const std::string& name)
{
  std::string text;
  char buffer[1 << 16];
  while (in.read(buffer, sizeof buffer), in.gcount() > 0) {
    text.append(buffer, static_cast<std::size_t>(in.gcount()));
    if (text.size() > max_file_size) throw Invalid_input("polynomial: " + name + " is larger than 64 MiB");
  }
  if (in.bad()) throw Invalid_input("polynomial: cannot read " + name);
  return text;
}

std::size_t characters_in(std::string_view text)
{
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins));
}

// Cuts a text into formulas, line by line.
class Formula_cutter
{
public:
  Formula_cutter(std::string text, std::string name) : text_(std::move(text)), name_(std::move(name)) {}

  std::vector<Formula> cut()
  {
    for (std::size_t begin = 0, line = 1; begin < text_.size(); ++line) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      if (const auto code = code_of(begin, end); !code.empty()) {
        if (!is_open_) {
          first_ = begin;
          first_line_ = line;
        }
        last_ = end;
        is_open_ = goes_on(code);
        if (!is_open_) finish();
      }
      begin = end + 1;
    }
    if (is_open_) finish();
    return std::move(formulas_);
  }

private:
  // The line without comment and blanks around it.
  std::string_view code_of(std::size_t begin, std::size_t end) const
  {
    std::string_view code(text_.data() + begin, end - begin);
    if (begin == 0 && code.starts_with("\xef\xbb\xbf")) code.remove_prefix(3);
    code = code.substr(0, code.find('#'));
    const auto last = code.find_last_not_of(blanks);
    return code.substr(0, last == std::string_view::npos ? 0 : last + 1);
  }

  bool goes_on(std::string_view code)
  {
    depth_ += std::count(code.begin(), code.end(), '(') - std::count(code.begin(), code.end(), ')');
    if (code.back() != '\\')
      return depth_ > 0 || std::string_view("+-*/^=").find(code.back()) != std::string_view::npos;
    text_[static_cast<std::size_t>(code.data() + code.size() - 1 - text_.data())] = ' ';
    return true;
  }

  void finish()
  {
    formulas_.emplace_back(text_.substr(first_, last_ - first_), name_, first_line_);
    depth_ = 0;
    is_open_ = false;
  }

  std::string text_;
  std::string name_;
  std::vector<Formula> formulas_;
  std::size_t first_ = 0;
  std::size_t first_line_ = 1;
  std::size_t last_ = 0;
  std::ptrdiff_t depth_ = 0;
  bool is_open_ = false;
};

// A number on a line of its own is what is left of a formula that was broken without a mark.
void require_variables(const std::vector<Formula>& formulas)
{
  const auto is_letter = [](char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; };
  for (const auto& formula : formulas)
    if (formulas.size() > 1 && std::none_of(formula.text.begin(), formula.text.end(), is_letter))
      throw Invalid_input("polynomial: " + formula.file + ", line " + std::to_string(formula.line)
                          + " is a number; expected a polynomial on each line; a line that goes on ends in \\");
}

std::vector<Formula> formulas_in(const std::string& argument)
{
  if (argument.empty() || argument[0] != '@') {
    auto formulas = Formula_cutter(argument, "").cut();
    return formulas.empty() ? std::vector<Formula>{Formula(argument)} : std::move(formulas);
  }
  const std::string path = argument.substr(1);
  const std::string name = path == "-" ? "standard input" : "file '" + path + "'";
  std::string text;
  if (path == "-")
    text = read_all(std::cin, name);
  else {
    std::ifstream in(path, std::ios::binary);
    if (!in) throw Invalid_input("polynomial: cannot read " + name + ": " + std::strerror(errno));
    text = read_all(in, name);
  }
  auto formulas = Formula_cutter(std::move(text), name).cut();
  if (formulas.empty()) throw Invalid_input("polynomial: " + name + " has none; expected one a line");
  require_variables(formulas);
  return formulas;
}

// A line of a file around a place in it, and a caret under the place.
std::string marked(std::string_view line, std::size_t place)
{
  constexpr std::size_t most = 60; // bytes on each side
  const std::size_t begin = place > most ? place - most : 0;
  const std::string before = one_line(line.substr(begin, place - begin));
  return "  " + before + one_line(line.substr(place, most)) + "\n  " + std::string(characters_in(before), ' ') + "^";
}

} // namespace

std::vector<Formula> formulas_of(const std::vector<std::string>& arguments)
{
  std::vector<Formula> result;
  for (const auto& argument : arguments) {
    auto formulas = formulas_in(argument);
    std::move(formulas.begin(), formulas.end(), std::back_inserter(result));
  }
  return result;
}

Formula single_formula_of(const std::string& argument)
{
  auto formulas = formulas_in(argument);
  if (formulas.size() > 1)
    throw Invalid_input("polynomial: given " + std::to_string(formulas.size()) + " of them, one a line"
                        + (formulas[0].file.empty() ? "" : " of " + formulas[0].file)
                        + "; expected one; a line that goes on ends in \\");
  return std::move(formulas[0]);
}

std::vector<std::string> texts_of(const std::vector<Formula>& formulas)
{
  std::vector<std::string> texts;
  for (const auto& formula : formulas) texts.push_back(formula.text);
  return texts;
}

void fail_in(const Formula& formula, const detail::Polynomial_error& error)
{
  if (formula.file.empty()) throw error;
  const std::string_view text = formula.text;
  const std::size_t place = std::min(error.position, text.size());
  const std::string_view before = text.substr(0, place);
  const std::size_t begin = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  const auto lines = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  const std::string_view line = text.substr(begin, text.find('\n', begin) - begin);
  std::size_t column = 1 + characters_in(line.substr(0, place - begin));
  if (begin == 0 && line.starts_with("\xef\xbb\xbf")) --column;
  throw Formula_error(formula.file + ", line " + std::to_string(formula.line + lines) + ", column "
                          + std::to_string(column) + ": " + error.reason,
                      marked(line, place - begin));
}

} // namespace corral::program
