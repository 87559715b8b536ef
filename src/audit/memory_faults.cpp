// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Stepwise_bounder.h"

#include <optional>
#include <utility>

/// \file
/// Bounders that remember what they should not.
namespace corral::audit {
namespace {

/// What it remembers is taken for the same box if one side is the same.
class Stale_cache : public Stepwise_bounder<Sound_steps>
{
public:
  static constexpr std::string_view name = "stale_cache";
  static constexpr std::string_view description = "the last bound is given again if the first side is the same";

  using Stepwise_bounder::Stepwise_bounder;
  [[nodiscard]] Exact bound(const Exact_box& box)
  {
    const bool is_known = is_filled_ && side_.lower() == box[0].lower() && side_.upper() == box[0].upper();
    if (!is_known) last_ = Stepwise_bounder::bound(box);
    is_filled_ = true;
    side_ = box[0];
    return last_;
  }

private:
  bool is_filled_ = false;
  Exact side_;
  Exact last_;
};

/// \brief As two threads may meet that keep the midpoint of their boxes in one place: the caller finds there what the
/// other has left.
class Shared_midpoint
{
public:
  static constexpr std::string_view name = "shared_midpoint";
  static constexpr std::string_view description =
      "the midpoint is kept in one place for all callers, and one overtakes";

  explicit Shared_midpoint(const Exact_polynomial& f) : f_(f) {}
  [[nodiscard]] Exact bound(const Exact_box& box)
  {
    Point own;
    Point radius;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      own[axis] = Sound_steps::centre(box[axis]);
      radius[axis] = Sound_steps::radius(box[axis], own[axis]);
    }
    if (!shared_) shared_ = own;
    return bound_by_steps<Sound_steps>(f_, *std::exchange(shared_, own), radius);
  }

private:
  Exact_polynomial f_;
  std::optional<Point> shared_;
};

} // namespace

std::vector<Planted_bounder> memory_faults() { return {planted<Stale_cache>(), planted<Shared_midpoint>()}; }

} // namespace corral::audit
