// SPDX-License-Identifier: LGPL-3.0-or-later
#include "run_program.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace corral::test {

namespace fs = std::filesystem;

namespace {

void limit(int resource, rlim_t most)
{
  const rlimit both{most, most};
  ::setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

[[noreturn]] void become_program(const std::vector<std::string>& arguments, const Program_limits& limits,
                                 const std::string& out, const std::string& err)
{
  ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
  ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), STDOUT_FILENO);
  ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), STDERR_FILENO);
  if (!limits.folder.empty() && ::chdir(limits.folder.c_str()) != 0) std::_Exit(126);
  limit(RLIMIT_CPU, limits.seconds);
  if (limits.memory != 0) limit(RLIMIT_AS, limits.memory);
  if (limits.file_size != 0) limit(RLIMIT_FSIZE, limits.file_size);
  limit(RLIMIT_CORE, 0);
  std::vector<char*> words{const_cast<char*>(CORRAL_PROGRAM)};
  for (const auto& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  ::execv(CORRAL_PROGRAM, words.data());
  std::_Exit(127);
}

} // namespace

Program_run run_program(const std::vector<std::string>& arguments, const Program_limits& limits)
{
  const Temporary_folder folder;
  const std::string out = limits.out_file.empty() ? (folder.path() / "out").string() : limits.out_file;
  const std::string err = (folder.path() / "err").string();
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) become_program(arguments, limits, out, err);
  int status = 0;
  if (limits.interrupt_when || limits.interrupt_after.count() != 0) {
    std::this_thread::sleep_for(limits.interrupt_after);
    bool has_ended = false;
    while (limits.interrupt_when && !limits.interrupt_when() && !has_ended) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      siginfo_t end = {};
      has_ended =
          ::waitid(P_PID, static_cast<id_t>(child), &end, WEXITED | WNOHANG | WNOWAIT) == 0 && end.si_pid == child;
    }
    for (const int signal : limits.signals) ::kill(child, signal);
  }
  ::waitpid(child, &status, 0);
  Program_run run;
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (limits.out_file.empty()) run.out = content(out);
  run.err = content(err);
  return run;
}

Temporary_folder::Temporary_folder()
{
  std::string name = (fs::temp_directory_path() / "corral-test-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
  path_ = name;
}

Temporary_folder::~Temporary_folder()
{
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::vector<std::string> Temporary_folder::files() const
{
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path_)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string content(const fs::path& path)
{
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace corral::test
