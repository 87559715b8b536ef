// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_TASKS_H
#define CORRAL_SRC_LOCALIZATION_FAST_TASKS_H

#include "Fast_plan.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace corral::fast {

/// \brief Seeds in tasks of up to eight of one class. \pre Seeds of one class stand side by side.
template <std::size_t D>
[[nodiscard]] std::vector<Task> grouped(const std::vector<Seed<D>>& seeds)
{
  constexpr std::size_t most = 8;
  std::vector<Task> tasks;
  for (std::size_t s = 0; s < seeds.size(); ++s)
    if (!tasks.empty() && tasks.back().count < most && seeds[s].cut == seeds[tasks.back().first].cut)
      ++tasks.back().count;
    else
      tasks.push_back({s, 1});
  return tasks;
}

/// The number of threads to use if the user asks for so many; 0: one for each processor.
[[nodiscard]] inline unsigned thread_count(unsigned asked)
{
  if (asked == 1) return 1;
  static const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
  return asked == 0 ? processors : std::min(asked, processors);
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
