# SPDX-License-Identifier: LGPL-3.0-or-later
# Defines the target MPFI::mpfi, which brings MPFR along.
find_path(MPFI_INCLUDE_DIR mpfi.h)
find_library(MPFI_LIBRARY mpfi)
find_library(MPFR_LIBRARY mpfr)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MPFI DEFAULT_MSG MPFI_LIBRARY MPFR_LIBRARY MPFI_INCLUDE_DIR)
if(MPFI_FOUND AND NOT TARGET MPFI::mpfi)
  add_library(MPFI::mpfi UNKNOWN IMPORTED)
  set_target_properties(MPFI::mpfi PROPERTIES
    IMPORTED_LOCATION ${MPFI_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${MPFI_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES ${MPFR_LIBRARY})
endif()
mark_as_advanced(MPFI_INCLUDE_DIR MPFI_LIBRARY MPFR_LIBRARY)
