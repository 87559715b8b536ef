// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/output/Output_file.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace corral {
namespace fs = std::filesystem;

namespace {

/// A place for one temporary name. Places are never freed, only reused, so that a handler of signals may walk along.
struct Place
{
  std::atomic<const char*> name{nullptr};
  Place* next = nullptr;
};

std::atomic<Place*> places{nullptr};        // the one list of the process
std::atomic<unsigned long> names_so_far{0}; // temporary

Place& place_for(const char* name)
{
  for (Place* place = places; place != nullptr; place = place->next)
    if (const char* none = nullptr; place->name.compare_exchange_strong(none, name)) return *place;
  auto* const place = new Place; // reachable for good
  place->name = name;
  place->next = places;
  while (!places.compare_exchange_weak(place->next, place)) {
  }
  return *place;
}

fs::path temporary_name(const fs::path& target)
{
  fs::path name = target.parent_path() / ".";
  name += target.filename();
  name += '.' + std::to_string(::getpid()) + '-' + std::to_string(names_so_far++) + ".part";
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

struct Output_file::Noted
{
  explicit Noted(std::string path) : name(std::move(path)), place(place_for(name.c_str())) {}
  Noted(const Noted&) = delete;
  Noted& operator=(const Noted&) = delete;
  ~Noted() { place.name = nullptr; }

  std::string name;
  Place& place;
};

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
    auto noted = std::make_unique<Noted>(name.string());
    std::FILE* const created = std::fopen(name.c_str(), "wbx");
    if (created == nullptr) fail(errno);
    std::fclose(created);
    noted_ = std::move(noted);
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

void Output_file::fill(const std::function<void(std::ostream&)>& write)
{
  errno = 0;
  write(stream_);
  if (!stream_) fail(errno != 0 ? errno : EIO);
  close();
}

void Output_file::close()
{
  if (!stream_.is_open()) return;
  errno = 0;
  stream_.close();
  if (!stream_) fail(errno != 0 ? errno : EIO);
}

void Output_file::commit()
{
  close();
  if (temporary_.empty()) return;
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) fail(error.value());
  temporary_.clear();
  noted_.reset();
}

void Output_file::fail(int error) const
{
  throw Output_error("output: cannot write '" + asked_.string() + "': " + std::strerror(error));
}

void remove_unfinished_files() noexcept
{
  for (const Place* place = places; place != nullptr; place = place->next)
    if (const char* const name = place->name; name != nullptr) ::unlink(name);
}

void write_whole_file(const fs::path& path, const std::function<void(std::ostream&)>& write)
{
  Output_file file(path);
  file.fill(write);
  file.commit();
}

void write_whole_files(const std::vector<File_to_write>& files)
{
  std::vector<std::unique_ptr<Output_file>> written;
  for (const auto& [path, write] : files) written.push_back(std::make_unique<Output_file>(path)); // fail early
  for (std::size_t k = 0; k < files.size(); ++k) written[k]->fill(files[k].write);
  for (const auto& file : written) file->commit();
}

} // namespace corral
