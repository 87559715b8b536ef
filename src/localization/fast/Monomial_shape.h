// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_MONOMIAL_SHAPE_H
#define CORRAL_SRC_LOCALIZATION_FAST_MONOMIAL_SHAPE_H

#include <corral/polynomial/Polynomial.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace corral::fast {

/// \brief Which monomials a Taylor form has: the divisors of those of a polynomial, so that shifts stay inside.
///
/// They are stored by total degree, even monomials (all exponents even) first within a degree: cutting off the
/// degrees above d keeps a prefix. Each cut that the engine may make is a *class*; class 0 is the whole shape.
template <std::size_t D>
class Monomial_shape
{
public:
  /// All monomials that differ in the exponent of one axis only, lowest exponent first.
  struct Line
  {
    std::uint32_t first;  ///< offset into `index`
    std::uint32_t degree; ///< number of monomials - 1
    Exponents<D> rest;    ///< exponents of the other axes; 0 for the axis itself
  };
  /// The lines of one axis, ordered by `rest`, last axis first, and the positions of their monomials.
  struct Lines
  {
    std::vector<Line> lines;
    std::vector<std::uint32_t> index;
  };
  /// The prefix of the shape that has total degree at most `degree`.
  struct Class
  {
    unsigned degree;
    std::size_t size;
    std::array<Lines, D> lines;
    std::vector<std::uint32_t>
        slab; ///< for each exponent of axis D - 1, its first line in lines[D - 2]; one more at the end
  };

  /// \throw Budget_exceeded if there are more than `max_size` monomials.
  explicit Monomial_shape(const std::vector<Exponents<D>>& monomials);
  explicit Monomial_shape(const Polynomial<Rational, D>& f);

  static constexpr std::size_t max_size = std::size_t{1} << 20;

  [[nodiscard]] const std::vector<Exponents<D>>& exponents() const { return exponents_; }
  [[nodiscard]] std::size_t size() const { return exponents_.size(); }
  [[nodiscard]] unsigned degree() const { return static_cast<unsigned>(degree_end_.size()) - 1; }

  /// The position after the last monomial of total degree d, and after the last even one of that degree.
  [[nodiscard]] std::size_t degree_end(unsigned d) const { return degree_end_[d]; }
  [[nodiscard]] std::size_t even_end(unsigned d) const { return even_end_[d]; }

  [[nodiscard]] const std::vector<Class>& classes() const { return classes_; }

  /// The position of a monomial of the shape.
  [[nodiscard]] std::size_t position(const Exponents<D>& exponents) const { return position_[dense(exponents)]; }

  /// The position of x_axis^power, or `size()` if the shape has no such monomial.
  [[nodiscard]] std::size_t pure_power(std::size_t axis, unsigned power) const;

private:
  [[nodiscard]] std::size_t dense(const Exponents<D>& exponents) const
  {
    std::size_t cell = 0;
    for (std::size_t axis = 0; axis < D; ++axis) cell = cell * extent_[axis] + exponents[axis];
    return cell;
  }
  void collect_divisors(const std::vector<Exponents<D>>& monomials);
  [[nodiscard]] Lines lines_of(std::size_t axis) const;

  std::array<std::size_t, D> extent_{};
  std::vector<std::uint32_t> position_; // dense table; `absent` where there is no monomial
  std::vector<Exponents<D>> exponents_;
  std::vector<std::size_t> degree_end_;
  std::vector<std::size_t> even_end_;
  std::vector<Class> classes_;
};

extern template class Monomial_shape<2>;
extern template class Monomial_shape<3>;

} // namespace corral::fast

#endif
