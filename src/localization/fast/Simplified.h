// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_SRC_LOCALIZATION_FAST_SIMPLIFIED_H
#define CORRAL_SRC_LOCALIZATION_FAST_SIMPLIFIED_H

#include <corral/polynomial/square_free.h>

#include <cstddef>
#include <optional>

namespace corral::fast {

/// \brief A polynomial, or one with the same zeros that has none of its factors twice, where this may pay.
///
/// Near its zeros a power is smaller than what is rounded at the root, and no corner shows that an even power has any.
template <std::size_t D>
class Simplified
{
public:
  /// Tries at once where the test is little work beside making a root form. \pre `f` is not zero; it outlives this.
  explicit Simplified(const Polynomial<Rational, D>& f) : given_(f)
  {
    constexpr unsigned dear_degree = 16;
    if (f.total_degree() >= dear_degree) simplify();
  }

  /// Whether the polynomial has a repeated factor that it had not been tried to take out before.
  bool has_simpler()
  {
    if (is_tried_) return false;
    simplify();
    return simpler_.has_value();
  }

  [[nodiscard]] const Polynomial<Rational, D>& polynomial() const { return simpler_ ? *simpler_ : given_; }

private:
  void simplify()
  {
    constexpr unsigned greatest_degree = 5000; // of which the test takes a tenth of a second
    is_tried_ = true;
    if (given_.total_degree() <= greatest_degree && !is_surely_square_free(given_))
      simpler_ = transform<Rational>(square_free_part(given_), [](const Integer& c) { return Rational(c); });
  }

  const Polynomial<Rational, D>& given_;
  std::optional<Polynomial<Rational, D>> simpler_;
  bool is_tried_ = false;
};

} // namespace corral::fast

#endif
