// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_MEMBER_H
#define CORRAL_SRC_LOCALIZATION_FAST_MEMBER_H

#include "Fast_plan.h"
#include "Pulse.h"
#include "common_nodes.h"

#include <corral/localization/Grid.h>
#include <corral/polynomial/Polynomial.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace corral::fast {

/// \brief One polynomial of a system, on its way down the tree. Several threads may work with it.
template <std::size_t D>
class Member
{
public:
  /// The polynomial as a Taylor form or by its terms, whichever suits it. \param refines  as of a `Search`.
  /// \pre The other arguments outlive the member.
  [[nodiscard]] static std::unique_ptr<Member> make(const Polynomial<Rational, D>& f, const Grid<D>& grid, bool refines,
                                                    Pulse& pulse);

  virtual ~Member() = default;

  /// The plan, whose tree is the same for all polynomials on a grid.
  [[nodiscard]] virtual const Plan<D>& plan() const = 0;

  [[nodiscard]] virtual Seed<D> root() const = 0;

  /// The children of some nodes that it cannot drop. \pre The level is above `rough_level`.
  [[nodiscard]] virtual Harvest<D> children(unsigned level, std::vector<Open_node<D>>&& nodes) = 0;

  /// The cells of some nodes. \pre The level is `rough_level`.
  [[nodiscard]] virtual Harvest<D> leaves(unsigned level, std::vector<Open_node<D>>&& nodes) = 0;

protected:
  Member() = default;
  Member(const Member&) = delete;
  Member& operator=(const Member&) = delete;
};

extern template class Member<2>;
extern template class Member<3>;

} // namespace corral::fast

#endif
