# SPDX-License-Identifier: LGPL-3.0-or-later
# 64-bit Arm, with the libraries that test/arm/run has laid out in CORRAL_ARM_LIBRARIES.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES CORRAL_ARM_LIBRARIES)
set(usr ${CORRAL_ARM_LIBRARIES}/usr)
# Headers of the build machine, such as CGAL's and Boost's, come last.
set(CMAKE_CXX_FLAGS_INIT
  "-isystem ${usr}/include/aarch64-linux-gnu -isystem ${usr}/include -idirafter /usr/include -L${usr}/lib/aarch64-linux-gnu -Wl,-rpath-link,${usr}/lib/aarch64-linux-gnu:${CORRAL_ARM_LIBRARIES}/lib/aarch64-linux-gnu")
