// SPDX-License-Identifier: LGPL-3.0-or-later
#include "tables.h"

#include "../arguments.h"
#include "../localize/engine.h"
#include "../localize/exact_engine.h"
#include "examples.h"

#include <cmath>
#include <iomanip>
#include <map>
#include <vector>

namespace corral::program {

namespace {

// Calls `visit(system, grid)` for an example of the paper.
template <class Visit>
void with_example(int number, unsigned resolution, const Visit& visit)
{
  const Example& example = examples()[static_cast<std::size_t>(number - 1)];
  const std::vector<Formula> polynomial{std::string(example.polynomial)};
  const Space space = read_space(std::string(example.box()), example.dimension == 2 ? "x,y" : "x,y,z", polynomial);
  with_dimension(space, [&](auto dimension) {
    Resolution<dimension> all;
    all.fill(resolution);
    visit(polynomials_of<dimension>(space, polynomial), Grid<dimension>(box_of<dimension>(space), all));
  });
}

Row_counts compute(const Paper_row& row, unsigned resolution, const std::string& number)
{
  Localize_settings settings;
  settings.engine = "paper";
  settings.method = {.bounder = std::string(row.bounder), .order = row.order, .number = number};
  settings.sample = settings.refine = row.plus;
  settings.count = true;
  Row_counts counts;
  with_example(row.example, resolution, [&](const auto& system, const auto& grid) {
    const auto found = localize_by_name(system, grid, settings);
    const Work_counters& work = found.counters();
    counts = {found.plotted(), work.subdivisions, work.additions, work.multiplications};
  });
  return counts;
}

// The number of cells with a zero, exactly; "?" if a cell could not be decided.
std::string ideal_count(int example, unsigned resolution)
{
  std::string count;
  with_example(example, resolution, [&](const auto& system, const auto& grid) {
    const auto candidates = localize_by_name(system, grid, {});
    const auto raster = decide_exactly(system, candidates).raster;
    count = raster.unknown() == 0 ? std::to_string(raster.plotted()) : "?";
  });
  return count;
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

void print_csv_row(std::ostream& out, const Paper_row& row, const Row_counts& ours, const std::string& ideal)
{
  out << row.example << ',' << row.label;
  for (const Row_counts& counts : {ours, row.printed})
    out << ',' << counts.plotted << ',' << counts.subdivisions << ',' << counts.additions << ','
        << counts.multiplications;
  out << ',' << (ideal == "?" ? "" : ideal) << '\n';
}

void print_text_row(std::ostream& out, const Paper_row& row, const Row_counts& ours, const std::string& ideal)
{
  out << std::setw(4) << row.example << "  " << std::left << std::setw(6) << row.label << std::right;
  for (const Row_counts& counts : {ours, row.printed})
    out << " |" << std::setw(6) << counts.plotted << std::setw(7) << counts.subdivisions << std::setw(11)
        << counts.additions << std::setw(11) << counts.multiplications;
  out << " |" << std::fixed << std::setprecision(2) << std::setw(6) << operations(ours) / operations(row.printed)
      << " |" << std::setw(6) << ideal;
  if (is_printed_by_another_algorithm(row))
    out << "  *";
  else if (ours.plotted != row.printed.plotted || ours.subdivisions != row.printed.subdivisions)
    out << "  differs";
  out << '\n';
}

void print_text_head(std::ostream& out, const Paper_table& table, const std::string& number)
{
  out << table.title << ", number type " << number << '\n'
      << "              |               computed              |              the paper              | ratio | ideal\n"
      << "  ex  " << (table.rows[0].label[0] == '1' ? "order " : "method")
      << "   |  cells subdiv  additions      mult. |  cells subdiv  additions      mult. | of op.| cells\n";
}

} // namespace

void print_table(std::ostream& out, const Paper_table& table, const Table_options& options)
{
  if (options.csv)
    out << "example,method_or_order,plotted,subdivisions,additions,multiplications,paper_plotted,paper_subdivisions,"
           "paper_additions,paper_multiplications,ideal\n";
  else
    print_text_head(out, table, options.number);
  double log_ratios = 0;
  bool has_mark = false;
  double done = 0;
  std::map<int, std::string> ideals;
  for (const Paper_row& row : table.rows) {
    std::string& ideal = ideals[row.example];
    if (ideal.empty()) ideal = ideal_count(row.example, table.resolution);
    const Row_counts ours = compute(row, table.resolution, options.number);
    if (options.csv)
      print_csv_row(out, row, ours, ideal);
    else
      print_text_row(out, row, ours, ideal);
    log_ratios += std::log(operations(ours) / operations(row.printed));
    has_mark = has_mark || is_printed_by_another_algorithm(row);
    done += 1;
    detail::report_or_throw(options.run, done / static_cast<double>(table.rows.size()), "reproduce");
  }
  if (options.csv) return;
  out << "Ideal: the cells that hold a zero, decided exactly; what a method plots beyond them is false.\n";
  out << "Geometric mean of the ratio of operations: " << std::setprecision(3)
      << std::exp(log_ratios / static_cast<double>(table.rows.size())) << '\n';
  if (has_mark)
    out << "* The paper's counts do not follow from the method that it describes: its subvoxel test bounded the\n"
           "  polynomial of Example 20 by MAA instead of the example's own. Computed: the method as described.\n";
}

} // namespace corral::program
