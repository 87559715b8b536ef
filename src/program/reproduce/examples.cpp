// SPDX-License-Identifier: LGPL-3.0-or-later
#include "examples.h"

#include <array>

namespace corral::program {

namespace {

// Example 5 has the constant -1801/50: the paper's caption prints -1801/560, but only -1801/50 gives its counts.
// clang-format off
constexpr std::array<Example, 20> list{{
    {1, 2, 3, "curve",
     "15/4 + 8*x - 16*x^2 + 8*y - 112*x*y + 128*x^2*y - 16*y^2 + 128*x*y^2 - 128*x^2*y^2"},
    {2, 2, 4, "curve",
     "20160*x^5 - 30176*x^4 + 14156*x^3 - 2344*x^2 + 151*x + 237 - 480*y"},
    {3, 2, 5, "curve",
     "945/1000*x*y - 943214/100000*x^2*y^3 + 74554/10000*x^3*y^2 + y^4 - x^3"},
    {4, 2, 6, "curve",
     "x^9 - x^7*y + 3*x^2*y^6 - y^3 + y^5 + y^4*x - 4*y^4*x^3"},
    {5, 2, 7, "curve",
     "-1801/50 + 280*x - 816*x^2 + 1056*x^3 - 512*x^4 + 1601/25*y - 512*x*y + 1536*x^2*y - 2048*x^3*y + 1024*x^4*y"},
    {6, 2, 8, "curve",
     "601/9 - 872/3*x + 544*x^2 - 512*x^3 + 256*x^4 - 2728/9*y + 2384/3*x*y - 768*x^2*y + 5104/9*y^2 - 2432/3*x*y^2 + 768*x^2*y^2 - 512*y^3 + 256*y^4"},
    {7, 2, 9, "curve",
     "-13 + 32*x - 288*x^2 + 512*x^3 - 256*x^4 + 64*y - 112*y^2 + 256*x*y^2 - 256*x^2*y^2"},
    {8, 2, 10, "curve",
     "-169/64 + 51/8*x - 11*x^2 + 8*x^3 + 9*y - 8*x*y - 9*y^2 + 8*x*y^2"},
    {9, 2, 11, "curve",
     "476/10 - 2208/10*x + 4768/10*x^2 - 512*x^3 + 256*x^4 - 2208/10*y + 512*x*y - 512*x^2*y + 4768/10*y^2 - 512*x*y^2 + 512*x^2*y^2 - 512*y^3 + 256*y^4"},
    {10, 2, 12, "curve",
     "55/256 - x + 2*x^2 - 2*x^3 + x^4 - 55/64*y + 2*x*y - 2*x^2*y + 119/64*y^2 - 2*x*y^2 + 2*x^2*y^2 - 2*y^3 + y^4"},
    {11, 3, 15, "plane",
     "x + 2*y + 3*z - 2"},
    {12, 3, 16, "sphere",
     "100*x^2 + 100*y^2 + 100*z^2 - 81"},
    {13, 3, 17, "cylinder",
     "100*x^2 + 100*y^2 - 81"},
    {14, 3, 18, "cone",
     "100*x^2 + 100*y^2 - 81*z^2"},
    {15, 3, 19, "torus",
     "64 - 500*x^2 + 625*x^4 - 500*y^2 + 1250*x^2*y^2 + 625*y^4 + 400*z^2 + 1250*x^2*z^2 + 1250*y^2*z^2 + 625*z^4"},
    {16, 3, 20, "cyclide",
     "-459 + 15600*x - 55000*x^2 + 90000*x^4 - 45000*y^2 + 180000*x^2*y^2 + 90000*y^4 + 12600*z^2 + 180000*x^2*z^2 + 180000*y^2*z^2 + 90000*z^4"},
    {17, 3, 21, "self-intersecting surface",
     "16 - 32*x - 25*x^2 + 50*x^3 - 25*y^2 + 50*x*y^2 - 25*z^2 + 50*x*z^2"},
    {18, 3, 22, "pair of parallel surfaces",
     "1296 - 3625*x^2 + 2500*x^4 - 3625*y^2 + 5000*x^2*y^2 + 2500*y^4 - 3625*z^2 + 5000*x^2*z^2 + 5000*y^2*z^2 + 2500*z^4"},
    {19, 3, 23, "two tangent spheres",
     "-16*x^2 + 25*x^4 + 50*x^2*y^2 + 25*y^4 + 50*x^2*z^2 + 50*y^2*z^2 + 25*z^4"},
    {20, 3, 24, "cone-like surface with a line singularity",
     "-1 + 4*x - 4*x^2 + 2*y^2 - 8*x*y^2 + 8*x^2*y^2 + 8*z^2"},
}};
// clang-format on

} // namespace

std::span<const Example> examples() { return list; }

} // namespace corral::program
