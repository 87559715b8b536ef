// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_PROGRAM_INPUT_FILE_H
#define CORRAL_PROGRAM_INPUT_FILE_H

#include <array>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace corral::program {

/// \brief A file from outside, read byte by byte, whose first bytes can be looked at before.
class Input_file
{
public:
  static constexpr std::size_t head_size = 8;
  static constexpr std::size_t longest_line = 4096;

  /// \throw Invalid_input if it cannot be opened.
  explicit Input_file(std::string path);

  /// The first bytes, at most `head_size`.
  [[nodiscard]] std::string_view head() const { return {head_.data(), head_length_}; }

  /// \brief The next line without its end, which is LF, CR or both; nothing at the end of the file.
  /// \throw Invalid_input if it is longer than `longest_line` or cannot be read.
  [[nodiscard]] std::optional<std::string_view> line();

  /// The number of the line that was read last, from 1.
  [[nodiscard]] std::size_t line_number() const { return line_number_; }

  /// \brief The file, at its beginning.
  /// \throw Invalid_input if it cannot go back, as a pipe.
  [[nodiscard]] std::FILE* rewound();

  /// \throw Invalid_input with the name of the file before the message.
  [[noreturn]] void fail(const std::string& message) const;
  /// As `fail`, with the number of the line too.
  [[noreturn]] void fail_in_line(const std::string& message) const;

private:
  int get();

  std::string path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::array<char, head_size> head_{};
  std::size_t head_length_ = 0;
  std::size_t position_ = 0; // in the head
  std::string line_;
  std::size_t line_number_ = 0;
  bool skip_line_feed_ = false;
};

} // namespace corral::program

#endif
