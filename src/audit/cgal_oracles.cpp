// SPDX-License-Identifier: LGPL-3.0-or-later
// The only file that includes CGAL's algebraic kernels: they take more than a minute to compile.
#define CGAL_USE_MPFI 1

#include <corral/audit/root_oracles.h>

#include <CGAL/Algebraic_kernel_d_1.h>
#include <CGAL/Algebraic_kernel_d_2.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace corral {

namespace {

using Kernel_1 = CGAL::Algebraic_kernel_d_1<CGAL::Gmpz>;
using Kernel_2 = CGAL::Algebraic_kernel_d_2<CGAL::Gmpz>;

Rational rational(const CGAL::Gmpq& q) { return Rational(q.mpq()); }
CGAL::Gmpq gmpq(const Rational& q) { return CGAL::Gmpq(q.get_mpq_t()); }

Rational_interval narrow(const Kernel_1::Algebraic_real_1& root, const Rational& width)
{
  for (;;) {
    const Rational low = rational(root.low());
    const Rational high = rational(root.high());
    if (high - low <= width) return {low, high};
    root.refine();
  }
}

Kernel_2::Polynomial_2 cgal_polynomial(const Polynomial<Integer, 2>& f)
{
  std::vector<std::pair<CGAL::Exponent_vector, CGAL::Gmpz>> terms;
  for (const auto& term : f.terms())
    terms.emplace_back(CGAL::Exponent_vector(int{term.exponents[0]}, int{term.exponents[1]}),
                       CGAL::Gmpz(term.coefficient.get_mpz_t()));
  return CGAL::Polynomial_traits_d<Kernel_2::Polynomial_2>::Construct_polynomial()(terms.begin(), terms.end());
}

} // namespace

std::vector<Oracle_root> cgal_real_roots(const Integer_polynomial& p, const Rational& width)
{
  std::vector<CGAL::Gmpz> coefficients;
  for (const Integer& c : p) coefficients.emplace_back(c.get_mpz_t());
  const Kernel_1::Polynomial_1 polynomial(coefficients.begin(), coefficients.end());
  std::vector<std::pair<Kernel_1::Algebraic_real_1, Kernel_1::Multiplicity_type>> roots;
  Kernel_1().solve_1_object()(polynomial, std::back_inserter(roots));
  std::vector<Oracle_root> result;
  for (const auto& [root, multiplicity] : roots)
    result.push_back({narrow(root, width), static_cast<unsigned>(multiplicity)});
  return result;
}

Count_real_roots cgal_count_real_roots;

std::size_t cgal_count_real_roots(const Integer_polynomial& p)
{
  return degree(p) == 0 ? 0 : cgal_real_roots(p, 1).size();
}

std::vector<Rational_box<2>> cgal_common_zeros(const Polynomial<Integer, 2>& f, const Polynomial<Integer, 2>& g,
                                               const Rational& width)
{
  std::vector<std::pair<Kernel_2::Algebraic_real_2, Kernel_2::Multiplicity_type>> zeros;
  const Kernel_2 kernel;
  kernel.solve_2_object()(cgal_polynomial(f), cgal_polynomial(g), std::back_inserter(zeros));
  std::vector<Rational_box<2>> result;
  for (const auto& [zero, multiplicity] : zeros)
    result.push_back(
        {narrow(kernel.compute_x_2_object()(zero), width), narrow(kernel.compute_y_2_object()(zero), width)});
  return result;
}

} // namespace corral
