// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_PROGRAM_AUDIT_RASTER_REPORT_H
#define CORRAL_SRC_PROGRAM_AUDIT_RASTER_REPORT_H

#include "Raster_judgement.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

/// \file
/// What `corral audit raster` says of a raster, in three forms. The evidence of each cell is found while it is written,
/// so that memory does not grow with it.
namespace corral::program {

/// A raster and the truth about it.
template <std::size_t D>
struct Raster_audit
{
  Grid<D> grid;
  std::array<std::string, D> variables;
  std::vector<std::string> polynomials; ///< as given
  std::vector<std::string> readings;    ///< as read
  std::string file;
  std::uint64_t repeated = 0;
  Raster_judgement<D> judgement;
};

/// How much the reports for people list of each kind of cell.
struct Raster_report_options
{
  std::size_t list = 10;
};

template <std::size_t D>
void write_raster_text(std::ostream& out, const Raster_audit<D>& audit, Evidence_finder<D>& evidence,
                       const Raster_report_options& options);

/// Every cell with its evidence.
template <std::size_t D>
void write_raster_json(std::ostream& out, const Raster_audit<D>& audit, Evidence_finder<D>& evidence);

/// One file that shows the raster, in two dimensions, and lists cells.
template <std::size_t D>
void write_raster_html(std::ostream& out, const Raster_audit<D>& audit, Evidence_finder<D>& evidence,
                       const Raster_report_options& options);

} // namespace corral::program

#endif
