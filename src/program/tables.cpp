// SPDX-License-Identifier: LGPL-3.0-or-later
#include "tables.h"

#include "arguments.h"
#include "engine.h"
#include "examples.h"

#include <cmath>
#include <iomanip>
#include <vector>

namespace corral::program {

namespace {

Row_counts compute(const Paper_row& row, unsigned resolution, const std::string& number)
{
  const Example& example = examples()[static_cast<std::size_t>(row.example - 1)];
  Localize_settings settings;
  settings.engine = "paper";
  settings.method = {.bounder = std::string(row.bounder), .order = row.order, .number = number};
  settings.sample = settings.refine = row.plus;
  settings.count = true;
  const std::vector<std::string> polynomial{std::string(example.polynomial)};
  const Space space = read_space(std::string(example.box()), example.dimension == 2 ? "x,y" : "x,y,z", polynomial);
  Row_counts counts;
  with_dimension(space, [&](auto dimension) {
    constexpr std::size_t D = dimension;
    Resolution<D> all;
    all.fill(resolution);
    const auto found =
        localize_by_name<D>(polynomials_of<D>(space, polynomial), Grid<D>(box_of<D>(space), all), settings);
    counts = {found.cells.plotted(), found.work.subdivisions, found.work.additions, found.work.multiplications};
  });
  return counts;
}

double operations(const Row_counts& counts)
{
  return static_cast<double>(counts.additions) + static_cast<double>(counts.multiplications);
}

// The paper's counts of these rows belong to another program than the one that it describes.
bool is_printed_by_another_algorithm(const Paper_row& row)
{
  return row.label == "RT++" && (row.example == 12 || (row.example >= 14 && row.example <= 19));
}

void print_csv_row(std::ostream& out, const Paper_row& row, const Row_counts& ours)
{
  out << row.example << ',' << row.label;
  for (const Row_counts& counts : {ours, row.printed})
    out << ',' << counts.plotted << ',' << counts.subdivisions << ',' << counts.additions << ','
        << counts.multiplications;
  out << '\n';
}

void print_text_row(std::ostream& out, const Paper_row& row, const Row_counts& ours)
{
  out << std::setw(4) << row.example << "  " << std::left << std::setw(6) << row.label << std::right;
  for (const Row_counts& counts : {ours, row.printed})
    out << " |" << std::setw(6) << counts.plotted << std::setw(7) << counts.subdivisions << std::setw(11)
        << counts.additions << std::setw(11) << counts.multiplications;
  out << " |" << std::fixed << std::setprecision(2) << std::setw(6) << operations(ours) / operations(row.printed);
  if (is_printed_by_another_algorithm(row))
    out << "  *";
  else if (ours.plotted != row.printed.plotted || ours.subdivisions != row.printed.subdivisions)
    out << "  differs";
  out << '\n';
}

void print_text_head(std::ostream& out, const Paper_table& table, const std::string& number)
{
  out << table.title << ", number type " << number << '\n'
      << "              |               computed              |              the paper              | ratio\n"
      << "  ex  " << (table.rows[0].label[0] == '1' ? "order " : "method")
      << "   |  cells subdiv  additions      mult. |  cells subdiv  additions      mult. | of op.\n";
}

} // namespace

void print_table(std::ostream& out, const Paper_table& table, const Table_options& options)
{
  if (options.csv)
    out << "example,method_or_order,plotted,subdivisions,additions,multiplications,paper_plotted,paper_subdivisions,"
           "paper_additions,paper_multiplications\n";
  else
    print_text_head(out, table, options.number);
  double log_ratios = 0;
  bool has_mark = false;
  double done = 0;
  for (const Paper_row& row : table.rows) {
    const Row_counts ours = compute(row, table.resolution, options.number);
    if (options.csv)
      print_csv_row(out, row, ours);
    else
      print_text_row(out, row, ours);
    log_ratios += std::log(operations(ours) / operations(row.printed));
    has_mark = has_mark || is_printed_by_another_algorithm(row);
    done += 1;
    if (options.progress && !options.progress(done / static_cast<double>(table.rows.size())))
      throw Cancelled(std::string(table.name));
  }
  if (options.csv) return;
  out << "Geometric mean of the ratio of operations: " << std::setprecision(3)
      << std::exp(log_ratios / static_cast<double>(table.rows.size())) << '\n';
  if (has_mark)
    out << "* The paper's counts do not follow from the method that it describes: its subvoxel test bounded the\n"
           "  polynomial of Example 20 by MAA instead of the example's own. Computed: the method as described.\n";
}

} // namespace corral::program
