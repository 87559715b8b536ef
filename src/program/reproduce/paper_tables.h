// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_REPRODUCE_PAPER_TABLES_H
#define CORRAL_SRC_PROGRAM_REPRODUCE_PAPER_TABLES_H

#include <cstdint>
#include <span>
#include <string_view>

namespace corral::program {

/// What the paper counts in each run.
struct Row_counts
{
  std::uint64_t plotted = 0;
  std::uint64_t subdivisions = 0;
  std::uint64_t additions = 0;
  std::uint64_t multiplications = 0;
};

/// One row of a table of the paper, and how to compute it again.
struct Paper_row
{
  int example;
  std::string_view label; ///< the method or the order, as printed
  std::string_view bounder;
  unsigned order;
  bool plus; ///< point sampling and subcells
  Row_counts printed;
};

/// A table as printed.
struct Paper_table
{
  std::string_view name;
  std::string_view title;
  unsigned resolution;
  std::span<const Paper_row> rows;
};

/// Tables 1 to 4. \par Reference  as for `Example`.
[[nodiscard]] std::span<const Paper_table> paper_tables();

} // namespace corral::program

#endif
