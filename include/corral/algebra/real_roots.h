// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_ALGEBRA_REAL_ROOTS_H
#define CORRAL_ALGEBRA_REAL_ROOTS_H

#include <corral/algebra/Integer_polynomial.h>
#include <corral/internal/algebra/Checkpoint.h>

#include <memory>
#include <utility>
#include <vector>

/// \file
/// Real roots of integer polynomials: isolation, refinement, counting, signs. All exact.
namespace corral {

/// \brief One real root of a polynomial, known by an isolating interval that can be made as short as wanted.
///
/// Either the interval is a point and the root is that rational, or the root is the only one of
/// `polynomial` in the interval, lies strictly inside, and the signs at the two ends are opposite.
class Real_root
{
public:
  /// \throw Invalid_input unless the interval is a point or the signs at its ends are opposite.
  /// \pre The point is a root; `polynomial` is square-free. That no other root is in the interval is left to the
  /// caller:
  ///      to see it costs as much as to isolate.
  Real_root(std::shared_ptr<const Integer_polynomial> polynomial, Rational_interval interval, unsigned multiplicity);

  [[nodiscard]] const Rational& lower() const { return interval_.lower(); }
  [[nodiscard]] const Rational& upper() const { return interval_.upper(); }
  [[nodiscard]] const Rational_interval& interval() const { return interval_; }
  /// Whether the root is known as a rational number.
  [[nodiscard]] bool is_point() const { return lower() == upper(); }
  /// The multiplicity of the root in the polynomial that was given to `isolate_real_roots`.
  [[nodiscard]] unsigned multiplicity() const { return multiplicity_; }
  /// A primitive square-free polynomial with this root.
  [[nodiscard]] const Integer_polynomial& polynomial() const { return *polynomial_; }

  /// \brief Makes the interval at least four times shorter.
  /// \par Complexity  Quadratic convergence in the end: a few signs of the polynomial for each call, which then
  /// squares the number of parts it cuts. \par Reference  Abbott 2006, "Quadratic interval refinement".
  void refine();
  /// Refines until upper() - lower() <= width. \throw Invalid_input unless width > 0.
  void refine_to(const Rational& width);
  /// \brief Decides whether the root is rational, and makes the interval a point if it is.
  bool make_rational();
  /// The exact sign of q at the root. Refines the interval where that helps.
  [[nodiscard]] int sign_of(const Integer_polynomial& q);
  /// The sign of the root minus x, exactly.
  [[nodiscard]] int compare(const Rational& x);

  /// From now on `checkpoint` is called before what may take long; whatever it throws leaves the root valid.
  void set_checkpoint(Checkpoint checkpoint) { checkpoint_ = std::move(checkpoint); }
  /// Calls the checkpoint, if there is one.
  void check() const
  {
    if (checkpoint_) checkpoint_();
  }

private:
  [[nodiscard]] int sign_at(const Rational& x) const;
  void narrow(Rational low, Rational high);

  std::shared_ptr<const Integer_polynomial> polynomial_;
  Rational_interval interval_;
  unsigned multiplicity_;
  int lower_sign_ = 0;
  unsigned log_parts_ = 2;
  bool known_irrational_ = false;
  Checkpoint checkpoint_{};
};

/// \brief The distinct real roots of p in the closed interval, in increasing order, with disjoint isolating intervals
/// and the multiplicity of each. Ends that are roots count.
///
/// Yun's square-free decomposition, then bisection of the Bernstein form with Descartes' rule of signs.
/// \throw Invalid_input if p is zero.
/// \par Complexity  n^2/2 additions of integers for each bisection, in degree n.
/// \par Reference  Lane and Riesenfeld 1981; Mourrain, Rouillier and Roy 2005, "The Bernstein basis and real root
/// isolation".
[[nodiscard]] std::vector<Real_root> isolate_real_roots(const Integer_polynomial& p, const Rational_interval& interval,
                                                        const Checkpoint& checkpoint = {});

/// As above, for a polynomial that is known to be square-free; saves the decomposition.
/// \throw Invalid_input if p is zero. \pre p is square-free.
[[nodiscard]] std::vector<Real_root> isolate_simple_roots(const std::shared_ptr<const Integer_polynomial>& p,
                                                          const Rational_interval& interval,
                                                          const Checkpoint& checkpoint = {});

/// All distinct real roots of p. \throw Invalid_input if p is zero.
[[nodiscard]] std::vector<Real_root> isolate_real_roots(const Integer_polynomial& p, const Checkpoint& checkpoint = {});

/// How many distinct real roots p has in the closed interval. \throw Invalid_input if p is zero.
[[nodiscard]] std::size_t count_real_roots(const Integer_polynomial& p, const Rational_interval& interval);

/// A power of two above the absolute value of every root. \throw Invalid_input if p is zero. \par Reference  Fujiwara
/// 1916.
[[nodiscard]] Integer root_bound(const Integer_polynomial& p);

/// The number of changes of sign in a list, zeros ignored.
[[nodiscard]] std::size_t sign_variations(const std::vector<Integer>& values);

/// \brief The Bernstein coefficients of p over [0, 1], all times the same positive integer.
/// \throw Invalid_input if p is zero.
[[nodiscard]] std::vector<Integer> bernstein_coefficients(const Integer_polynomial& p);

/// The rational with the smallest denominator in a closed interval. \par Reference  Stern and Brocot.
[[nodiscard]] Rational simplest_rational(const Rational_interval& interval);

} // namespace corral

#endif
