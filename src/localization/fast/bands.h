// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_BANDS_H
#define CORRAL_SRC_LOCALIZATION_FAST_BANDS_H

#include "tasks.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace corral::fast {

/// \brief Tasks that together see some layers of the grid along axis 0, which no other task sees: what they find can be
/// put in order without the rest.
struct Band
{
  std::size_t first; ///< task
  std::size_t end;
};

/// \brief Seeds in tasks of up to eight, in bands.
template <std::size_t D>
class Bands
{
public:
  /// \param seeds  of one level.
  explicit Bands(std::vector<Seed<D>> seeds) : seeds_(std::move(seeds))
  {
    const auto layer = [](const Seed<D>& seed) { return seed.corner[0]; };
    std::ranges::stable_sort(seeds_, {}, layer);
    for (std::size_t first = 0, end = 0; first < seeds_.size(); first = end) {
      end = std::min(first + most, seeds_.size());
      while (end < seeds_.size() && layer(seeds_[end]) == layer(seeds_[end - 1])) ++end;
      add(first, end);
    }
  }

  [[nodiscard]] const std::vector<Task<D>>& tasks() const { return tasks_; }
  [[nodiscard]] const std::vector<Band>& bands() const { return bands_; }

private:
  static constexpr std::size_t most = 8; // seeds of a task

  void add(std::size_t first, std::size_t end)
  {
    const std::span<Seed<D>> seeds(seeds_.data() + first, end - first);
    std::ranges::stable_sort(seeds, {}, &Seed<D>::cut); // so that batches are full
    const std::size_t count = (seeds.size() + most - 1) / most;
    bands_.push_back({tasks_.size(), tasks_.size() + count});
    for (std::size_t t = 0; t < count; ++t) {
      const std::size_t from = seeds.size() * t / count;
      tasks_.push_back(seeds.subspan(from, seeds.size() * (t + 1) / count - from));
    }
  }

  std::vector<Seed<D>> seeds_;
  std::vector<Task<D>> tasks_;
  std::vector<Band> bands_;
};

} // namespace corral::fast

#endif
