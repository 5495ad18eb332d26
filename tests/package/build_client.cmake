# Builds the client in BUILD: with the install in PREFIX, or with the sources if ADD_SOURCES.
cmake_minimum_required(VERSION 3.25)

# What a user of the libraries must not need.
set(without)
foreach(package CLI11 nlohmann_json fmt fcl GTest)
  list(APPEND without -D CMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()

if(ADD_SOURCES)
  set(graze -D GRAZE_SOURCES=${SOURCES} -D BUILD_SHARED_LIBS=ON -D GRAZE_INSTALL=ON)
else()
  set(graze -D CMAKE_PREFIX_PATH=${PREFIX} -D PAGE=${SOURCES}/README.md -D CMAKE_DISABLE_FIND_PACKAGE_FastFloat=ON)
endif()

file(REMOVE_RECURSE ${BUILD})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${CLIENT} -B ${BUILD} -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${CXX}
                        -D CMAKE_BUILD_TYPE=Release -D CLIENT_VARIANTS=${VARIANTS} ${graze} ${without}
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${BUILD}/client_narrowphase COMMAND_ERROR_IS_FATAL ANY)
