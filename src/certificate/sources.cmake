# SPDX-License-Identifier: LGPL-3.0-or-later
find_package(ZLIB REQUIRED)
find_package(nlohmann_json REQUIRED)
target_sources(corral PRIVATE
  certificate/Critical_prover.cpp certificate/begun_certificate.cpp certificate/certify.cpp certificate/guesses.cpp certificate/text.cpp
  certificate/validate.cpp)
target_link_libraries(corral PRIVATE ZLIB::ZLIB $<BUILD_INTERFACE:nlohmann_json::nlohmann_json>)
