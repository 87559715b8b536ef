// SPDX-License-Identifier: LGPL-3.0-or-later
// One mistake for each CASE; 0 has none.
#include <corral/decision/ideal_system.h>
#include <corral/localization/Raster_builder.h>
#include <corral/localization/localize.h>
#if CASE == 5
#include "algebra/Bernstein_form.h"
#endif

using namespace corral;

template <std::size_t D>
using F = Polynomial<Rational, D>;

void supported(const F<2>& f, const Grid<2>& grid)
{
  (void)localize(f, grid);
  (void)localize(std::vector{f, f}, grid);
  (void)ideal_raster(f, Raster_builder<2>().finish(grid, true));
  (void)ideal_raster(std::vector{f, f}, Raster_builder<2>().finish(grid, true));
}

#if CASE == 1
void mistake(const F<4>& f, const Grid<4>& grid) { (void)localize(f, grid); }
#elif CASE == 2
void mistake(const F<1>& f, const Grid<1>& grid) { (void)localize(std::vector{f, f}, grid); }
#elif CASE == 3
void mistake(const F<4>& f, const Raster<4>& raster) { (void)ideal_raster(f, raster); }
#elif CASE == 4
void mistake(const F<1>& f, const Raster<1>& raster) { (void)ideal_raster(std::vector{f, f}, raster); }
#elif CASE == 5
int mistake(const Polynomial<Integer, 2>& f) { return exact::sign_pattern(exact::power_form(f)).closed(); }
#endif
