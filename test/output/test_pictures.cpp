// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/output/pictures.h>

#include "shapes.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <sstream>

namespace {

using namespace corral;

// A PNG read back.
class Picture
{
public:
  explicit Picture(const std::string& bytes) : in_(bytes)
  {
    surface_.reset(cairo_image_surface_create_from_png_stream(read, &in_));
    EXPECT_EQ(cairo_surface_status(surface_.get()), CAIRO_STATUS_SUCCESS);
  }
  [[nodiscard]] int width() const { return cairo_image_surface_get_width(surface_.get()); }
  [[nodiscard]] int height() const { return cairo_image_surface_get_height(surface_.get()); }
  [[nodiscard]] std::uint32_t at(int x, int y) const
  {
    const unsigned char* const row =
        cairo_image_surface_get_data(surface_.get()) + y * cairo_image_surface_get_stride(surface_.get());
    return reinterpret_cast<const std::uint32_t*>(row)[x] & 0xffffffU;
  }
  // How many pixels below the legend have this colour.
  [[nodiscard]] long count(std::uint32_t colour) const
  {
    long sum = 0;
    for (int y = height() / 16; y < height(); ++y)
      for (int x = 0; x < width(); ++x) sum += same(at(x, y), colour) ? 1 : 0;
    return sum;
  }

private:
  // Up to the rounding of colours.
  static bool same(std::uint32_t a, std::uint32_t b)
  {
    bool close = true;
    for (const int shift : {0, 8, 16})
      close = close && std::abs(static_cast<int>(a >> shift & 255U) - static_cast<int>(b >> shift & 255U)) <= 2;
    return close;
  }
  static cairo_status_t read(void* closure, unsigned char* data, unsigned length)
  {
    auto& in = *static_cast<std::istringstream*>(closure);
    in.read(reinterpret_cast<char*>(data), length);
    return in ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_READ_ERROR;
  }
  std::istringstream in_;
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_{nullptr, cairo_surface_destroy};
};

constexpr std::uint32_t orange = 0xd55e00;

std::string curve(const Raster<2>& cells, const Output_options& options = {})
{
  std::ostringstream out;
  draw_curve_png(out, cells, options);
  return out.str();
}

long orange_pixels(const Grid<2>& grid, const std::vector<Plotted_cell<2>>& cells)
{
  return Picture(curve(test::raster(grid, cells))).count(orange);
}

TEST(Curve_picture, draws_cells_of_equal_size)
{
  const auto grid = test::grid<2>(4);
  const long one = orange_pixels(grid, {{{1, 1}, Verdict::unknown}});
  EXPECT_GT(one, 100 * 100);
  EXPECT_EQ(orange_pixels(grid, {{{1, 1}, Verdict::unknown}, {{1, 2}, Verdict::unknown}}), 2 * one);
}

TEST(Curve_picture, loses_no_cell_of_a_large_grid)
{
  const std::uint32_t n = 1U << 30;
  const auto grid = test::grid<2>(n);
  EXPECT_EQ(orange_pixels(grid, {{{n / 3, n / 7}, Verdict::unknown}}), 1);
  EXPECT_EQ(orange_pixels(grid, {{{n / 3, n / 7}, Verdict::unknown}, {{n / 2, n / 5}, Verdict::unknown}}), 2);
}

TEST(Curve_picture, can_show_all_plotted_cells_alike)
{
  Output_options options;
  options.colouring = Colouring::plotted;
  const auto grid = test::grid<2>(4);
  EXPECT_EQ(Picture(curve(test::raster(grid, {{{1, 1}, Verdict::unknown}}), options)).count(orange), 0);
}

TEST(Curve_picture, survives_strange_boxes)
{
  const Rational huge = parse_rational("1e400");
  for (const auto& side : {Rational_interval(-huge, huge), Rational_interval(Rational(1), Rational(1) + 1 / huge),
                           Rational_interval(Rational(0), 1 / huge), Rational_interval(-1000000, -999999)})
    for (const auto& other : {side, Rational_interval(0, 1)}) {
      const Grid<2> grid({side, other}, {30, 20});
      const Picture picture(curve(test::raster(grid, {{{1, 1}, Verdict::unknown}})));
      EXPECT_GT(picture.count(orange), 0);
    }
}

TEST(Curve_picture, refuses_sizes_it_cannot_draw)
{
  Output_options options;
  for (const unsigned size : {0U, 63U, 8193U, 4000000000U}) {
    options.size = size;
    EXPECT_THROW(curve(test::raster(test::grid<2>(4), {}), options), Invalid_input);
  }
  for (const unsigned size : {64U, 100U}) {
    options.size = size;
    Picture(curve(test::raster(test::grid<2>(300), {}), options));
  }
}

TEST(Curve_picture, is_an_svg_too)
{
  std::ostringstream out;
  draw_curve_svg(out, test::raster(test::grid<2>(4), {{{1, 1}, Verdict::hit}}), {});
  EXPECT_NE(out.str().find("<svg"), std::string::npos);
  EXPECT_NE(out.str().find("</svg>"), std::string::npos);
}

std::string voxels(const Raster<3>& cells)
{
  std::ostringstream out;
  draw_voxels_png(out, cells, {});
  return out.str();
}

TEST(Voxel_picture, shows_three_faces_of_a_cube_in_three_shades)
{
  const Picture picture(voxels(test::raster(test::grid<3>(2), {{{0, 0, 0}, Verdict::hit}})));
  EXPECT_GT(picture.count(0xbfd4eb), 1000); // top
  EXPECT_GT(picture.count(0x9dadc0), 1000); // front
  EXPECT_GT(picture.count(0x768392), 500);  // right
}

TEST(Voxel_picture, hides_what_is_behind)
{
  const auto grid = test::grid<3>(8);
  const auto slab = test::select<3>(grid, [](const Cell<3>& cell) {
    return cell[1] == 0 ? Verdict::hit : cell == Cell<3>{3, 4, 1} ? Verdict::unknown : Verdict::empty;
  });
  const auto alone = test::raster(grid, {{{3, 4, 1}, Verdict::unknown}});
  const std::uint32_t top = 0xcc540d;
  const long legend = Picture(voxels(slab)).count(top);
  EXPECT_GT(Picture(voxels(alone)).count(top), legend);
}

TEST(Voxel_picture, loses_no_cell_of_a_large_grid)
{
  const std::uint32_t n = 1U << 30;
  const auto cells = test::raster(test::grid<3>(n), {{{n / 2, n / 2, n / 2}, Verdict::hit}});
  const std::string one = voxels(cells);
  std::set<std::uint32_t> colours;
  const Picture picture(one);
  // The legend says "hit 1"; beyond it something must be drawn in the middle of the box.
  for (int y = picture.height() / 3; y < 2 * picture.height() / 3; ++y)
    for (int x = picture.width() / 3; x < 2 * picture.width() / 3; ++x) colours.insert(picture.at(x, y));
  const auto is_blue = [](std::uint32_t c) { return (c & 0xffU) > (c >> 16) + 10; };
  EXPECT_TRUE(std::any_of(colours.begin(), colours.end(), is_blue));
}

} // namespace
