// SPDX-License-Identifier: LGPL-3.0-or-later
#include "json.h"

#include "json_syntax.h"

#include <algorithm>

namespace corral_check {
namespace {

constexpr std::size_t max_digits = 100000;

bool is_digits(std::string_view part)
{
  return !part.empty() && part.front() != '0'
         && std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool has_exact_syntax(std::string_view part)
{
  if (part == "0") return true;
  if (!part.empty() && part.front() == '-') part.remove_prefix(1);
  const auto slash = part.find('/');
  if (slash == std::string_view::npos) return is_digits(part);
  return is_digits(part.substr(0, slash)) && is_digits(part.substr(slash + 1));
}

} // namespace

std::string Value::string(const std::string& where) const
{
  require(document_[begin_] == '"', place(where), "expected a string");
  return unescaped(document_.substr(begin_, end_ - begin_));
}

std::uint64_t Value::number(std::uint64_t least, std::uint64_t most, const std::string& where) const
{
  require(document_[begin_] >= '0' && document_[begin_] <= '9', place(where), "expected a JSON number");
  std::uint64_t result = 0;
  for (std::size_t at = begin_; at < end_; ++at) result = result * 10 + static_cast<std::uint64_t>(document_[at] - '0');
  if (result < least || result > most)
    reject(place(where),
           "is " + std::to_string(result) + "; expected " + std::to_string(least) + " to " + std::to_string(most));
  return result;
}

mpq_class Value::exact(const std::string& where) const
{
  const std::string digits = string(where);
  limit(digits.size() <= max_digits, place(where), "an exact text is longer than 100000 characters");
  require(has_exact_syntax(digits), place(where), "not an exact text, such as '-3' or '2/7'");
  mpq_class result(digits);
  if (digits.find('/') == std::string::npos) return result;
  const mpz_class common = gcd(result.get_num(), result.get_den());
  require(common == 1 && result.get_den() != 1, place(where), "a fraction is not in lowest terms");
  return result;
}

std::vector<Value> Value::list(std::int64_t size, const std::string& where) const
{
  std::vector<Value> result;
  Items items(*this, where);
  for (Value entry; items.next(entry);) result.push_back(entry);
  if (size >= 0 && result.size() != static_cast<std::size_t>(size))
    reject(place(where), "has " + std::to_string(result.size()) + " entries; expected " + std::to_string(size));
  return result;
}

std::vector<std::pair<std::string, Value>> Value::members(std::size_t most, const std::string& where) const
{
  require(document_[begin_] == '{', place(where), "expected an object");
  std::vector<std::pair<std::string, Value>> result;
  for (std::size_t at = skip_space(document_, begin_ + 1); document_[at] != '}';) {
    const std::size_t key_end = end_of_value(document_, at);
    std::string key = unescaped(document_.substr(at, key_end - at));
    for (const auto& [name, value] : result)
      if (name == key) reject({where, at}, "the key '" + key.substr(0, 40) + "' appears twice");
    require(result.size() < most, {where, at}, "has a key that is not in the specification");
    const std::size_t begin = skip_space(document_, skip_space(document_, key_end) + 1);
    const std::size_t end = end_of_value(document_, begin);
    result.emplace_back(std::move(key), Value(document_, begin, end));
    at = skip_space(document_, end);
    if (document_[at] == ',') at = skip_space(document_, at + 1);
  }
  return result;
}

std::vector<Value> Value::fields(std::initializer_list<std::string_view> keys, const std::string& where) const
{
  const auto found = members(keys.size() + 1, where);
  std::vector<Value> result;
  for (const std::string_view key : keys) {
    const auto member = std::find_if(found.begin(), found.end(), [&](const auto& one) { return one.first == key; });
    if (member == found.end()) reject(place(where), "the key '" + std::string(key) + "' is missing");
    result.push_back(member->second);
  }
  require(found.size() == keys.size(), place(where), "has a key that is not in the specification");
  return result;
}

std::pair<std::string, Value> Value::only_field(const std::string& where) const
{
  auto found = members(2, where);
  require(found.size() == 1, place(where), "expected an object with one key");
  return std::move(found.front());
}

Items::Items(const Value& list, const std::string& where) : document_(list.document_), at_(list.begin_ + 1)
{
  require(list.is_list(), list.place(where), "expected a list");
  at_ = skip_space(document_, at_);
}

bool Items::next(Value& entry)
{
  if (document_[at_] == ']') return false;
  const std::size_t end = end_of_value(document_, at_);
  entry = Value(document_, at_, end);
  at_ = skip_space(document_, end);
  if (document_[at_] == ',') at_ = skip_space(document_, at_ + 1);
  return true;
}

Value read_json(std::string_view text)
{
  require(!text.starts_with("\xef\xbb\xbf"), {"json", 0}, "begins with a byte order mark");
  const std::size_t begin = skip_space(text, 0);
  const std::size_t end = end_of_checked_value(text, begin);
  const std::size_t rest = skip_space(text, end);
  require(rest == text.size(), {"json", rest}, "not a JSON text: something follows it");
  return {text, begin, end};
}

} // namespace corral_check
