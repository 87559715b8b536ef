// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Cell_table.h"

#include <corral/errors.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace corral::program {

namespace {

constexpr std::string_view blanks = " \t\v\f";

std::string_view trimmed(std::string_view text)
{
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  text = text.substr(first, text.find_last_not_of(blanks) - first + 1);
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front())
    text = text.substr(1, text.size() - 2);
  return text;
}

// The fields of a line: between commas or semicolons if there are any, else between blanks or tabs.
void split(std::string_view line, std::vector<std::string_view>& fields)
{
  fields.clear();
  line = line.substr(std::min(line.find_first_not_of(blanks), line.size()));
  line = line.substr(0, line.find_last_not_of(blanks) + 1);
  const std::string_view separators = line.find_first_of(",;") != std::string_view::npos ? ",;" : blanks;
  for (;;) {
    const auto end = line.find_first_of(separators);
    fields.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return;
    line.remove_prefix(end + 1);
    if (separators == blanks) line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  }
}

std::optional<double> number(std::string_view text)
{
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string lower_case(std::string_view text)
{
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

std::string excerpt(std::string_view text)
{
  constexpr std::size_t longest = 40;
  std::string result = "'";
  result.append(text.substr(0, longest));
  return result.append(text.size() > longest ? "...'" : "'");
}

class Table_reader
{
public:
  Table_reader(Input_file& file, std::span<const std::uint32_t> resolution, const Raster_options& options)
      : file_(file), resolution_(resolution), options_(options), index_(resolution.size())
  {}

  void read(const std::function<void(const std::vector<std::uint32_t>&, Claim)>& visit)
  {
    std::uint64_t rows = 0;
    while (next_row()) {
      if (columns_.empty() && read_header()) continue;
      if (++rows > options_.max_rows)
        throw Budget_exceeded("raster: the table has more than " + std::to_string(options_.max_rows) + " rows");
      if (const auto claim = read_row()) visit(index_, *claim);
    }
    if (columns_.empty()) file_.fail("it is empty; expected a row for each cell, or a header alone if there is none");
  }

private:
  static constexpr std::size_t verdict_column = static_cast<std::size_t>(-1);

  // Steps over blank lines and comments.
  bool next_row()
  {
    while (auto line = file_.line()) {
      constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
      if (file_.line_number() == 1 && line->starts_with(byte_order_mark)) line->remove_prefix(byte_order_mark.size());
      const auto first = line->find_first_not_of(blanks);
      if (first == std::string_view::npos || (*line)[first] == '#') continue;
      split(*line, fields_);
      return true;
    }
    return false;
  }

  // Learns the columns from the first row; whether it is a header.
  bool read_header()
  {
    const std::size_t dimension = resolution_.size();
    const bool is_header = !number(fields_[0]);
    if (is_header) {
      for (const auto field : fields_) columns_.push_back(column_named(lower_case(field)));
      for (std::size_t axis = 0; axis < dimension; ++axis)
        if (std::count(columns_.begin(), columns_.end(), axis) != 1) fail_header();
      if (columns_.size() > dimension + 1) fail_header();
    } else {
      if (fields_.size() != dimension && fields_.size() != dimension + 1)
        file_.fail_in_line(std::to_string(fields_.size()) + (fields_.size() == 1 ? " field" : " fields") + "; expected "
                           + std::to_string(dimension) + " indices and perhaps a verdict");
      for (std::size_t axis = 0; axis < dimension; ++axis) columns_.push_back(axis);
      if (fields_.size() > dimension) columns_.push_back(verdict_column);
    }
    return is_header;
  }

  std::size_t column_named(const std::string& name) const
  {
    const std::size_t dimension = resolution_.size();
    for (std::size_t axis = 0; axis < std::min(dimension, options_.variables.size()); ++axis)
      if (name == lower_case(options_.variables[axis])) return axis;
    for (const std::string_view usual : {"ijkl", "xyz"})
      if (const auto axis = usual.find(name); name.size() == 1 && axis < dimension) return axis;
    if (name == "verdict" || name == "plotted") return verdict_column;
    file_.fail_in_line("column " + excerpt(name) + "; " + expected_columns());
  }

  [[noreturn]] void fail_header() const
  {
    file_.fail_in_line("header lacks or repeats a column; " + expected_columns());
  }

  std::string expected_columns() const
  {
    std::string names;
    for (std::size_t axis = 0; axis < resolution_.size(); ++axis)
      names.append(axis == 0 ? "" : ", ").push_back("ijkl"[axis]);
    return "expected the indices " + names + " and perhaps a verdict";
  }

  // The claim of a row whose cell is then in `index_`; nothing if it calls the cell empty.
  std::optional<Claim> read_row()
  {
    if (fields_.size() != columns_.size())
      file_.fail_in_line(std::to_string(fields_.size()) + (fields_.size() == 1 ? " field" : " fields") + "; expected "
                         + std::to_string(columns_.size()) + " as before");
    std::optional<Claim> claim = Claim::plotted;
    for (std::size_t k = 0; k < columns_.size(); ++k)
      if (columns_[k] == verdict_column)
        claim = claim_of(fields_[k]);
      else
        index_[columns_[k]] = index_of(fields_[k], columns_[k]);
    return claim;
  }

  std::uint32_t index_of(std::string_view field, std::size_t axis) const
  {
    const auto value = number(field);
    if (!value || !(*value >= 0 && *value < resolution_[axis]) || *value != static_cast<std::uint32_t>(*value))
      file_.fail_in_line("given " + excerpt(field) + "; expected " + "ijkl"[axis] + ", a whole number from 0 to "
                         + std::to_string(resolution_[axis] - 1));
    return static_cast<std::uint32_t>(*value);
  }

  std::optional<Claim> claim_of(std::string_view field) const
  {
    const std::string word = lower_case(field);
    if (word == "hit") return Claim::hit;
    if (word == "unknown") return Claim::unknown;
    if (word == "plotted" || word == "1" || word == "true") return Claim::plotted;
    if (word == "empty" || word == "0" || word == "false") return std::nullopt;
    file_.fail_in_line("given " + excerpt(field) + "; expected hit, unknown, plotted or empty");
  }

  Input_file& file_;
  std::span<const std::uint32_t> resolution_;
  const Raster_options& options_;
  std::vector<std::string_view> fields_;
  std::vector<std::size_t> columns_; ///< what each field is, once known: an axis or the verdict
  std::vector<std::uint32_t> index_;
};

} // namespace

void read_table(Input_file& file, std::span<const std::uint32_t> resolution, const Raster_options& options,
                const std::function<void(const std::vector<std::uint32_t>&, Claim)>& visit)
{
  Table_reader(file, resolution, options).read(visit);
}

} // namespace corral::program
