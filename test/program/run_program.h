// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_PROGRAM_RUN_PROGRAM_H
#define CORRAL_TEST_PROGRAM_RUN_PROGRAM_H

#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// The program as a user meets it: arguments in, exit code and texts out.
namespace corral::test {

struct Program_run
{
  int exit_code = -1; ///< 128 + the signal if one ended it
  std::string out;
  std::string err;
};

struct Program_limits
{
  unsigned seconds = 60;                        ///< of processor time
  std::size_t memory = 0;                       ///< bytes of address space; 0: no limit
  std::size_t file_size = 0;                    ///< bytes of any file written; 0: no limit
  std::string out_file;                         ///< standard output goes there, if not empty
  std::filesystem::path folder{};               ///< where it runs
  std::chrono::milliseconds interrupt_after{0}; ///< then comes a signal; 0: never
  std::function<bool()> interrupt_when{};       ///< or once this is true
  std::vector<int> signals{SIGINT};             ///< that come then, one after the other
};

/// Runs the program and waits for its end.
[[nodiscard]] Program_run run_program(const std::vector<std::string>& arguments, const Program_limits& limits = {});

/// A new folder that lives as long as this.
class Temporary_folder
{
public:
  Temporary_folder();
  ~Temporary_folder();
  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::vector<std::string> files() const; ///< sorted

private:
  std::filesystem::path path_;
};

/// The whole content of a file.
[[nodiscard]] std::string content(const std::filesystem::path& path);

} // namespace corral::test

#endif
