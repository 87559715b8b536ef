// SPDX-License-Identifier: LGPL-3.0-or-later
// Included once for each instruction set, by fast_engine.cpp.
#if defined(CORRAL_SRC_FAST_LEAF_FORM_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CORRAL_SRC_FAST_LEAF_FORM_INL_H
#undef CORRAL_SRC_FAST_LEAF_FORM_INL_H
#else
#define CORRAL_SRC_FAST_LEAF_FORM_INL_H
#endif

#include "Exact_limits.h"
#include "Monomial_shape.h"
#include "arithmetic-inl.h"

HWY_BEFORE_NAMESPACE();
namespace corral::fast::HWY_NAMESPACE {

/// Eight leaf forms, one lane each.
template <std::size_t D>
struct Leaf_batch
{
  const typename Monomial_shape<D>::Class& cut;
  const double* coefficients;    ///< an octet each
  const double* remainder;       ///< an octet
  const double* norm;            ///< an octet
  const double (*corner)[batch]; ///< D octets
  const Exact_limits& exact;     ///< of all leaves
  unsigned lanes;                ///< those that hold a leaf to decide
};

/// \brief Eight forms of one class, one a lane, evaluated by Horner's rule along rows of points.
///
/// The coordinates are fixed one after the other: first that of axis D - 2, in space then that of axis 0; the last one
/// runs along the row.
template <std::size_t D>
class Leaf_form
{
public:
  using Cut = typename Monomial_shape<D>::Class;

  /// Doubles in a workspace that is large enough for every class.
  [[nodiscard]] static std::size_t workspace_size(const Monomial_shape<D>& shape)
  {
    return (shape.size() + shape.degree() + 1) * batch;
  }

  /// \param coefficients  an octet each. \param with  knows which lanes round nothing.
  Leaf_form(const Cut& cut, const double* coefficients, double* workspace, const Arithmetic& with)
      : cut_(cut), lines_(cut.lines[D - 2]), c_(coefficients), in_lines_(workspace),
        powers_(D == 2 ? in_lines_ : in_lines_ + lines_.lines.size() * batch), with_(with)
  {}

  HWY_INLINE void fix_axis_before_last(const Octet& x) const
  {
    double* to = in_lines_;
    for (const auto& line : lines_.lines) {
      const std::uint32_t* const index = lines_.index.data() + line.first;
      Octet value = load(c_ + index[line.degree] * batch);
      for (std::uint32_t e = line.degree; e-- > 0;) value = step(value, x, load(c_ + index[e] * batch));
      store(value, to);
      to += batch;
    }
  }

  /// \pre D == 3, and the axis before the last is fixed.
  HWY_INLINE void fix_first_axis(const Octet& x) const
  {
    for (std::size_t k = 0; k <= degree(); ++k) {
      std::size_t line = cut_.slab[k + 1] - std::size_t{1};
      Octet value = load(in_lines_ + line * batch);
      while (line-- > cut_.slab[k]) value = step(value, x, load(in_lines_ + line * batch));
      store(value, powers_ + k * batch);
    }
  }

  /// That of the last axis.
  [[nodiscard]] std::size_t degree() const { return cut_.slab.size() - 2; }

  /// Calls `visit(value)` at `coordinate(k)` for k from 0 to `points`. \pre All other axes are fixed.
  template <class Coordinate, class Visit>
  HWY_INLINE void along_row(std::size_t points, const Coordinate& coordinate, const Visit& visit) const
  {
    for (std::size_t k = 0; k < points; ++k) {
      const Octet x = coordinate(k);
      Octet value = load(powers_ + degree() * batch);
      for (std::size_t e = degree(); e-- > 0;) value = step(value, x, load(powers_ + e * batch));
      visit(value);
    }
  }

  /// \brief Calls `visit(k, value)` at -1 + k / 4 for k from 0 to 8. \pre All other axes are fixed.
  ///
  /// Even and odd powers apart: their sum and their difference are the values at x and at -x.
  /// \tparam degree_  `degree()`, or 0 for any.
  template <std::size_t degree_, class Visit>
  HWY_INLINE void along_symmetric_row(const Visit& visit) const
  {
    const std::size_t top = degree_ == 0 ? degree() : degree_;
    const auto c = [&](std::size_t e) HWY_ATTR { return load(powers_ + e * batch); };
    for (std::size_t k = 1; k <= 4; ++k) {
      const double x = 0.25 * static_cast<double>(k);
      const auto every_other = [&](std::size_t e) HWY_ATTR {
        Octet value = c(e);
        for (; e >= 2; e -= 2) value = step(value, set(x * x), c(e - 2));
        return value;
      };
      const Octet even = every_other(top - top % 2);
      const Octet odd = top == 0 ? set(0) : with_.product(every_other(top - 1 + top % 2), set(x));
      visit(4 + k, with_.sum(even, odd));
      visit(4 - k, with_.difference(even, odd));
    }
    visit(4, c(0));
  }

private:
  /// One step of Horner's rule.
  [[nodiscard]] HWY_INLINE Octet step(const Octet& value, const Octet& x, const Octet& next) const
  {
    return with_.sum(with_.product(value, x), next);
  }

  const Cut& cut_;
  const typename Monomial_shape<D>::Lines& lines_;
  const double* c_;
  double* in_lines_; // values of the lines of axis D - 2
  double* powers_;   // coefficients of the powers of the last coordinate
  Arithmetic with_;
};

} // namespace corral::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
