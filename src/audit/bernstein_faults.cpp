// SPDX-License-Identifier: LGPL-3.0-or-later
#include "fault_harness.h"

#include <corral/polynomial/substitution.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace corral::audit {
namespace {

using Exact = Rational_interval;
using Point = std::array<Rational, 2>;

/// \brief The hull of the Bernstein coefficients. A fault derives from this. The control: nothing may be caught.
struct Sound_basis
{
  static constexpr std::string_view name = "no_fault_bernstein";
  static constexpr std::string_view description = "Bernstein coefficients as they are";
  static unsigned degree(unsigned degree_of_f) { return degree_of_f; }
  /// The row of Pascal's triangle by which power coefficients are divided.
  static unsigned row(unsigned degree) { return degree; }
};

Rational binomial_ratio(unsigned i, unsigned n, unsigned k)
{
  Integer numerator;
  Integer denominator;
  mpz_bin_uiui(numerator.get_mpz_t(), i, k);
  mpz_bin_uiui(denominator.get_mpz_t(), n, k);
  Rational ratio(numerator, denominator);
  ratio.canonicalize();
  return ratio;
}

template <class Basis>
struct Bernstein
{
  static constexpr std::string_view name = Basis::name;
  static constexpr std::string_view description = Basis::description;
  explicit Bernstein(const Exact_polynomial& given) : f(given) {}

  [[nodiscard]] Exact bound(const Exact_box& box) const
  {
    const Point low = {box[0].lower(), box[1].lower()};
    const Point width = {Rational(box[0].upper() - low[0]), Rational(box[1].upper() - low[1])};
    const auto g = affine_substitution(f, low, width);
    const std::array<unsigned, 2> degree = {Basis::degree(g.degree(0)), Basis::degree(g.degree(1))};
    std::optional<Exact> values;
    for (unsigned i = 0; i <= degree[0]; ++i)
      for (unsigned j = 0; j <= degree[1]; ++j) {
        Rational sum = 0;
        for (const auto& [k, c] : g.terms())
          if (k[0] <= i && k[1] <= j)
            sum += c * binomial_ratio(i, Basis::row(degree[0]), k[0]) * binomial_ratio(j, Basis::row(degree[1]), k[1]);
        values = values ? hull(*values, Exact(sum)) : Exact(sum);
      }
    return *values;
  }
  Exact_polynomial f;
};

struct Bernstein_degree_too_low : Sound_basis
{
  static constexpr std::string_view name = "bernstein_degree_too_low";
  static constexpr std::string_view description = "the Bernstein basis is of one degree less than the polynomial";
  static unsigned degree(unsigned degree_of_f) { return std::max(degree_of_f, 1U) - 1; }
};

struct Bernstein_wrong_binomials : Sound_basis
{
  static constexpr std::string_view name = "bernstein_wrong_binomials";
  static constexpr std::string_view description =
      "the binomial coefficients come from the next row of Pascal's triangle";
  static unsigned row(unsigned degree) { return degree + 1; }
};

} // namespace

std::vector<Planted_bounder> bernstein_faults()
{
  return {planted<Bernstein<Bernstein_degree_too_low>>(), planted<Bernstein<Bernstein_wrong_binomials>>()};
}

std::vector<Planted_bounder> sound_bernstein_forms() { return {planted<Bernstein<Sound_basis>>()}; }

} // namespace corral::audit
