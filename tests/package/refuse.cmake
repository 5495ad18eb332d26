# Configures as if the CMake package MISSING were not installed: that must fail, and say SAYS.
cmake_minimum_required(VERSION 3.25)

set(build ${SCRATCH}/without_${MISSING})
file(REMOVE_RECURSE ${build})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCES} -B ${build} -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${CXX}
                        -D CMAKE_DISABLE_FIND_PACKAGE_${MISSING}=ON
                RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE said)
file(REMOVE_RECURSE ${build})
if(result EQUAL 0)
  message(FATAL_ERROR "configured without ${MISSING}")
endif()
string(REGEX REPLACE "[ \n]+" " " said "${said}")
if(NOT said MATCHES "graze needs ${MISSING}" OR NOT said MATCHES "apt-get install ${SAYS}")
  message(FATAL_ERROR "without ${MISSING}: ${said}")
endif()
