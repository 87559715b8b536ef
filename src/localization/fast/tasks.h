// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_TASKS_H
#define CORRAL_SRC_LOCALIZATION_FAST_TASKS_H

#include "Subdivider.h"

#include <corral/number/Environment.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <thread>
#include <vector>

namespace corral::fast {

/// Seeds that are subdivided together; they depend on the input alone, and so does the result.
template <std::size_t D>
using Task = std::span<const Seed<D>>;

/// \brief Seeds in tasks of up to eight of one class. \pre Seeds of one class stand side by side.
template <std::size_t D>
[[nodiscard]] std::vector<Task<D>> grouped(Task<D> seeds)
{
  constexpr std::size_t most = 8;
  std::vector<Task<D>> tasks;
  for (std::size_t s = 0; s < seeds.size(); ++s)
    if (!tasks.empty() && tasks.back().size() < most && seeds[s].cut == tasks.back().front().cut)
      tasks.back() = {tasks.back().data(), tasks.back().size() + 1};
    else
      tasks.push_back(seeds.subspan(s, 1));
  return tasks;
}

/// Subdivides seeds of one level down to `stop_level`. \pre as `grouped`.
template <std::size_t D>
void subdivide(const Plan<D>& plan, Pulse& pulse, unsigned level, Task<D> seeds, unsigned stop_level,
               Harvest<D>& harvest)
{
  const auto subdivider = make_subdivider(plan, pulse);
  for (const auto& task : grouped<D>(seeds)) subdivider->run(level, task, stop_level, harvest);
}

/// The number of threads to use if the user asks for so many; 0: one for each processor.
[[nodiscard]] inline unsigned thread_count(unsigned asked)
{
  if (asked == 1) return 1;
  static const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
  return asked == 0 ? processors : std::min(asked, processors);
}

/// Calls `function(k)` for k from 0 to `count`.
template <class Function>
void in_parallel(unsigned threads, std::size_t count, const Function& function)
{
  if (threads > 1 && count > 1)
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count),
        [&](const auto& range) {
          const Nearest_scope environment;
          for (std::size_t k = range.begin(); k != range.end(); ++k) function(k);
        },
        tbb::simple_partitioner());
  else
    for (std::size_t k = 0; k < count; ++k) function(k);
}

/// Calls `work` where parallel loops use this number of threads.
template <class Work>
auto in_arena(unsigned threads, const Work& work)
{
  if (threads == 1 || static_cast<int>(threads) == tbb::this_task_arena::max_concurrency()) return work();
  tbb::task_arena arena(static_cast<int>(threads));
  return arena.execute(work);
}

} // namespace corral::fast

#endif
