// SPDX-License-Identifier: LGPL-3.0-or-later
#include "mesh_checks.h"
#include "rounds.h"

#include <corral/polynomial/arithmetic.h>

#include <zlib.h>

#include <array>
#include <fstream>
#include <random>
#include <regex>
#include <sstream>

namespace corral {
namespace {

/// y^2 + a1 x y + a3 y = x^3 + a2 x^2 + a4 x + a6.
struct Weierstrass
{
  std::string name;
  Integer a1, a2, a3, a4, a6;

  [[nodiscard]] Integer discriminant() const
  {
    const Integer b2 = a1 * a1 + 4 * a2;
    const Integer b4 = 2 * a4 + a1 * a3;
    const Integer b6 = a3 * a3 + 4 * a6;
    const Integer b8 = a1 * a1 * a6 + 4 * a2 * a6 - a1 * a3 * a4 + a2 * a3 * a3 - a4 * a4;
    return -b2 * b2 * b8 - 8 * b4 * b4 * b4 - 27 * b6 * b6 + 9 * b2 * b4 * b6;
  }
  [[nodiscard]] Polynomial<Rational, 2> polynomial() const
  {
    return collect<Rational, 2>({{{0, 2}, 1},
                                 {{1, 1}, Rational(a1)},
                                 {{0, 1}, Rational(a3)},
                                 {{3, 0}, -1},
                                 {{2, 0}, Rational(-a2)},
                                 {{1, 0}, Rational(-a4)},
                                 {{0, 0}, Rational(-a6)}});
  }
  /// Holds the bounded component, if there is one; the other one leaves it over its right side, once above and once
  /// below. Made from (2 y + a1 x + a3)^2 = 4 x^3 + (a1^2 + 4 a2) x^2 + (4 a4 + 2 a1 a3) x + a3^2 + 4 a6.
  [[nodiscard]] Rational_box<2> box() const
  {
    const Integer_polynomial cubic{Integer(a3 * a3 + 4 * a6), Integer(4 * a4 + 2 * a1 * a3), Integer(a1 * a1 + 4 * a2),
                                   Integer(4)};
    const Integer x = root_bound(cubic) + 1;
    Integer largest = 0; // of the cubic on [-x, x]
    for (std::size_t i = cubic.size(); i-- > 0;) largest = largest * x + abs(cubic[i]);
    const Integer y = (abs(a1) * x + abs(a3) + sqrt(largest) + 1) / 2 + 1;
    return test::box(Rational(-x), Rational(x), Rational(-y), Rational(y));
  }
};

/// "" if the mesh has one component more than one iff the discriminant is positive.
std::string complaint(const Weierstrass& e, const Curve_mesh& mesh)
{
  if (!mesh.is_certified()) return e.name + ": not certified";
  const std::size_t eggs = e.discriminant() > 0 ? 1 : 0;
  if (mesh.components.size() != eggs + 1 || mesh.closed_components() != eggs || mesh.boundary_points() != 2)
    return e.name + ": " + std::to_string(mesh.components.size()) + " components, " + std::to_string(eggs + 1)
           + " expected";
  return mesh.singular_points() == 0 ? test::find_loose_end(mesh) : e.name + ": singular";
}

Curve_mesh mesh_of(const Weierstrass& e)
{
  const auto box = e.box();
  return mesh_curve(e.polynomial(), box, {Rational(box[0].upper() / 10)});
}

TEST(elliptic_curves, of_conductor_below_100_are_right)
{
  std::ifstream file(CORRAL_TEST_DATA "/elliptic_curves.txt");
  int curves = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    Weierstrass e;
    std::istringstream(line) >> e.name >> e.a1 >> e.a2 >> e.a3 >> e.a4 >> e.a6;
    EXPECT_EQ(complaint(e, mesh_of(e)), "");
    ++curves;
  }
  EXPECT_EQ(curves, 302);
}

/// The text of a compressed file.
std::string unpacked(const char* path)
{
  std::string text;
  const gzFile file = gzopen(path, "rb");
  if (file == nullptr) return text;
  std::array<char, 1 << 16> part;
  for (int size = 0; (size = gzread(file, part.data(), part.size())) > 0;)
    text.append(part.data(), static_cast<std::size_t>(size));
  gzclose(file);
  return text;
}

// Debian's pari-elldata, where it is installed.
TEST(elliptic_curves, of_conductor_below_1000_are_right)
{
  const std::string text = unpacked(CORRAL_ELLIPTIC_CURVES);
  if (text.empty()) GTEST_SKIP() << "pari-elldata is not installed";
  const std::regex entry(R"re("(\w+)",\[(-?\d+),(-?\d+),(-?\d+),(-?\d+),(-?\d+)\])re");
  int curves = 0;
  for (std::sregex_iterator match(text.begin(), text.end(), entry), end; match != end; ++match, ++curves) {
    const auto number = [&](std::size_t k) { return Integer((*match)[k].str()); };
    const Weierstrass e{(*match)[1].str(), number(2), number(3), number(4), number(5), number(6)};
    EXPECT_EQ(complaint(e, mesh_of(e)), "");
  }
  EXPECT_EQ(curves, 5113);
}

TEST(elliptic_curves, drawn_at_random_are_right)
{
  std::mt19937 random(11);
  const auto pick = [&](long low, long high) {
    return Integer(low + static_cast<long>(random() % static_cast<unsigned long>(high - low + 1)));
  };
  int both = 0;
  const int rounds = test::rounds(300);
  for (int smooth = 0; smooth < rounds;) {
    const Weierstrass e{"random", pick(0, 1), pick(-1, 1), pick(0, 1), pick(-40, 40), pick(-60, 60)};
    if (e.discriminant() == 0) continue;
    ++smooth;
    both += e.discriminant() > 0 ? 1 : 0;
    EXPECT_EQ(complaint(e, mesh_of(e)), "") << e.a1 << ' ' << e.a2 << ' ' << e.a3 << ' ' << e.a4 << ' ' << e.a6;
  }
  EXPECT_GT(both, rounds / 10);
  EXPECT_LT(both, rounds - rounds / 10);
}

TEST(elliptic_curves, with_a_wrong_sign_are_noticed)
{
  const Weierstrass one{"one", 0, 0, 0, 1, 0};
  const Weierstrass two{"two", 0, 0, 0, -1, 0};
  EXPECT_EQ(complaint(one, mesh_of(one)), "");
  EXPECT_NE(complaint(one, mesh_of(two)), "");
  EXPECT_NE(complaint(two, mesh_of(one)), "");
}

} // namespace
} // namespace corral
