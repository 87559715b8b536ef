# SPDX-License-Identifier: LGPL-3.0-or-later
# corral_add_root_oracles(<target> <oracle>...): each oracle is a source <name>_oracles.cpp that defines
# <name>_count_real_roots; a made source lists them as `root_oracles()`. A name may have a folder before it.
function(corral_add_root_oracles target)
  foreach(oracle IN LISTS ARGN)
    target_sources(${target} PRIVATE ${oracle}_oracles.cpp)
    get_filename_component(name ${oracle} NAME)
    string(APPEND declarations "Count_real_roots ${name}_count_real_roots;\n")
    string(APPEND entries "\n      {\"${name}\", ${name}_count_real_roots},")
  endforeach()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${target}_list.cpp)
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT [[
#include <corral/audit/root_oracles.h>

namespace corral {

@declarations@
std::vector<Root_oracle> root_oracles()
{
  return {@entries@
  };
}

} // namespace corral
]])
  target_sources(${target} PRIVATE ${source})
endfunction()
