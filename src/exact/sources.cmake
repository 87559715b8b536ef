target_sources(corral PRIVATE
  exact/Integer_polynomial.cpp
  exact/Bivariate.cpp
  exact/Extension.cpp
  exact/Plane_system.cpp
  exact/Prime_field.cpp
  exact/Zero_set.cpp
  exact/ideal_raster.cpp
  exact/real_roots.cpp)
