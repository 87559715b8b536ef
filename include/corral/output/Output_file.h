// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_OUTPUT_OUTPUT_FILE_H
#define CORRAL_OUTPUT_OUTPUT_FILE_H

#include <corral/errors.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <ostream>

namespace corral {

/// \brief A file that is written whole or not at all.
///
/// Everything goes to a temporary name in the same folder; `commit` renames it, which replaces an
/// earlier file in one step. Without a successful `commit` the destructor removes the temporary
/// file, and an earlier file stays as it was. A device or a pipe is written directly.
class Output_file
{
public:
  /// \throw Output_error if the folder cannot be written.
  explicit Output_file(const std::filesystem::path& path);
  ~Output_file();
  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  [[nodiscard]] std::ostream& stream() { return stream_; }

  /// \brief Closes the file and gives it its name.
  /// \throw Output_error if not everything could be written.
  void commit();

private:
  [[noreturn]] void fail(int error) const;

  std::filesystem::path asked_;     // as the caller named it, for messages
  std::filesystem::path target_;    // symbolic links followed
  std::filesystem::path temporary_; // empty once committed, or for a device
  std::ofstream stream_;
};

/// \brief Calls `write` on a stream into `path` and commits the file.
/// \throw Output_error if the file could not be written whole, and whatever `write` throws; nothing is left then.
void write_whole_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

} // namespace corral

#endif
