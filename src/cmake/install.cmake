# SPDX-License-Identifier: LGPL-3.0-or-later
# What is installed, and what find_package(Corral) finds.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Corral)

install(DIRECTORY include/corral include/corral_check DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  PATTERN root_oracles.h EXCLUDE) # of the tests, whose library is not installed
# One export each, so that whoever only wants cells needs no Cairo.
set_target_properties(corral_output PROPERTIES EXPORT_NAME output)
set_target_properties(corral_checker PROPERTIES EXPORT_NAME checker)
foreach(target corral corral_output corral_checker)
  install(TARGETS ${target} EXPORT ${target} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT ${target} NAMESPACE Corral:: DESTINATION ${package_folder})
endforeach()
if(CORRAL_BUILD_PROGRAMS)
  install(TARGETS corral_program corral-check RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

configure_package_config_file(src/cmake/CorralConfig.cmake.in ${PROJECT_BINARY_DIR}/CorralConfig.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/CorralConfigVersion.cmake COMPATIBILITY SameMinorVersion)
file(GLOB find_modules CONFIGURE_DEPENDS src/cmake/Find*.cmake)
install(FILES
  ${PROJECT_BINARY_DIR}/CorralConfig.cmake ${PROJECT_BINARY_DIR}/CorralConfigVersion.cmake ${find_modules}
  DESTINATION ${package_folder})
