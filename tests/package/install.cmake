# Installs BUILD into a fresh prefix, moves the prefix to PREFIX, and looks at what is in it.
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${PREFIX} ${PREFIX}_first)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX}_first
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${PREFIX}_first ${PREFIX})

# Whether the file says `place` as a whole path or the beginning of one: not as the end of a longer
# path, for a checkout may be /graze and `include/graze` is everywhere.
function(says file place found)
  file(READ ${file} text)
  string(REPLACE ";" " " text "${text}")
  set(${found} NO PARENT_SCOPE)
  foreach(before IN ITEMS "\"" " " "=" ":" "(" "\n")
    foreach(after IN ITEMS "/" "\"" " " ")" "\n")
      string(FIND "${text}" "${before}${place}${after}" at)
      if(NOT at EQUAL -1)
        set(${found} YES PARENT_SCOPE)
      endif()
    endforeach()
  endforeach()
endfunction()

foreach(needed include/graze/graze.h include/graze/bvh/aabb.h include/graze/engine/mesh/mesh.h)
  if(NOT EXISTS ${PREFIX}/${needed})
    message(SEND_ERROR "not installed: ${needed}")
  endif()
endforeach()

file(GLOB_RECURSE installed RELATIVE ${PREFIX} ${PREFIX}/*)
foreach(file IN LISTS installed)
  if(file MATCHES "mesh_data\\.h|query_results\\.h|expansion\\.h|sah_sweep\\.h|engine/(cli|compare|files|package)/|mesh/io/|\\.cpp$|README")
    message(SEND_ERROR "private, but installed: ${file}")
  endif()
  if(file MATCHES "\\.cmake$")
    foreach(place ${PREFIX}_first ${SOURCES} ${BUILD})
      says(${PREFIX}/${file} ${place} is_named)
      if(is_named)
        message(SEND_ERROR "${file} names a place on this machine: ${place}")
      endif()
    endforeach()
  endif()
endforeach()

# The command, where it was built, runs from where it is now.
if(EXISTS ${PREFIX}/bin/graze)
  execute_process(COMMAND ${PREFIX}/bin/graze --help OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endif()
