# The tests of the package on a module that is built with AddressSanitizer. The interpreter is not, so that the runtime
# is loaded before it, and with it the library that throws exceptions. What the interpreter keeps to its end is no leak
# of the module. Left out is what runs other programs, under a runtime that they did not ask for.
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  set(runtime libclang_rt.asan-${CMAKE_SYSTEM_PROCESSOR}.so)
else()
  set(runtime libasan.so)
endif()
foreach(library ${runtime} libstdc++.so.6)
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=${library} OUTPUT_VARIABLE path
                  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  if(NOT EXISTS ${path})
    message(FATAL_ERROR "the tests of the Python package under AddressSanitizer need ${library}, which ${CMAKE_CXX_COMPILER} has not")
  endif()
  list(APPEND preloaded ${path})
endforeach()
list(JOIN preloaded ":" preloaded)
add_test(NAME Python.Sanitized
         COMMAND ${GRAZE_PYTHON_INTERPRETER} -m pytest -q -p no:cacheprovider -m "not slow and not outside"
                 ${CMAKE_CURRENT_SOURCE_DIR})
set_tests_properties(Python.Sanitized PROPERTIES
  ENVIRONMENT "PYTHONPATH=${package};PYTHONDONTWRITEBYTECODE=1;GRAZE_SOURCES=${PROJECT_SOURCE_DIR};LD_PRELOAD=${preloaded};ASAN_OPTIONS=detect_leaks=0:strict_string_checks=1;UBSAN_OPTIONS=print_stacktrace=1"
  TIMEOUT 900 PROCESSORS 2)
add_dependencies(graze_tests graze_python)
