// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_JSON_H
#define CORRAL_CHECKER_JSON_H

#include "fault.h"

#include <gmpxx.h>

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

/// \file
/// JSON values as parts of the text that holds them: nothing is copied before it is asked for, and each knows its
/// place.
namespace corral_check {

/// \brief A value of a JSON text that `read_json` has found well formed.
class Value
{
public:
  Value() = default;
  Value(std::string_view document, std::size_t begin, std::size_t end) : document_(document), begin_(begin), end_(end)
  {}

  [[nodiscard]] std::size_t byte() const { return begin_; }
  [[nodiscard]] Place place(std::string words) const { return {std::move(words), begin_}; }
  [[nodiscard]] bool is_null() const { return document_[begin_] == 'n'; }
  [[nodiscard]] bool is_list() const { return document_[begin_] == '['; }

  /// The value of a string, its escapes resolved.
  [[nodiscard]] std::string string(const std::string& where) const;
  /// A JSON number from `least` to `most`.
  [[nodiscard]] std::uint64_t number(std::uint64_t least, std::uint64_t most, const std::string& where) const;
  /// An exact text.
  [[nodiscard]] mpq_class exact(const std::string& where) const;
  /// The entries of a list; if `size` is not negative, so many.
  [[nodiscard]] std::vector<Value> list(std::int64_t size, const std::string& where) const;
  /// The values of an object that has just these keys, in their order.
  [[nodiscard]] std::vector<Value> fields(std::initializer_list<std::string_view> keys, const std::string& where) const;
  /// The one key of an object with its value.
  [[nodiscard]] std::pair<std::string, Value> only_field(const std::string& where) const;
  /// The values of an object by key. \throw Rejected if a key is there twice.
  [[nodiscard]] std::vector<std::pair<std::string, Value>> members(std::size_t most, const std::string& where) const;

private:
  friend class Items;
  std::string_view document_ = "n";
  std::size_t begin_ = 0;
  std::size_t end_ = 1;
};

/// Goes through a list without holding its entries.
class Items
{
public:
  Items(const Value& list, const std::string& where);
  /// Moves to the next entry; false if there is none.
  bool next(Value& entry);

private:
  std::string_view document_;
  std::size_t at_;
};

/// Checks a JSON text by the rules of sections 1 and 7. \throw Rejected for anything else.
[[nodiscard]] Value read_json(std::string_view text);

} // namespace corral_check

#endif
