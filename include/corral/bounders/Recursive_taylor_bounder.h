// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BOUNDERS_RECURSIVE_TAYLOR_BOUNDER_H
#define CORRAL_BOUNDERS_RECURSIVE_TAYLOR_BOUNDER_H

#include <corral/bounders/Bounder_options.h>
#include <corral/bounders/Range_bounder.h>
#include <corral/errors.h>
#include <corral/internal/bounders/Scaled_taylor.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace corral {

/// \brief Model of `RangeBounder`: recursive Taylor expansion (RT) of any order m >= 1.
///
/// Let c be the centre and r the half-widths of the box, and s_k = r^k d^k f(c) / k! the coefficients of f in the
/// coordinates u in [-1, 1]^D of the box. The scaled derivative r^b d^b f / b! takes on the box only values in
///     B_b = s_b + sum_{0<|a|<m} C(a+b, a) s_{a+b} e_a + sum_{|a|=m} C(a+b, a) B_{a+b} e_a,
/// with e_a = [0, 1] where every exponent of a is even, else [-1, 1], and C the product of binomial coefficients;
/// B_0 bounds f. The recursion reaches a derivative along many paths; each is evaluated and bounded once a box. It
/// ends by itself at linear polynomials, whose bound is exact, because derivatives that vanish are never visited;
/// see doc/decisions/linear_polynomials.md.
///
/// \tparam I  model of `IntervalNumber`. It does all the rounding; this class does none.
/// \par Complexity  That of `Scaled_taylor::expand`, two multiplications for each of its n coefficients, and at most
///      one addition and one multiplication for each derivative bounded and each exponent a with |a| <= m.
/// \par Reference  Shou, Martin, Wang, Bowyer, Voiculescu, "A Recursive Taylor Method for Algebraic Curves and
///      Surfaces", in: Computational Methods for Algebraic Spline Surfaces, Springer 2005, 135-154.
template <IntervalNumber I, std::size_t D>
class Recursive_taylor_bounder
{
public:
  using Interval = I;
  using Polynomial = corral::Polynomial<I, D>;
  using Box = corral::Box<I, D>;
  static constexpr std::size_t dimension = D;
  static constexpr std::string_view name = "rt";

  /// \throw Invalid_input if the order is 0; Budget_exceeded as `Scaled_taylor`.
  explicit Recursive_taylor_bounder(const Polynomial& f, const Bounder_options& options = {}) : taylor_(f)
  {
    if (options.order == 0) throw Invalid_input("rt: the order is 0; expected at least 1");
    const auto exponents = taylor_.exponents();
    for (std::size_t k = 0; k < exponents.size(); ++k) places_.emplace(exponents[k], k);
    for (std::size_t k = 1; k < exponents.size(); ++k) steps_.push_back(step_to(exponents[k]));
    if (!exponents.empty()) plan(exponents, options.order);
  }

  /// \pre The sides of `box` are finite.
  [[nodiscard]] I bound(const Box& box) const
  {
    if (places_.empty()) return I(0);
    const auto values = scaled(taylor_.expand(box));
    std::vector<I> bounds(expansions_.size());
    for (std::size_t k = expansions_.size(); k-- > 0;) bounds[k] = sum(expansions_[k], values, bounds);
    return bounds[0];
  }

private:
  /// r^k is r^l times the half-width of `axis`, where l is the monomial at `place`.
  struct Step
  {
    std::size_t place;
    std::size_t axis;
  };

  /// One term C(a+b, a) x e_a of an expansion, x being a coefficient or the bound of another derivative.
  struct Part
  {
    std::size_t source;
    bool is_bounded;
    bool is_even;
    std::optional<I> factor; // none where it is 1
  };

  struct Expansion
  {
    std::size_t constant;
    std::vector<Part> parts;
  };

  [[nodiscard]] Step step_to(Exponents<D> exponents) const
  {
    const auto last = std::find_if(exponents.rbegin(), exponents.rend(), [](auto e) { return e != 0; });
    --*last;
    return {places_.at(exponents), static_cast<std::size_t>(exponents.rend() - last) - 1};
  }

  // Plans the expansions of f and of the derivatives that the recursion bounds, breadth first: each step raises the
  // sum of the exponents by the order, so that an expansion refers to later ones only.
  void plan(const std::vector<Exponents<D>>& exponents, unsigned order)
  {
    std::map<Exponents<D>, std::size_t> numbers{{Exponents<D>{}, 0}};
    std::vector<Exponents<D>> queue{Exponents<D>{}};
    const auto highest = exponents_above(exponents, order);
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const auto base = queue[next];
      Expansion expansion{places_.at(base), {}};
      for (const auto& rise : highest) {
        Exponents<D> raised;
        for (std::size_t axis = 0; axis < D; ++axis) raised[axis] = static_cast<std::uint16_t>(base[axis] + rise[axis]);
        const auto place = places_.find(raised);
        if (place == places_.end()) continue;
        Part part{place->second, sum_of(rise) == order, is_even(rise), binomial(raised, rise)};
        if (part.is_bounded) {
          const auto [number, is_new] = numbers.emplace(raised, queue.size());
          if (is_new) queue.push_back(raised);
          part.source = number->second;
        }
        expansion.parts.push_back(std::move(part));
      }
      expansions_.push_back(std::move(expansion));
    }
  }

  // The exponents a with 0 < |a| <= order by which a derivative of f can be raised.
  static std::vector<Exponents<D>> exponents_above(const std::vector<Exponents<D>>& exponents, unsigned order)
  {
    std::vector<Exponents<D>> result;
    for (const auto& candidate : exponents)
      if (const unsigned total = sum_of(candidate); total > 0 && total <= order) result.push_back(candidate);
    return result;
  }

  static unsigned sum_of(const Exponents<D>& exponents)
  {
    return std::accumulate(exponents.begin(), exponents.end(), 0U);
  }

  static bool is_even(const Exponents<D>& exponents)
  {
    return std::none_of(exponents.begin(), exponents.end(), [](auto e) { return e % 2 != 0; });
  }

  static std::optional<I> binomial(const Exponents<D>& n, const Exponents<D>& k)
  {
    Integer product = 1;
    for (std::size_t axis = 0; axis < D; ++axis) {
      Integer factor;
      mpz_bin_uiui(factor.get_mpz_t(), n[axis], k[axis]);
      product *= factor;
    }
    if (product == 1) return std::nullopt;
    return corral::enclose<I>(Rational(product));
  }

  [[nodiscard]] std::vector<I> scaled(const Centred_polynomial<I, D>& f) const
  {
    const auto& terms = f.taylor.terms();
    std::vector<I> powers(terms.size());
    std::vector<I> values(terms.size());
    values[0] = terms[0].coefficient;
    for (std::size_t k = 1; k < terms.size(); ++k) {
      const auto [place, axis] = steps_[k - 1];
      powers[k] = place == 0 ? f.radius[axis] : I(powers[place] * f.radius[axis]);
      values[k] = terms[k].coefficient * powers[k];
    }
    return values;
  }

  static I sum(const Expansion& expansion, const std::vector<I>& values, const std::vector<I>& bounds)
  {
    I result = values[expansion.constant];
    for (const Part& part : expansion.parts) {
      const I& source = part.is_bounded ? bounds[part.source] : values[part.source];
      const I weighted = part.factor ? I(source * *part.factor) : source;
      result += part.is_even ? hull_with_zero(weighted) : symmetric_hull(weighted);
    }
    return result;
  }

  Scaled_taylor<I, D> taylor_;
  std::map<Exponents<D>, std::size_t> places_;
  std::vector<Step> steps_;           // of every monomial but the constant
  std::vector<Expansion> expansions_; // that of f first; each needs later ones only
};

} // namespace corral

#endif
