# SPDX-License-Identifier: LGPL-3.0-or-later
target_sources(corral PRIVATE
  decision/Common_zeros.cpp
  decision/Term_search.cpp
  decision/Zero_set.cpp
  decision/ideal_raster.cpp
  decision/ideal_system.cpp
  decision/zero_on_segment.cpp)
