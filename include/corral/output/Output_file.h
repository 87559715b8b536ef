// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_OUTPUT_OUTPUT_FILE_H
#define CORRAL_OUTPUT_OUTPUT_FILE_H

#include <corral/errors.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <ostream>
#include <vector>

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

  /// \brief Calls `write` on the stream and closes it. The file does not have its name yet.
  /// \throw Output_error if not everything could be written, and whatever `write` throws.
  void fill(const std::function<void(std::ostream&)>& write);

  /// \brief Closes the file, if it is still open, and gives it its name.
  /// \throw Output_error if not everything could be written.
  void commit();

private:
  struct Noted; // the temporary name where `remove_unfinished_files` finds it

  void close();
  [[noreturn]] void fail(int error) const;

  std::filesystem::path asked_;     // as the caller named it, for messages
  std::filesystem::path target_;    // symbolic links followed
  std::filesystem::path temporary_; // empty once committed, or for a device
  std::unique_ptr<Noted> noted_;
  std::ofstream stream_;
};

/// \brief Removes the temporary files of all `Output_file`s of the process, for a handler that ends it.
///
/// A handler of signals may call it. Nothing else of the files works after that.
void remove_unfinished_files() noexcept;

/// \brief Calls `write` on a stream into `path` and commits the file.
/// \throw Output_error if the file could not be written whole, and whatever `write` throws; nothing is left then.
void write_whole_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

/// A file and what writes it.
struct File_to_write
{
  std::filesystem::path path;
  std::function<void(std::ostream&)> write;
};

/// \brief Writes all files or none: no name changes before all of them are written.
/// \throw as `write_whole_file`. If a name cannot be given, which the system allows only where it has changed
///        meanwhile, earlier files of the list keep theirs.
void write_whole_files(const std::vector<File_to_write>& files);

} // namespace corral

#endif
