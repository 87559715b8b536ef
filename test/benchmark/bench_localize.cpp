// SPDX-License-Identifier: LGPL-3.0-or-later
#include "baselines.h"
#include "cases.h"
#include "interval_access.h"

#include <corral/localization/localize.h>

#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <optional>

namespace corral::benchmark {
namespace {

using ::benchmark::State;

/// Times all problems of a set together and reports what was found.
template <std::size_t D>
void time_fast(State& state, const std::vector<Problem<D>>& problems, std::uint32_t n, unsigned threads)
{
  Run_options options;
  options.threads = threads;
  std::vector<std::optional<Raster<D>>> results(problems.size());
  for (auto _ : state)
    for (std::size_t k = 0; k < problems.size(); ++k) {
      results[k].reset();
      results[k] = localize(problems[k].f, grid_of(problems[k], n), options);
    }
  std::uint64_t cells = 0;
  std::uint64_t hits = 0;
  std::uint64_t bytes = 0;
  for (const auto& result : results) {
    cells += result->plotted();
    hits += result->hit();
    bytes += result->blocks().size() * sizeof(Cell_block<D>);
  }
  state.counters["cells"] = static_cast<double>(cells);
  state.counters["hits"] = static_cast<double>(hits);
  state.counters["unknown"] = static_cast<double>(cells - hits);
  state.counters["bytes"] = static_cast<double>(bytes);
}

template <class I, std::size_t D, template <class, std::size_t> class Bound>
void time_plain(State& state, const std::vector<Problem<D>>& problems, std::uint32_t n)
{
  [[maybe_unused]] const typename Interval_access<I>::Scope scope;
  std::uint64_t cells = 0;
  for (auto _ : state) {
    cells = 0;
    for (const auto& problem : problems) cells += plain_cells<I, D, Bound>(problem.f, problem.lower, n);
  }
  state.counters["cells"] = static_cast<double>(cells);
}

/// One row: problems / method / resolution.
template <class Function>
void row(const std::string& set, const std::string& method, std::uint32_t n, const Function& function)
{
  ::benchmark::RegisterBenchmark((set + "/" + method + "/" + std::to_string(n)).c_str(),
                                 [=](State& state) { function(state); })
      ->Unit(::benchmark::kMillisecond)
      ->MeasureProcessCPUTime()
      ->UseRealTime();
}

template <std::size_t D>
void register_fast(const std::string& set, const std::vector<Problem<D>>& problems, const std::vector<std::uint32_t>& n,
                   unsigned threads = 1)
{
  for (const auto size : n)
    row(set, threads == 1 ? "fast" : "fast, " + std::to_string(threads) + " threads", size,
        [=](State& state) { time_fast<D>(state, problems, size, threads); });
}

template <class I, std::size_t D>
void register_plain(const std::string& set, const std::vector<Problem<D>>& problems,
                    const std::vector<std::uint32_t>& n)
{
  const std::string name = Interval_access<I>::name;
  for (const auto size : n) {
    row(set, "mean-value, " + name, size,
        [=](State& state) { time_plain<I, D, Mean_value_bound>(state, problems, size); });
    row(set, "natural, " + name, size, [=](State& state) { time_plain<I, D, Natural_bound>(state, problems, size); });
  }
}

void register_all()
{
  register_fast<2>("ten curves", curves(), {256, 1024, 4096, 16384, 65536});
  register_fast<2>("ten curves", curves(), {16384}, 2);
  register_plain<Cgal_number, 2>("ten curves", curves(), {256, 1024, 4096});
  register_plain<Boost_number, 2>("ten curves", curves(), {256});
  register_plain<Mpfi_number, 2>("ten curves", curves(), {256});
  register_plain<Arb_number, 2>("ten curves", curves(), {256});
  register_fast<3>("ten surfaces", surfaces(), {32, 128, 256});
  register_fast<3>("ten surfaces", surfaces(), {256}, 2);
  register_plain<Cgal_number, 3>("ten surfaces", surfaces(), {32, 128, 256});
  for (const unsigned degree : {10U, 20U, 40U, 100U}) {
    const std::vector<Problem<2>> one{dense_curve(degree)};
    register_fast<2>(one[0].name, one, {1024});
    if (degree <= 20) register_plain<Cgal_number, 2>(one[0].name, one, {1024});
  }
  for (const auto& problem : hard_curves()) {
    register_fast<2>(problem.name, {problem}, {256, 1024, 4096});
    register_plain<Cgal_number, 2>(problem.name, {problem}, {256});
  }
  for (const auto& problem : curves()) register_fast<2>(problem.name, {problem}, {256, 1024, 4096, 16384});
  for (const auto& problem : surfaces()) register_fast<3>(problem.name, {problem}, {32, 128, 256});
}

} // namespace
} // namespace corral::benchmark

int main(int argc, char** argv)
{
  corral::benchmark::register_all();
  ::benchmark::Initialize(&argc, argv);
  if (::benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  ::benchmark::RunSpecifiedBenchmarks();
  return 0;
}
