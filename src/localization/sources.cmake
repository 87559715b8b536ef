# SPDX-License-Identifier: LGPL-3.0-or-later
find_package(hwy REQUIRED)
find_package(TBB REQUIRED)
target_sources(corral PRIVATE
  localization/fast/Exact_limits.cpp
  localization/fast/Fast_plan.cpp
  localization/fast/Member.cpp
  localization/fast/Monomial_shape.cpp
  localization/fast/Pulse.cpp
  localization/fast/Root_seed.cpp
  localization/fast/Rough_nodes.cpp
  localization/fast/Runner.cpp
  localization/fast/Search.cpp
  localization/fast/System_run.cpp
  localization/fast/Term_bounds.cpp
  localization/fast/Term_form.cpp
  localization/fast/Term_nodes.cpp
  localization/fast/fast_engine.cpp
  localization/fast/localize_fast.cpp)
target_include_directories(corral PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(corral PRIVATE hwy::hwy TBB::tbb)
