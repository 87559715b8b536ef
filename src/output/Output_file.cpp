// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/output/Output_file.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <unistd.h>

namespace corral {
namespace fs = std::filesystem;

namespace {

fs::path temporary_name(const fs::path& target)
{
  fs::path name = target.parent_path() / ".";
  name += target.filename();
  name += '.' + std::to_string(::getpid()) + ".part";
  return name;
}

// The end of a chain of symbolic links, whether it exists or not.
fs::path followed(fs::path path)
{
  std::error_code error;
  for (int links = 0; links < 40 && fs::is_symlink(fs::symlink_status(path, error)); ++links) {
    const fs::path next = fs::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / next;
  }
  return path;
}

} // namespace

Output_file::Output_file(const fs::path& path) : asked_(path)
{
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) fail(EISDIR);
  target_ = followed(path);
  const bool is_device = fs::exists(status) && !fs::is_regular_file(status);
  if (!is_device) {
    // Exclusive, so that no file of somebody else is ever truncated.
    const fs::path name = temporary_name(target_);
    std::FILE* const created = std::fopen(name.c_str(), "wbx");
    if (created == nullptr) fail(errno);
    std::fclose(created);
    temporary_ = name;
  }
  errno = 0;
  stream_.open(is_device ? target_ : temporary_, std::ios::binary | std::ios::trunc);
  if (!stream_) fail(errno);
}

Output_file::~Output_file()
{
  if (temporary_.empty()) return;
  stream_.close();
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void Output_file::commit()
{
  errno = 0;
  stream_.close();
  if (!stream_) fail(errno != 0 ? errno : EIO);
  if (temporary_.empty()) return;
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) fail(error.value());
  temporary_.clear();
}

void Output_file::fail(int error) const
{
  throw Output_error("output: cannot write '" + asked_.string() + "': " + std::strerror(error));
}

void write_whole_file(const fs::path& path, const std::function<void(std::ostream&)>& write)
{
  Output_file file(path);
  errno = 0;
  write(file.stream());
  const int error = errno;
  if (!file.stream())
    throw Output_error("output: cannot write '" + path.string() + "': " + std::strerror(error != 0 ? error : EIO));
  file.commit();
}

} // namespace corral
