// SPDX-License-Identifier: LGPL-3.0-or-later
// run_once SET RESOLUTION [THREADS]: localises a set of problems once, for tools that watch a process from outside.
// With resolution 0 it prints the problems instead: name, dimension, lower end of the box, then `coefficient i j k`.
#include "cases.h"

#include <corral/localization/localize_fast.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {

using namespace corral;

template <std::size_t D>
int run(const std::vector<benchmark::Problem<D>>& problems, std::uint32_t n, unsigned threads)
{
  Fast_options options;
  options.threads = threads;
  std::uint64_t cells = 0;
  if (n == 0) {
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
  for (const auto& problem : problems)
    cells += localize_fast(problem.f, benchmark::grid_of(problem, n), options).cells.plotted();
  std::printf("%llu\n", static_cast<unsigned long long>(cells));
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 3) {
    std::fputs("usage: run_once curves|surfaces|dense-N RESOLUTION [THREADS]\n", stderr);
    return 2;
  }
  const std::string_view set = argv[1];
  const auto n = static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10));
  const auto threads = static_cast<unsigned>(argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 1);
  if (set == "surfaces") return run<3>(benchmark::surfaces(), n, threads);
  if (set == "curves") return run<2>(benchmark::curves(), n, threads);
  if (set.substr(0, 6) == "dense-")
    return run<2>({benchmark::dense_curve(static_cast<unsigned>(std::strtoul(argv[1] + 6, nullptr, 10)))}, n, threads);
  std::fputs("run_once: unknown set; expected curves, surfaces or dense-N\n", stderr);
  return 2;
}
