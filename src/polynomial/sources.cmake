# SPDX-License-Identifier: LGPL-3.0-or-later
target_sources(corral PRIVATE
  polynomial/Polynomial_lexer.cpp
  polynomial/characters.cpp
  polynomial/names.cpp
  polynomial/parse.cpp
  polynomial/square_free.cpp
  polynomial/substitution.cpp
  polynomial/verification.cpp)

# FLINT computes the greatest common divisors of polynomials in several variables.
find_package(FLINT REQUIRED)
target_link_libraries(corral PRIVATE FLINT::flint)
