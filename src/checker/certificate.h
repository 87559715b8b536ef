// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_CERTIFICATE_H
#define CORRAL_CHECKER_CERTIFICATE_H

#include "polynomial.h"

#include <string>
#include <string_view>

namespace corral_check {

/// The number of cells of each verdict.
struct Counts
{
  std::uint64_t empty = 0;
  std::uint64_t hit = 0;
  std::uint64_t unknown = 0;
};

/// What a file says, in the form of section 1; the tree is not yet looked at.
struct Certificate
{
  std::size_t dimension = 0;
  std::vector<Polynomial> polynomials; ///< f_j of section 2
  std::vector<Polynomial> reduced;     ///< g_j of section 2
  Box box;
  std::vector<std::uint64_t> resolution;
  std::vector<mpq_class> step; ///< w_k
  std::string tree;
  Json witnesses;
  std::size_t reasons = 0;
  Counts counts;
};

/// Reads a certificate and checks sections 1 and 2. \throw Rejected with the place and the reason.
[[nodiscard]] Certificate read_certificate(std::string_view bytes, Budget& budget);

} // namespace corral_check

#endif
