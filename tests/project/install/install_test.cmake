# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
set(here ${CMAKE_CURRENT_LIST_DIR})
file(REMOVE_RECURSE ${WORK})
set(prefix "${WORK}/a prefix")

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(must_fail)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
  if(result EQUAL 0)
    message(FATAL_ERROR "worked, and should not have: ${ARGN}")
  endif()
endfunction()

set(tools -G ${GENERATOR} --no-warn-unused-cli -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
    -DCMAKE_BUILD_TYPE=Debug)

# consume(NAME [cmake arguments]): builds the consumer project and runs what it made.
function(consume name)
  run(${CMAKE_COMMAND} -S ${here}/consumer -B ${WORK}/${name} ${tools} ${ARGN})
  run(${CMAKE_COMMAND} --build ${WORK}/${name})
  foreach(program core host)
    if(EXISTS ${WORK}/${name}/${program})
      run(${WORK}/${name}/${program})
    endif()
  endforeach()
endfunction()

if(KIND STREQUAL "subdirectory")
  # With everything off the core builds where no package can be found.
  set(nothing_found -DSUBDIRECTORY=${SOURCE})
  foreach(package PkgConfig PNG ZLIB yaml-cpp Eigen3 Catch2 benchmark CLI11 nlohmann_json hwy)
    list(APPEND nothing_found -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
  endforeach()
  consume("core only" ${nothing_found})
  consume("core and host" -DSUBDIRECTORY=${SOURCE} -DSTRAIGHTEDGE_BUILD_HOST=ON)
  return()
endif()

if(KIND STREQUAL "static")
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
else()
  run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/shared ${tools} -DBUILD_SHARED_LIBS=ON
      -DSTRAIGHTEDGE_BUILD_PROGRAM=${PROGRAM} -DSTRAIGHTEDGE_BUILD_TESTS=OFF
      -DSTRAIGHTEDGE_BUILD_BENCH=OFF -DSTRAIGHTEDGE_BUILD_EXAMPLES=OFF)
  run(${CMAKE_COMMAND} --build ${WORK}/shared)
  run(${CMAKE_COMMAND} --install ${WORK}/shared --prefix ${prefix})
endif()
if(PROGRAM)
  run(${prefix}/bin/straightedge --version)
endif()

# find_package
set(found -DCMAKE_PREFIX_PATH=${prefix})
consume("core only" ${found} -DCOMPONENTS=core -DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON
        -DCMAKE_DISABLE_FIND_PACKAGE_yaml-cpp=ON -DCMAKE_DISABLE_FIND_PACKAGE_PNG=ON)
consume("core and host" ${found} -DCOMPONENTS=core,host -DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON)
consume("no components" ${found})
if(NOT EXISTS "${WORK}/no components/host")
  message(FATAL_ERROR "without components find_package did not give the host library")
endif()
must_fail(${CMAKE_COMMAND} -S ${here}/consumer -B ${WORK}/unknown ${tools} ${found} -DCOMPONENTS=gui)
must_fail(${CMAKE_COMMAND} -S ${here}/consumer -B ${WORK}/newer ${tools} ${found} -DVERSION=99.0)

# pkg-config, as a Makefile would ask it
set(ENV{PKG_CONFIG_PATH} "${prefix}/lib/pkgconfig:${prefix}/lib64/pkgconfig")
set(pkg_static "")
if(KIND STREQUAL "static")
  set(pkg_static --static)
else()
  set(ENV{LD_LIBRARY_PATH} "${prefix}/lib:${prefix}/lib64")
endif()
foreach(pair core:straightedge-core host:straightedge)
  string(REGEX REPLACE ":.*" "" program ${pair})
  string(REGEX REPLACE ".*:" "" package ${pair})
  execute_process(COMMAND ${PKG_CONFIG} ${pkg_static} --cflags --libs ${package}
    OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(${COMPILER} -std=c++20 ${here}/consumer/${program}.cpp ${flags} -o ${WORK}/pkg_${program})
  run(${WORK}/pkg_${program})
endforeach()
