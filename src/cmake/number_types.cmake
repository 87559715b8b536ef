# SPDX-License-Identifier: LGPL-3.0-or-later
# corral_add_sources_for_number_types(<target> <list header> <header> <macro> [EXCEPT <regex>]): one source for each type
# of `Number_types`, so that compilation runs in parallel and stays small. Each includes <header> and calls the macro,
# which instantiates what the header declares, with the type.
function(corral_add_sources_for_number_types target list header macro)
  cmake_parse_arguments(PARSE_ARGV 4 option "" EXCEPT "")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
  file(READ ${list} text)
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  if(NOT text MATCHES "using Number_types = Number_type_list<([^;]*)>;")
    message(FATAL_ERROR "${list}: no list 'using Number_types = Number_type_list<...>;'")
  endif()
  string(REGEX REPLACE "[ \n]" "" types "${CMAKE_MATCH_1}")
  string(REPLACE "," ";" types "${types}")
  get_filename_component(stem ${header} NAME_WE)
  foreach(type IN LISTS types)
    if(option_EXCEPT AND type MATCHES "${option_EXCEPT}")
      continue()
    endif()
    string(MAKE_C_IDENTIFIER "${stem}_${type}" name)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
    file(CONFIGURE OUTPUT ${source} @ONLY CONTENT [[
#include "@header@"
#include <corral/number/all.h>

namespace corral::program {

@macro@(@type@)

} // namespace corral::program
]])
    target_sources(${target} PRIVATE ${source})
  endforeach()
endfunction()
