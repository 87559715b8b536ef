// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Side_zeros.h"

#include "../algebra/Bivariate.h"
#include "../algebra/restriction.h"

#include <corral/number/Double_bracket.h>

#include <algorithm>
#include <cmath>

namespace corral::geometry {

namespace {

/// Part [low, high] of a side, in the side's own coordinate.
struct Part
{
  std::vector<double> b;
  double error;
  double low;
  double high;
  std::array<int, 2> ends;
};

double largest(const std::vector<double>& b)
{
  double result = 0;
  for (const double c : b) result = std::max(result, std::fabs(c));
  return result;
}

int certain_sign(double value, double error) { return value > error ? 1 : value < -error ? -1 : 0; }

/// How many zeros lie inside a part, if Descartes' rule tells that it is none or one; else -1.
int count(const Part& part)
{
  int sign = part.ends[0];
  int variations = 0;
  int doubtful = 0; // coefficients without certain sign since the last one with
  const std::size_t n = part.b.size() - 1;
  for (std::size_t i = 1; i <= n; ++i) {
    const int next = i == n ? part.ends[1] : certain_sign(part.b[i], part.error);
    if (next == 0) {
      if (i == n && doubtful > 0) return -1;
      doubtful += i < n ? 1 : 0;
      continue;
    }
    // One between opposite signs makes no difference; two may be a change back and forth.
    if (doubtful > 1 || (doubtful == 1 && next != -sign)) return -1;
    if (next == -sign) ++variations;
    sign = next;
    doubtful = 0;
  }
  return variations <= 1 && sign != 0 ? variations : -1;
}

/// The part below `where`; `part` keeps the part above. Nothing if the sign there is not certain.
std::optional<Part> cut(Part& part, double where)
{
  Part lower{std::vector<double>(part.b.size()), 0, part.low, part.low + where * (part.high - part.low), part.ends};
  const std::size_t n = part.b.size() - 1;
  part.error += cut_error(n, largest(part.b));
  cut_line(part.b.data(), lower.b.data(), n, 1, where);
  lower.error = part.error;
  part.low = lower.high;
  part.ends[0] = lower.ends[1] = certain_sign(part.b[0], part.error);
  if (part.ends[0] == 0) return std::nullopt;
  return lower;
}

/// \brief Shortens a part with one zero and opposite signs at its ends to `width`; false if the signs give out before.
bool shorten(Part& part, double width)
{
  double reach = 0.125; // the guess by the secant should be as good as this
  while (part.high - part.low > width) {
    const double secant = part.b.front() / (part.b.front() - part.b.back());
    const double middle = secant >= 0 && secant <= 1 ? secant : 0.5; // the doubles at the ends may have equal signs
    const double below = std::floor((middle - reach) * 0x1p12) * 0x1p-12; // few bits, exact in what follows
    const double above = std::ceil((middle + reach) * 0x1p12) * 0x1p-12;
    bool guessed = true;
    if (below > 0 && below < 1) {
      auto lower = cut(part, below);
      if (!lower) return false;
      guessed = lower->ends[0] == lower->ends[1];
      if (!guessed) part = std::move(*lower);
    }
    const double rest = below > 0 ? std::ceil((above - below) / (1 - below) * 0x1p12) * 0x1p-12 : above;
    if (guessed && rest > 0 && rest < 1) {
      auto lower = cut(part, rest);
      if (!lower) return false;
      guessed = lower->ends[0] != lower->ends[1];
      if (guessed) part = std::move(*lower);
    }
    reach = guessed ? std::max(reach * reach, 0x1p-9) : 0.25;
  }
  return true;
}

class Isolator
{
public:
  Isolator(const Segment& side, double width) : side_(side), width_(width / (side.high - side.low)) {}

  [[nodiscard]] bool run(Part part, unsigned depth)
  {
    const int zeros = count(part);
    if (zeros == 0)
      return note_sign(part.ends[0] != 0 ? part.ends[0] : part.ends[1] != 0 ? part.ends[1] : sign_of(part));
    if (zeros == 1 && part.ends[0] != 0 && part.ends[1] != 0) {
      note_sign(part.ends[0]);
      const int after = part.ends[1];
      if (!shorten(part, width_)) return false;
      result_.zeros.push_back(range(part));
      result_.signs.push_back(after);
      return true;
    }
    if (depth == 0) return false;
    auto lower = cut(part, 0.5);
    return lower && run(std::move(*lower), depth - 1) && run(std::move(part), depth - 1);
  }
  [[nodiscard]] std::optional<Side_zeros> take()
  {
    for (std::size_t k = 0; k + 1 < result_.zeros.size(); ++k)
      if (result_.zeros[k].high > result_.zeros[k + 1].low) return std::nullopt;
    return std::move(result_);
  }

private:
  bool note_sign(int sign)
  {
    if (result_.signs.size() == result_.zeros.size()) result_.signs.push_back(sign);
    return true;
  }
  static int sign_of(const Part& part)
  {
    for (std::size_t i = 1; i + 1 < part.b.size(); ++i)
      if (const int sign = certain_sign(part.b[i], part.error); sign != 0) return sign;
    return 0;
  }
  /// The part in the coordinate of the unit box, rounding included.
  [[nodiscard]] Range range(const Part& part) const
  {
    const double length = side_.high - side_.low;
    const double rounding = 0x1p-47 * length + 0x1p-52; // of all cuts together
    return {std::max(side_.low, side_.low + part.low * length - rounding),
            std::min(side_.high, side_.low + part.high * length + rounding)};
  }

  const Segment& side_;
  double width_;
  Side_zeros result_;
};

/// f on the line of a side.
Integer_polynomial on_line(const Polynomial<Integer, 2>& f, std::size_t normal, double at)
{
  const auto line = exact::restriction(f, normal, Rational(at));
  return integer_polynomial(transform<Rational>(line, [](const Integer& c) { return Rational(c); }));
}

Rational between(Real_root& a, Real_root& b)
{
  while (a.upper() == b.lower() && (a.is_point() || b.is_point())) {
    a.refine();
    b.refine();
  }
  return (a.upper() + b.lower()) / 2;
}

Side_zeros isolate_by_integers(const Integer_polynomial& p, const Segment& side, double width)
{
  const Rational low(side.low);
  const Rational high(side.high);
  auto roots = isolate_real_roots(p, Rational_interval(low, high));
  std::erase_if(
      roots, [&](const Real_root& root) { return root.is_point() && (root.lower() == low || root.lower() == high); });
  Side_zeros result;
  for (std::size_t k = 0; k < roots.size(); ++k) {
    roots[k].refine_to(Rational(width));
    const auto below = bracket(roots[k].lower()).below;
    const auto above = bracket(roots[k].upper()).above;
    result.zeros.push_back({std::max(side.low, below == above ? below - 0x1p-52 : below),
                            std::min(side.high, below == above ? above + 0x1p-52 : above)});
  }
  for (std::size_t k = 0; k <= roots.size(); ++k) {
    Rational sample;
    if (roots.empty())
      sample = (low + high) / 2;
    else if (k == 0) {
      while (roots[0].lower() == low) roots[0].refine();
      sample = (low + roots[0].lower()) / 2;
    } else if (k == roots.size()) {
      while (roots[k - 1].upper() == high) roots[k - 1].refine();
      sample = (high + roots[k - 1].upper()) / 2;
    } else
      sample = between(roots[k - 1], roots[k]);
    result.signs.push_back(corral::sign_at(p, sample));
  }
  for (std::size_t k = 0; k + 1 < result.zeros.size(); ++k)
    if (result.zeros[k].high > result.zeros[k + 1].low) {
      if (width >= 0x1p-70) return isolate_by_integers(p, side, width / 1024);
      result.are_apart = false; // no doubles lie between them
    }
  return result;
}

} // namespace

std::optional<Side_zeros> isolate(std::vector<double> coefficients, double error, const std::array<int, 2>& ends,
                                  const Segment& side, double width)
{
  constexpr unsigned max_depth = 20;
  Isolator isolator(side, width);
  if (coefficients.size() == 1) return Side_zeros{{}, {ends[0] != 0 ? ends[0] : ends[1]}};
  if (!isolator.run({std::move(coefficients), error, 0, 1, ends}, max_depth)) return std::nullopt;
  return isolator.take();
}

Side_zeros isolate_exactly(const Polynomial<Integer, 2>& f, const std::array<int, 2>& ends, const Segment& side,
                           double width)
{
  const auto p = on_line(f, side.normal, side.at);
  if (p.is_zero()) throw Not_generic{};
  const auto q = compose_affine(p, Rational(side.low), Rational(side.high) - Rational(side.low));
  if (auto zeros = isolate(rounded(bernstein_coefficients(q)), rounding, ends, side, width)) return std::move(*zeros);
  return isolate_by_integers(p, side, width);
}

Range range_on_part(std::vector<double> coefficients, double error, const Range& part)
{
  const std::size_t n = coefficients.size() - 1;
  std::vector<double> lower(n + 1);
  if (part.low > 0) {
    error += cut_error(n, largest(coefficients));
    cut_line(coefficients.data(), lower.data(), n, 1, part.low);
  }
  if (part.high < 1) {
    const double where = std::min(1.0, (part.high - part.low) / (1 - part.low) + 0x1p-50); // rounded outward
    error += cut_error(n, largest(coefficients));
    cut_line(coefficients.data(), lower.data(), n, 1, where);
    coefficients = std::move(lower);
  }
  const auto [least, greatest] = std::minmax_element(coefficients.begin(), coefficients.end());
  return {*least - error, *greatest + error};
}

int sign_on_side(const Polynomial<Integer, 2>& f, std::size_t normal, double at, const Range& part)
{
  return strict_sign(evaluate(on_line(f, normal, at), Rational_interval(Rational(part.low), Rational(part.high))));
}

int sign_at(const Polynomial<Integer, 2>& f, double x, double y)
{
  const auto line = on_line(f, 0, x);
  return line.is_zero() ? 0 : corral::sign_at(line, Rational(y));
}

} // namespace corral::geometry
