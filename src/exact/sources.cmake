target_sources(corral PRIVATE
  exact/Integer_polynomial.cpp
  exact/Prime_field.cpp
  exact/real_roots.cpp)
