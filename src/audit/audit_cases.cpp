// SPDX-License-Identifier: LGPL-3.0-or-later
#include "case_polynomials.h"

#include <corral/audit/Trouble_source.h>
#include <corral/audit/audit_cases.h>
#include <corral/number/Double_bracket.h>
#include <corral/polynomial/arithmetic.h>
#include <corral/polynomial/evaluate.h>
#include <corral/polynomial/print.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace corral {
namespace {

/// A stream of its own for each purpose, seed and number, by the finaliser of SplitMix64 (Steele, Lea, Flood 2014).
Trouble_source source_of(std::uint64_t purpose, std::uint64_t seed, std::uint64_t number)
{
  const auto mixed = [](std::uint64_t x) {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
  };
  return Trouble_source(mixed(mixed(mixed(purpose) ^ seed) ^ number));
}

/// The double next below `x`, or above it: no rounding is then hidden in the enclosure of the box.
Rational double_near(const Rational& x, bool above)
{
  const auto doubles = bracket(x);
  const double chosen = above ? doubles.above : doubles.below;
  return std::isfinite(chosen) ? Rational(chosen) : x;
}

Rational next_double(const Rational& x)
{
  const double next = std::nextafter(bracket(x).below, std::numeric_limits<double>::infinity());
  return std::isfinite(next) ? Rational(next) : Rational(x + 1);
}

Rational_interval random_side(Trouble_source& source)
{
  const Rational centre = source.chance(3) ? Rational(0) : source.full_mantissa();
  const Integer share = Integer(1) << static_cast<unsigned>(source.integer(0, 12));
  Rational radius = abs(source.full_mantissa()) / share;
  switch (source.integer(0, 15)) {
  case 0: // nothing is rounded here
    return {Rational(-1), Rational(1)};
  case 1:
    return {Rational(Rational(source.integer(-4, 0)) / 2), Rational(Rational(source.integer(1, 6)) / 2)};
  case 2: { // the width of one double
    const Rational low = double_near(source.full_mantissa(), false);
    return {low, next_double(low)};
  }
  case 3: { // the middle is no double
    const Rational low = double_near(radius * Trouble_source::scaled(1, -source.integer(40, 80)), false);
    return {low, double_near(abs(source.full_mantissa()) + 1, true)};
  }
  case 4: { // ends that are no doubles
    const Rational low = source.fraction() / 100000;
    return {low, low + abs(source.fraction()) / 1000000};
  }
  case 5: // subnormal
    return {Rational(-abs(source.trouble()) * Trouble_source::scaled(1, -1060)), Trouble_source::scaled(1, -1070)};
  case 6:
    return {Rational(centre - radius * Trouble_source::scaled(1, -100)),
            Rational(centre + radius * Trouble_source::scaled(1, -100))};
  case 7: // so narrow that overestimation hides nothing
    radius *= Trouble_source::scaled(1, -40);
    [[fallthrough]];
  default:
    return {double_near(centre - radius, false), double_near(centre + radius, true)};
  }
}

template <std::size_t D>
Rational_box<D> random_box(Trouble_source& source)
{
  Rational_box<D> box;
  const bool has_points = source.chance(2);
  for (auto& side : box) {
    side = random_side(source);
    if (has_points && !source.chance(4)) side = Rational_interval(source.chance(2) ? side.lower() : side.upper());
  }
  return box;
}

/// A part of `box`, a half along some axes.
template <std::size_t D>
Rational_box<D> part_of(Trouble_source& source, const Rational_box<D>& box)
{
  Rational_box<D> part;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const Rational& low = box[axis].lower();
    const Rational& high = box[axis].upper();
    const Rational middle = double_near(Rational((low + high) / 2), true);
    const bool is_cut = low <= middle && middle <= high && !source.chance(4);
    part[axis] = !is_cut            ? box[axis]
                 : source.chance(2) ? Rational_interval(low, middle)
                                    : Rational_interval(middle, high);
  }
  return part;
}

Rational coordinate(Trouble_source& source, const Rational_interval& side)
{
  switch (source.integer(0, 7)) {
  case 0: // where even powers are least
    if (sgn(side.lower()) < 0 && sgn(side.upper()) > 0) return 0;
    [[fallthrough]];
  case 1:
    return (side.lower() + side.upper()) / 2;
  case 2:
  case 3:
    return side.lower() + (side.upper() - side.lower()) * Rational(source.integer(0, 64)) / 64;
  default: // monotone functions are greatest at a corner
    return source.chance(2) ? side.lower() : side.upper();
  }
}

template <std::size_t D>
Probed_box<D> probed(Trouble_source& source, const Polynomial<Rational, D>& f, const Rational_box<D>& box)
{
  constexpr std::uint64_t points = 16;
  const bool is_point =
      std::all_of(box.begin(), box.end(), [](const auto& side) { return side.lower() == side.upper(); });
  Probed_box<D> result{box, {}, {}, {}, {}, is_point ? 1 : points};
  for (std::uint64_t i = 0; i < result.points; ++i) {
    Rational_point<D> point;
    for (std::size_t axis = 0; axis < D; ++axis) point[axis] = coordinate(source, box[axis]);
    const Rational value = evaluate(f, point);
    if (i == 0 || value < result.least) {
      result.least = value;
      result.lowest = point;
    }
    if (i == 0 || value > result.greatest) {
      result.greatest = value;
      result.highest = point;
    }
  }
  return result;
}

/// A block of a grid: a box that halving its padded grid reaches, cut off at its end.
template <std::size_t D>
Rational_box<D> block_of(Trouble_source& source, const Audit_subject<D>& subject)
{
  Rational_box<D> box;
  const auto level = source.integer(0, static_cast<long>(std::ceil(std::log2(subject.resolution))));
  const long size = std::max(1L, static_cast<long>(subject.resolution) >> level);
  for (std::size_t axis = 0; axis < D; ++axis) {
    const auto& side = subject.domain[axis];
    const Rational step = (side.upper() - side.lower()) / subject.resolution;
    const long first = source.integer(0, static_cast<long>(subject.resolution) / size - 1) * size;
    box[axis] = Rational_interval(side.lower() + step * first, side.lower() + step * (first + size));
  }
  return box;
}

} // namespace

template <std::size_t D>
Audit_case<D> generated_case(std::uint64_t seed, std::uint64_t number)
{
  auto source = source_of(1, seed, number);
  Audit_case<D> result{audit::generated_polynomial<D>(source), {}};
  const auto add = [&](const Rational_box<D>& box) { result.boxes.push_back(probed(source, result.polynomial, box)); };
  const auto whole = random_box<D>(source);
  add(part_of(source, whole)); // what a bounder remembers of a box is too narrow for the next
  add(whole);
  add(part_of(source, whole));
  add(random_box<D>(source));
  return result;
}

template <std::size_t D>
Audit_case<D> subject_case(const Audit_subject<D>& subject, std::uint64_t seed, std::uint64_t number)
{
  auto source = source_of(2, seed, number);
  Audit_case<D> result{subject.polynomial, {}};
  for (int i = 0; i < 3; ++i) result.boxes.push_back(probed(source, result.polynomial, block_of(source, subject)));
  return result;
}

template <std::size_t D>
Audit_case<D> tightness_case(std::uint64_t seed, std::uint64_t number)
{
  auto source = source_of(3, seed, number);
  Audit_case<D> result{{}, {}};
  const long degree = source.integer(1, D == 1 ? 12 : D == 2 ? 8 : 4);
  std::vector<typename Polynomial<Rational, D>::Term> terms;
  for (long n = source.integer(2, 8); n > 0; --n) {
    Exponents<D> exponents{};
    for (long left = degree; auto& e : exponents) {
      e = static_cast<std::uint16_t>(source.integer(0, left));
      left -= e;
    }
    terms.push_back({exponents, Rational(source.integer(-1024, 1024), 1024)});
    terms.back().coefficient.canonicalize();
  }
  result.polynomial = collect<Rational, D>(std::move(terms));
  const long level = source.integer(0, 12);
  Rational_box<D> box;
  for (auto& side : box) {
    const Rational low = Trouble_source::scaled(source.integer(0, (1L << level) - 1), 1 - level) - 1;
    side = Rational_interval(low, low + Trouble_source::scaled(1, 1 - level));
  }
  result.boxes.push_back(probed(source, result.polynomial, box));
  return result;
}

template <std::size_t D>
std::string to_string(const Rational_box<D>& box)
{
  std::string text;
  for (const auto& side : box)
    text += (text.empty() ? "[" : " x [") + to_string(side.lower()) + ", " + to_string(side.upper()) + "]";
  return text;
}

template <std::size_t D>
std::string to_string(const Polynomial<Rational, D>& f)
{
  constexpr const char* variables[] = {"x", "y", "z", "w"};
  std::array<std::string, D> names;
  std::copy_n(std::begin(variables), D, names.begin());
  return to_string(f, names);
}

#define CORRAL_INSTANTIATE(D)                                                                                          \
  template Audit_case<D> generated_case<D>(std::uint64_t, std::uint64_t);                                              \
  template Audit_case<D> subject_case(const Audit_subject<D>&, std::uint64_t, std::uint64_t);                          \
  template Audit_case<D> tightness_case<D>(std::uint64_t, std::uint64_t);                                              \
  template std::string to_string(const Rational_box<D>&);                                                              \
  template std::string to_string(const Polynomial<Rational, D>&);
CORRAL_INSTANTIATE(1)
CORRAL_INSTANTIATE(2)
CORRAL_INSTANTIATE(3)
CORRAL_INSTANTIATE(4)
#undef CORRAL_INSTANTIATE

} // namespace corral
