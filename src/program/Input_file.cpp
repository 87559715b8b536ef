// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Input_file.h"

#include <corral/errors.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace corral::program {

Input_file::Input_file(std::string path) : path_(std::move(path)), file_(std::fopen(path_.c_str(), "rb"), &std::fclose)
{
  if (!file_) fail(std::string("cannot read it: ") + std::strerror(errno));
  head_length_ = std::fread(head_.data(), 1, head_.size(), file_.get());
  if (std::ferror(file_.get()) != 0) fail(std::string("cannot read it: ") + std::strerror(errno));
}

int Input_file::get()
{
  return position_ < head_length_ ? static_cast<unsigned char>(head_[position_++]) : ::getc_unlocked(file_.get());
}

std::optional<std::string_view> Input_file::line()
{
  line_.clear();
  ++line_number_;
  for (;;) {
    const int c = get();
    if (c == '\n' && std::exchange(skip_line_feed_, false)) continue;
    skip_line_feed_ = c == '\r';
    if (c == '\n' || c == '\r') return line_;
    if (c == EOF) {
      if (std::ferror(file_.get()) != 0) fail(std::string("cannot read it: ") + std::strerror(errno));
      if (line_.empty()) return std::nullopt;
      return line_;
    }
    if (line_.size() == longest_line)
      fail_in_line("longer than " + std::to_string(longest_line) + " bytes; expected a row for each cell");
    line_.push_back(static_cast<char>(c));
  }
}

std::FILE* Input_file::rewound()
{
  if (std::fseek(file_.get(), 0, SEEK_SET) != 0) fail("a picture cannot be read from a pipe; expected a file");
  return file_.get();
}

void Input_file::fail(const std::string& message) const { throw Invalid_input("raster: '" + path_ + "': " + message); }

void Input_file::fail_in_line(const std::string& message) const
{
  throw Invalid_input("raster: '" + path_ + "', line " + std::to_string(line_number_) + ": " + message);
}

} // namespace corral::program
