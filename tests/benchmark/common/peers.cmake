# Libraries that others made and that take part where they are found, each compiled as its own flags
# say, apart from the others.

find_package(fcl QUIET)
find_package(ccd QUIET)
find_package(CGAL QUIET)
find_package(octomap QUIET)
find_package(embree 3 QUIET)

# Debian's own package of both precisions; the -float64 libraries are those compiled for double.
find_path(GRAZE_BULLET_INCLUDE_DIR btBulletCollisionCommon.h PATH_SUFFIXES bullet)
find_library(GRAZE_BULLET_COLLISION BulletCollision-float64)
find_library(GRAZE_BULLET_MATH LinearMath-float64)
set(GRAZE_BULLET_FOUND OFF)
if(GRAZE_BULLET_INCLUDE_DIR AND GRAZE_BULLET_COLLISION AND GRAZE_BULLET_MATH)
  set(GRAZE_BULLET_FOUND ON)
  add_library(graze_bullet INTERFACE)
  target_include_directories(graze_bullet SYSTEM INTERFACE ${GRAZE_BULLET_INCLUDE_DIR})
  target_compile_definitions(graze_bullet INTERFACE BT_USE_DOUBLE_PRECISION)
  target_link_libraries(graze_bullet INTERFACE ${GRAZE_BULLET_COLLISION} ${GRAZE_BULLET_MATH})
endif()

find_path(GRAZE_ODE_INCLUDE_DIR ode/ode.h)
find_library(GRAZE_ODE ode)
set(GRAZE_ODE_FOUND OFF)
if(GRAZE_ODE_INCLUDE_DIR AND GRAZE_ODE)
  set(GRAZE_ODE_FOUND ON)
  add_library(graze_ode INTERFACE)
  target_include_directories(graze_ode SYSTEM INTERFACE ${GRAZE_ODE_INCLUDE_DIR})
  target_link_libraries(graze_ode INTERFACE ${GRAZE_ODE})
endif()
mark_as_advanced(GRAZE_BULLET_INCLUDE_DIR GRAZE_BULLET_COLLISION GRAZE_BULLET_MATH GRAZE_ODE_INCLUDE_DIR GRAZE_ODE)

# graze_peer(FILE NAME IS_FOUND LIBRARY...), in the folder of a benchmark: peers/FILE.cpp, which has the
# function add_FILE(). What is found and what is not goes into ../common/peers.cpp.in.
function(graze_peer file name is_found)
  if(is_found)
    get_filename_component(benchmark ${CMAKE_CURRENT_SOURCE_DIR} NAME)
    set(library graze_benchmark_${benchmark}_${file})
    file(GLOB pages CONFIGURE_DEPENDS peers/${file}.cpp peers/${file}_*.cpp)
    add_library(${library} OBJECT ${pages})
    target_link_libraries(${library} PUBLIC ${ARGN} PRIVATE graze::oracle graze_options)
    if(file STREQUAL cgal)  # g++ 12 misreads what it inlines of CGAL's headers
      target_compile_options(${library} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    endif()
    set(graze_peer_libraries ${graze_peer_libraries} ${library} PARENT_SCOPE)
    set(graze_present_peers "${graze_present_peers}{\"${name}\", add_${file}}, " PARENT_SCOPE)
  else()
    set(graze_absent_peers "${graze_absent_peers}\"${name}\", " PARENT_SCOPE)
  endif()
endfunction()
