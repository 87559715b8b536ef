# SPDX-License-Identifier: LGPL-3.0-or-later
target_sources(corral PRIVATE
  polynomial/parse.cpp
  polynomial/substitution.cpp)
