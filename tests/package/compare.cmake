# Runs EXPECTED and ACTUAL: both must print the same line.
cmake_minimum_required(VERSION 3.25)

foreach(program EXPECTED ACTUAL)
  execute_process(COMMAND ${${program}} OUTPUT_VARIABLE said_${program} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
if(NOT said_EXPECTED MATCHES "^placed .* refused [0-9/]+ [0-9a-f]+")
  message(SEND_ERROR "the client in the build tree said: ${said_EXPECTED}")
endif()
if(NOT said_ACTUAL STREQUAL said_EXPECTED)
  message(SEND_ERROR "expected ${said_EXPECTED}\nfound    ${said_ACTUAL}")
endif()
