// SPDX-License-Identifier: LGPL-3.0-or-later
// make_surface_mesh on f(x, y, z) = EXPRESSION, which is negative at 0, in the ball of the given radius about 0.
// usage: mesh RADIUS SIZE   with the bound SIZE on facets and on their distance from the surface; prints triangles
#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>

#include <cstdio>
#include <cstdlib>

using Triangulation = CGAL::Surface_mesh_default_triangulation_3;
using Complex = CGAL::Complex_2_in_triangulation_3<Triangulation>;
using Traits = Triangulation::Geom_traits;

double f(Traits::Point_3 point)
{
  const double x = point.x(), y = point.y(), z = point.z();
  return EXPRESSION;
}

int main(int, char** arguments)
{
  const double radius = std::atof(arguments[1]), size = std::atof(arguments[2]);
  CGAL::get_default_random() = CGAL::Random(1); // of the rays that it starts from
  Triangulation triangulation;
  Complex complex(triangulation);
  const CGAL::Implicit_surface_3<Traits, double (*)(Traits::Point_3)> surface(
      &f, Traits::Sphere_3(CGAL::ORIGIN, radius * radius));
  const CGAL::Surface_mesh_default_criteria_3<Triangulation> criteria(30, size, size);
  CGAL::make_surface_mesh(complex, surface, criteria, CGAL::Manifold_tag());

  for (auto facet = complex.facets_begin(); facet != complex.facets_end(); ++facet)
    for (int i = 1; i <= 3; ++i) {
      const auto point = facet->first->vertex((facet->second + i) % 4)->point();
      std::printf("%.17g,%.17g,%.17g%c", point.x(), point.y(), point.z(), i < 3 ? ',' : '\n');
    }
}
