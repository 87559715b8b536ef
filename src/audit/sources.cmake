target_sources(corral PRIVATE audit/audit_cases.cpp audit/case_polynomials.cpp)

# Planted faults, for the program's report and the tests; no part of the library.
add_library(corral_faults STATIC EXCLUDE_FROM_ALL
  audit/expansion_faults.cpp
  audit/fault_harness.cpp
  audit/method_faults.cpp
  audit/number_faults.cpp
  audit/seed_faults.cpp
  audit/taylor_form_faults.cpp)
add_library(Corral::faults ALIAS corral_faults)
target_include_directories(corral_faults PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(corral_faults PUBLIC corral PRIVATE corral_warnings)

# Oracles of other makers, for tests and audits only; nothing of the library needs them.
include(root_oracles)
set(root_oracles
  audit/cgal
  audit/flint)
add_library(corral_oracles STATIC EXCLUDE_FROM_ALL)
corral_add_root_oracles(corral_oracles ${root_oracles})
add_library(Corral::oracles ALIAS corral_oracles)
target_link_libraries(corral_oracles PUBLIC corral PRIVATE FLINT::flint MPFI::mpfi)
