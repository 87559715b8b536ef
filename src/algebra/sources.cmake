# SPDX-License-Identifier: LGPL-3.0-or-later
target_sources(corral PRIVATE
  algebra/Bernstein_form.cpp
  algebra/Bivariate.cpp
  algebra/Extension.cpp
  algebra/Extreme_points.cpp
  algebra/Fibre.cpp
  algebra/Integer_polynomial.cpp
  algebra/Plane_system.cpp
  algebra/Projected_zeros.cpp
  algebra/Real_root.cpp
  algebra/cofactors.cpp
  algebra/definite.cpp
  algebra/exact_range.cpp
  algebra/integer_polynomial_gcd.cpp
  algebra/integer_polynomial_values.cpp
  algebra/multivariate.cpp
  algebra/real_roots.cpp
  algebra/restriction.cpp
  algebra/simplest_rational.cpp)
