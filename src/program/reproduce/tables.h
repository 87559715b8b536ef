// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_REPRODUCE_TABLES_H
#define CORRAL_SRC_PROGRAM_REPRODUCE_TABLES_H

#include "paper_tables.h"

#include <corral/Run_options.h>

#include <ostream>
#include <string>

namespace corral::program {

/// How tables are recomputed and printed.
struct Table_options
{
  std::string number = "double_nearest";
  bool csv = false;
  Run_options run{}; ///< stops after a row
};

/// \brief Computes every row of a table of the paper again and prints it beside what the paper prints, and
/// beside the exact number of cells that hold a zero.
/// \throw Cancelled; Invalid_input for an unknown number type.
void print_table(std::ostream& out, const Paper_table& table, const Table_options& options);

} // namespace corral::program

#endif
