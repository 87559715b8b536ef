// SPDX-License-Identifier: LGPL-3.0-or-later
// run_once SET RESOLUTION [THREADS]: localises a set of problems once, for tools that watch a process from outside, and
// prints a line of JSON. With resolution 0 it prints the problems instead: name, dimension, lower end of the box, then
// `coefficient i j k`.
#include "cases.h"

#include <corral/localization/localize.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>

namespace {

using namespace corral;

/// The most memory that this process has had; getrusage would count that of the process that started it.
long peak_bytes()
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmHWM:", 0) == 0) return std::strtol(line.c_str() + 6, nullptr, 10) * 1024;
  return 0;
}

template <std::size_t D>
int print(const std::vector<benchmark::Problem<D>>& problems)
{
  for (const auto& problem : problems) {
    std::printf("# %s; %d; %d\n", problem.name.c_str(), static_cast<int>(D), problem.lower);
    for (const auto& term : problem.f.terms()) {
      std::printf("%.17g", term.coefficient.get_d());
      for (const auto e : term.exponents) std::printf(" %d", static_cast<int>(e));
      std::printf("\n");
    }
  }
  return 0;
}

template <std::size_t D>
int run(const std::vector<benchmark::Problem<D>>& problems, std::uint32_t n, unsigned threads)
{
  if (n == 0) return print(problems);
  std::uint64_t cells = 0;
  std::uint64_t hits = 0;
  unsigned calls = 0;
  double longest = 0;
  auto last = std::chrono::steady_clock::now();
  const auto lap = [&] {
    const auto now = std::chrono::steady_clock::now();
    longest = std::max(longest, std::chrono::duration<double>(now - last).count());
    last = now;
  };
  Run_options options;
  options.threads = threads;
  if (std::getenv("CORRAL_WATCH") != nullptr)
    options.progress = [&](double) {
      ++calls;
      lap();
    };
  const auto start = last;
  for (const auto& problem : problems) {
    const auto result = localize(problem.f, benchmark::grid_of(problem, n), options);
    cells += result.plotted();
    hits += result.hit();
  }
  lap();
  std::printf("{\"cells\": %llu, \"hits\": %llu, \"seconds\": %.4f, \"peak_bytes\": %ld, \"progress_calls\": %u, "
              "\"longest_pause\": %.4f}\n",
              static_cast<unsigned long long>(cells), static_cast<unsigned long long>(hits),
              std::chrono::duration<double>(last - start).count(), peak_bytes(), calls, longest);
  return 0;
}

/// The problem whose name ends in a number, or all.
template <std::size_t D>
std::vector<benchmark::Problem<D>> selected(std::vector<benchmark::Problem<D>> problems, const char* number)
{
  const auto wanted = std::strtoul(number, nullptr, 10);
  const unsigned long first = D == 2 ? 1 : 11;
  if (wanted < first || wanted >= first + problems.size()) return problems;
  return {problems[wanted - first]};
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 3) {
    std::fputs("usage: run_once curves|surfaces|curve-N|surface-N|dense-N RESOLUTION [THREADS]\n", stderr);
    return 2;
  }
  const std::string_view set = argv[1];
  const auto n = static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10));
  const auto threads = static_cast<unsigned>(argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 1);
  if (set == "surfaces") return run<3>(benchmark::surfaces(), n, threads);
  if (set == "curves") return run<2>(benchmark::curves(), n, threads);
  if (set.substr(0, 8) == "surface-") return run<3>(selected(benchmark::surfaces(), argv[1] + 8), n, threads);
  if (set.substr(0, 6) == "curve-") return run<2>(selected(benchmark::curves(), argv[1] + 6), n, threads);
  if (set.substr(0, 6) == "dense-")
    return run<2>({benchmark::dense_curve(static_cast<unsigned>(std::strtoul(argv[1] + 6, nullptr, 10)))}, n, threads);
  std::fputs("run_once: unknown set; expected curves, surfaces, curve-N, surface-N or dense-N\n", stderr);
  return 2;
}
