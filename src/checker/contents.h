// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_CONTENTS_H
#define CORRAL_CHECKER_CONTENTS_H

#include "polynomial.h"

#include <optional>
#include <string>

namespace corral_check {

/// \brief Section 6: where polynomial `of` and its derivatives along the axes `slopes` are zero, one of `factors` is.
struct Multipliers
{
  std::size_t of = 0;               ///< an index of `Contents::proved`
  std::vector<bool> slopes;         ///< for each axis
  std::vector<std::size_t> factors; ///< indices of `Contents::proved`
};

/// What a file says, in the form of sections 1, 2 and 6; the tree is not yet looked at.
struct Contents
{
  std::string text; ///< the JSON text; the values below lie in it
  Claims claims;
  std::vector<Polynomial> proved; ///< the g_j of section 2, then the P of section 6
  std::size_t given = 0;          ///< m, the number of the former
  std::vector<Multipliers> multipliers;
  Box box;
  std::vector<mpq_class> step; ///< w_k
  std::string tree;
  Value tree_value;
  Value witnesses;
  std::optional<Value> critical;
  std::size_t reasons = 0;
  double work = 0; ///< spent on what is read

  [[nodiscard]] std::size_t dimension() const { return claims.dimension; }
};

} // namespace corral_check

#endif
