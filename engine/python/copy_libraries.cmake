# Puts the shared libraries that MODULE needs and no distribution is sure to have INTO a folder, under the names by
# which it asks for them.
file(GLOB former ${INTO}/lib*.so*)
if(former)
  file(REMOVE ${former})  # else they would be found in place of what they were copied from
endif()
file(GET_RUNTIME_DEPENDENCIES MODULES ${MODULE} RESOLVED_DEPENDENCIES_VAR found UNRESOLVED_DEPENDENCIES_VAR missing
     PRE_EXCLUDE_REGEXES "^lib(asan|clang_rt)"  # of sanitizers: loaded before all else
     POST_INCLUDE_REGEXES "/lib(tbb|ccd|hwy)[^/]*$" POST_EXCLUDE_REGEXES "/.*")
if(missing)
  message(FATAL_ERROR "${MODULE} needs ${missing}, which is not found")
endif()
foreach(library ${found})
  cmake_path(GET library FILENAME name)
  file(REAL_PATH ${library} real)
  file(COPY_FILE ${real} ${INTO}/${name})
endforeach()
