// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_AUDIT_PAPER_SUBJECTS_H
#define CORRAL_SRC_PROGRAM_AUDIT_PAPER_SUBJECTS_H

#include <corral/audit/audit_bounder.h>

#include <cstddef>
#include <vector>

namespace corral::program {

/// The paper's examples of D dimensions, with their numbers.
template <std::size_t D>
struct Paper_subjects
{
  std::vector<Audit_subject<D>> subjects;
  std::vector<int> numbers;
};

/// Empty unless D is 2 or 3. Compiled once, in `Paper_subjects.cpp`.
template <std::size_t D>
[[nodiscard]] Paper_subjects<D> paper_subjects();

} // namespace corral::program

#endif
