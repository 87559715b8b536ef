// SPDX-License-Identifier: LGPL-3.0-or-later
/// \file
/// Meshes of plane curves beside CGAL's analysis of the same curves, in milliseconds of processor time.
/// usage: bench_meshes [REPETITIONS], of the meshes; the median is printed. CGAL's analysis runs once.
#include "cases.h"
#include "geometry/cgal_topology.h"
#include "geometry/reference_curves.h"

#include <corral/geometry/mesh_curve.h>
#include <corral/polynomial/square_free.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace {

using namespace corral;

double now() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

template <class Work>
double median(int repetitions, Work work)
{
  std::vector<double> times;
  for (int k = 0; k < repetitions; ++k) {
    const double start = now();
    work();
    times.push_back(now() - start);
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

std::vector<test::Reference_curve> cases()
{
  auto result = test::reference_curves(CORRAL_REFERENCE_CURVES);
  for (const auto& problem : benchmark::curves()) {
    const Rational_interval unit(problem.lower, 1);
    result.push_back({problem.name, problem.f, {unit, unit}, 0, 0, 0});
  }
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  const int repetitions = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
  double all_cgal = 0;
  double all_meshes = 0;
  std::printf("%-16s %10s %10s %8s %9s\n", "curve", "CGAL", "mesh", "ratio", "vertices");
  for (const auto& [name, f, box, components, closed, isolated] : cases()) {
    const double cgal = median(1, [&f = f] { (void)test::cgal_topology(square_free_part(f)); });
    const Mesh_options options{Rational((box[0].upper() - box[0].lower()) / 1000)};
    std::size_t vertices = 0;
    const double mesh =
        median(repetitions, [&, &f = f, &box = box] { vertices = mesh_curve(f, box, options).vertices.size(); });
    all_cgal += cgal;
    all_meshes += mesh;
    std::printf("%-16s %10.2f %10.2f %8.1f %9zu\n", name.c_str(), cgal, mesh, cgal / mesh, vertices);
  }
  std::printf("%-16s %10.2f %10.2f %8.1f\n", "all", all_cgal, all_meshes, all_cgal / all_meshes);
}
