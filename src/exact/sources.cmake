target_sources(corral PRIVATE
  exact/Integer_polynomial.cpp
  exact/integer_polynomial_gcd.cpp
  exact/integer_polynomial_values.cpp
  exact/Bernstein_form.cpp
  exact/Bivariate.cpp
  exact/Common_zeros.cpp
  exact/Extension.cpp
  exact/Extreme_points.cpp
  exact/Fibre.cpp
  exact/Plane_system.cpp
  exact/multivariate.cpp
  exact/Prime_field.cpp
  exact/Zero_set.cpp
  exact/exact_range.cpp
  exact/ideal_raster.cpp
  exact/ideal_system.cpp
  exact/restriction.cpp
  exact/Real_root.cpp
  exact/real_roots.cpp
  exact/simplest_rational.cpp
  exact/zero_on_segment.cpp)

# Oracles of other makers, for tests and audits only; nothing of the library needs them.
add_library(corral_oracles STATIC EXCLUDE_FROM_ALL exact/cgal_oracles.cpp exact/flint_oracles.cpp)
add_library(Corral::oracles ALIAS corral_oracles)
target_link_libraries(corral_oracles PUBLIC corral PRIVATE FLINT::flint MPFI::mpfi)
