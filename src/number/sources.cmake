target_sources(corral PRIVATE
  number/Double_bracket.cpp
  number/Environment.cpp
  number/Mpfr_interval.cpp
  number/Outward_rounding.cpp
  number/Prime_field.cpp
  number/Rational.cpp
  number/build_mode.cpp
  number/format.cpp)
