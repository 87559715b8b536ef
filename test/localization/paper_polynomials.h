// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_TEST_LOCALIZATION_PAPER_POLYNOMIALS_H
#define CORRAL_TEST_LOCALIZATION_PAPER_POLYNOMIALS_H

#include <corral/localization/Grid.h>
#include <corral/polynomial/parse.h>

#include <array>
#include <cstdint>
#include <string_view>

/// \file
/// The twenty polynomials of Shou, Martin, Wang, Bowyer and Voiculescu (2005), with the cells that MAA plots in
/// Tables 1 and 2 (256^2 pixels of [0, 1]^2, 32^3 voxels of [-1, 1]^3).
namespace corral::test {

struct Paper_polynomial
{
  std::string_view text;
  std::uint64_t maa_cells;
};

inline constexpr std::array<Paper_polynomial, 10> paper_curves{{
    {"15/4 + 8*x - 16*x^2 + 8*y - 112*x*y + 128*x^2*y - 16*y^2 + 128*x*y^2 - 128*x^2*y^2", 526},
    {"20160*x^5 - 30176*x^4 + 14156*x^3 - 2344*x^2 + 151*x + 237 - 480*y", 433},
    {"945/1000*x*y - 943214/100000*x^2*y^3 + 74554/10000*x^3*y^2 + y^4 - x^3", 608},
    {"x^9 - x^7*y + 3*x^2*y^6 - y^3 + y^5 + y^4*x - 4*y^4*x^3", 816},
    {"-1801/50 + 280*x - 816*x^2 + 1056*x^3 - 512*x^4 + 1601/25*y - 512*x*y + 1536*x^2*y - 2048*x^3*y + 1024*x^4*y",
     464},
    {"601/9 - 872/3*x + 544*x^2 - 512*x^3 + 256*x^4 - 2728/9*y + 2384/3*x*y - 768*x^2*y + 5104/9*y^2 - 2432/3*x*y^2 + "
     "768*x^2*y^2 - 512*y^3 + 256*y^4",
     460},
    {"-13 + 32*x - 288*x^2 + 512*x^3 - 256*x^4 + 64*y - 112*y^2 + 256*x*y^2 - 256*x^2*y^2", 512},
    {"-169/64 + 51/8*x - 11*x^2 + 8*x^3 + 9*y - 8*x*y - 9*y^2 + 8*x*y^2", 818},
    {"476/10 - 2208/10*x + 4768/10*x^2 - 512*x^3 + 256*x^4 - 2208/10*y + 512*x*y - 512*x^2*y + 4768/10*y^2 - 512*x*y^2 "
     "+ 512*x^2*y^2 - 512*y^3 + 256*y^4",
     1144},
    {"55/256 - x + 2*x^2 - 2*x^3 + x^4 - 55/64*y + 2*x*y - 2*x^2*y + 119/64*y^2 - 2*x*y^2 + 2*x^2*y^2 - 2*y^3 + y^4",
     784},
}};

inline constexpr std::array<Paper_polynomial, 10> paper_surfaces{{
    {"x + 2*y + 3*z - 2", 1791},
    {"100*x^2 + 100*y^2 + 100*z^2 - 81", 3992},
    {"100*x^2 + 100*y^2 - 81", 3712},
    {"100*x^2 + 100*y^2 - 81*z^2", 3272},
    {"64 - 500*x^2 + 625*x^4 - 500*y^2 + 1250*x^2*y^2 + 625*y^4 + 400*z^2 + 1250*x^2*z^2 + 1250*y^2*z^2 + 625*z^4",
     2144},
    {"-459 + 15600*x - 55000*x^2 + 90000*x^4 - 45000*y^2 + 180000*x^2*y^2 + 90000*y^4 + 12600*z^2 + 180000*x^2*z^2 + "
     "180000*y^2*z^2 + 90000*z^4",
     2344},
    {"16 - 32*x - 25*x^2 + 50*x^3 - 25*y^2 + 50*x*y^2 - 25*z^2 + 50*x*z^2", 5256},
    {"1296 - 3625*x^2 + 2500*x^4 - 3625*y^2 + 5000*x^2*y^2 + 2500*y^4 - 3625*z^2 + 5000*x^2*z^2 + 5000*y^2*z^2 + "
     "2500*z^4",
     9376},
    {"-16*x^2 + 25*x^4 + 50*x^2*y^2 + 25*y^4 + 50*x^2*z^2 + 50*y^2*z^2 + 25*z^4", 1816},
    {"-1 + 4*x - 4*x^2 + 2*y^2 - 8*x*y^2 + 8*x^2*y^2 + 8*z^2", 3416},
}};

inline Polynomial<Rational, 2> paper_curve(std::size_t k)
{
  return parse_polynomial<2>(paper_curves[k].text, {"x", "y"});
}
inline Polynomial<Rational, 3> paper_surface(std::size_t k)
{
  return parse_polynomial<3>(paper_surfaces[k].text, {"x", "y", "z"});
}

inline Grid<2> paper_grid_2(std::uint32_t n) { return {{Rational_interval(0, 1), Rational_interval(0, 1)}, {n, n}}; }
inline Grid<3> paper_grid_3(std::uint32_t n)
{
  const Rational_interval side(-1, 1);
  return {{side, side, side}, {n, n, n}};
}

} // namespace corral::test

#endif
