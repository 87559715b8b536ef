// SPDX-License-Identifier: LGPL-3.0-or-later
#include "document.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace corral_check {
namespace {

constexpr std::size_t max_text = std::size_t{1} << 28;
constexpr std::size_t max_depth = 16;
constexpr std::size_t max_values = std::size_t{1} << 23;
constexpr std::size_t max_digits = 100000;

std::string inflate_whole(std::string_view bytes)
{
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 16) != Z_OK) reject("file", "gzip cannot be initialised");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data())); // zlib does not write there
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string text;
  std::vector<char> chunk(std::size_t{1} << 16);
  int status = Z_OK;
  while (status == Z_OK && text.size() <= max_text) {
    stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
    stream.avail_out = static_cast<uInt>(chunk.size());
    status = inflate(&stream, Z_NO_FLUSH);
    text.append(chunk.data(), chunk.size() - stream.avail_out);
  }
  const bool whole = status == Z_STREAM_END && stream.avail_in == 0;
  inflateEnd(&stream);
  require(text.size() <= max_text, "file", "the text is longer than 2^28 bytes");
  require(whole, "file", "the gzip data are damaged, cut off or followed by something else");
  return text;
}

/// Builds the value while reading, so that nothing is stored that breaks a rule.
class Strict_builder final : public nlohmann::json_sax<Json>
{
public:
  bool null() override { return add(nullptr); }
  bool boolean(bool) override { reject("json", "true and false have no place in a certificate"); }
  bool number_integer(number_integer_t) override { reject("json", "a number has a sign"); }
  bool number_unsigned(number_unsigned_t value) override
  {
    require(value <= static_cast<number_unsigned_t>(std::numeric_limits<std::int64_t>::max()), "json",
            "a number is 2^63 or more");
    return add(value);
  }
  bool number_float(number_float_t, const string_t&) override
  {
    reject("json", "a number is not an integer below 2^63; write other numbers as exact text");
  }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { reject("json", "binary data have no place in a certificate"); }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override
  {
    if (stack_.back()->contains(name)) reject("json", "the key '" + name.substr(0, 40) + "' appears twice");
    key_ = std::move(name);
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception&) override
  {
    reject("json", "not a JSON text, at byte " + std::to_string(position));
  }

  Json root;

private:
  Json* place(Json value)
  {
    require(++count_ <= max_values, "json", "more than 2^23 values");
    if (stack_.empty()) {
      root = std::move(value);
      return &root;
    }
    if (stack_.back()->is_array()) return &stack_.back()->emplace_back(std::move(value));
    return &((*stack_.back())[key_] = std::move(value));
  }
  bool add(Json value)
  {
    place(std::move(value));
    return true;
  }
  bool open(Json value)
  {
    require(stack_.size() < max_depth, "json", "lists and objects are nested more than 16 deep");
    stack_.push_back(place(std::move(value))); // stays valid: nothing is added to the parent before close()
    return true;
  }
  bool close()
  {
    stack_.pop_back();
    return true;
  }

  std::vector<Json*> stack_;
  std::string key_;
  std::size_t count_ = 0;
};

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

std::string unpack(std::string_view bytes)
{
  require(bytes.size() <= max_text, "file", "longer than 2^28 bytes");
  if (bytes.starts_with("\x1f\x8b")) return inflate_whole(bytes);
  return std::string(bytes);
}

Json read_json(std::string_view text)
{
  // The reader would skip a byte order mark and take a zero byte for the end of the text.
  require(!text.starts_with("\xef\xbb\xbf"), "json", "begins with a byte order mark");
  require(text.find('\0') == std::string_view::npos, "json", "contains a zero byte");
  Strict_builder builder;
  Json::sax_parse(text.begin(), text.end(), &builder);
  return std::move(builder.root);
}

void require_keys(const Json& value, std::initializer_list<const char*> keys, const std::string& where)
{
  require(value.is_object(), where, "expected an object");
  for (const char* key : keys)
    if (!value.contains(key)) reject(where, "the key '" + std::string(key) + "' is missing");
  require(value.size() == keys.size(), where, "has a key that is not in the specification");
}

const Json& list(const Json& value, std::int64_t size, const std::string& where)
{
  require(value.is_array(), where, "expected a list");
  if (size >= 0 && value.size() != static_cast<std::size_t>(size))
    reject(where, "has " + std::to_string(value.size()) + " entries; expected " + std::to_string(size));
  return value;
}

std::uint64_t number(const Json& value, std::uint64_t least, std::uint64_t most, const std::string& where)
{
  require(value.is_number_unsigned(), where, "expected a JSON number");
  const auto result = value.get<std::uint64_t>();
  if (result < least || result > most)
    reject(where,
           "is " + std::to_string(result) + "; expected " + std::to_string(least) + " to " + std::to_string(most));
  return result;
}

const std::string& text(const Json& value, const std::string& where)
{
  require(value.is_string(), where, "expected a string");
  return value.get_ref<const std::string&>();
}

mpq_class exact(const Json& value, const std::string& where)
{
  const std::string& digits = text(value, where);
  require(digits.size() <= max_digits, where, "an exact text is longer than 100000 characters");
  require(has_exact_syntax(digits), where, "not an exact text, such as '-3' or '2/7'");
  mpq_class result(digits);
  if (digits.find('/') == std::string::npos) return result;
  const mpz_class common = gcd(result.get_num(), result.get_den());
  require(common == 1 && result.get_den() != 1, where, "a fraction is not in lowest terms");
  return result;
}

} // namespace corral_check
