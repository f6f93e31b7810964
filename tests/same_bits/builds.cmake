# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT

# Builds of other compilers, flags and processors, each in a folder of its own.

# same_bits_builds(NAME gcc LABEL same_bits PROCESSOR x86-64 VARIANTS O0 ... [NEEDS tool file ...]
#                  [RUN emulator ...] ARGUMENTS cmake arguments):
# a test same_bits_NAME_VARIANT for each, after one that builds them. Without what it NEEDS it is skipped.
function(same_bits_builds)
  cmake_parse_arguments(BUILDS "" "NAME;LABEL;PROCESSOR" "VARIANTS;NEEDS;RUN;ARGUMENTS" ${ARGN})
  set(name same_bits_${BUILDS_NAME})
  foreach(need IN LISTS BUILDS_NEEDS)
    find_program(tool_${need} NAMES ${need} PATHS / NO_CACHE)
    if(NOT tool_${need} AND NOT EXISTS ${need})
      add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} -E echo
        "Skipped: there is no ${need} here; scripts/install_packages.sh cross installs it.")
      set_tests_properties(${name} PROPERTIES LABELS ${BUILDS_LABEL} SKIP_REGULAR_EXPRESSION "Skipped:")
      return()
    endif()
  endforeach()

  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${BUILDS_NAME})
  list(JOIN BUILDS_VARIANTS + variants)
  add_test(NAME ${name}_build COMMAND ${CMAKE_COMMAND} -DBUILD=${folder}
    -P ${CMAKE_CURRENT_SOURCE_DIR}/build.cmake -- -G Ninja
    -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER} -DPROCESSOR=${BUILDS_PROCESSOR}
    -DVARIANTS=${variants} ${BUILDS_ARGUMENTS})
  set_tests_properties(${name}_build PROPERTIES
    LABELS ${BUILDS_LABEL} TIMEOUT 3600 PROCESSORS 2 FIXTURES_SETUP ${name})
  foreach(variant IN LISTS BUILDS_VARIANTS)
    add_test(NAME ${name}_${variant} COMMAND ${compare} ${BUILDS_RUN} ${folder}/same_bits_${variant})
    set_tests_properties(${name}_${variant} PROPERTIES
      LABELS ${BUILDS_LABEL} TIMEOUT 300 FIXTURES_REQUIRED ${name})
  endforeach()
endfunction()

# A test that a build's program has no instruction that rounds once where the core rounds twice.
function(not_fused compiler variant)
  if(TEST same_bits_${compiler}_build)
    set(name same_bits_${compiler}_${variant}_not_fused)
    add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} -DOBJDUMP=${CMAKE_OBJDUMP}
      -DPROGRAM=${CMAKE_CURRENT_BINARY_DIR}/${compiler}/same_bits_${variant}
      -P ${CMAKE_CURRENT_SOURCE_DIR}/not_fused.cmake)
    set_tests_properties(${name} PROPERTIES
      LABELS same_bits TIMEOUT 120 FIXTURES_REQUIRED same_bits_${compiler})
  endif()
endfunction()

# PC, both compilers.
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  set(fast)
  set(fused)
  if(EXISTS /proc/cpuinfo)
    file(STRINGS /proc/cpuinfo fast REGEX "^flags.* fma .* avx2 " LIMIT_COUNT 1)
  endif()
  if(fast)
    set(fast haswell)
    set(fused contracted)
  endif()
  same_bits_builds(NAME gcc LABEL same_bits PROCESSOR x86-64 VARIANTS O0 O2 O3 ${fast} ${fused}
    ARGUMENTS -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER})
  same_bits_builds(NAME clang LABEL same_bits PROCESSOR x86-64 VARIANTS O0 O2 O3 ${fast}
    NEEDS clang++ ARGUMENTS -DCMAKE_CXX_COMPILER=clang++)
  if(fast)
    # That a difference is seen and named.
    set_tests_properties(same_bits_gcc_contracted PROPERTIES PASS_REGULAR_EXPRESSION
      "differs  fit.symmetric_eigen .*differs  frame_planes.planes.ransac ")
    not_fused(gcc haswell)
    not_fused(clang haswell)
    not_fused(gcc contracted)
    set_tests_properties(same_bits_gcc_contracted_not_fused PROPERTIES WILL_FAIL ON)
  endif()
endif()

# Other processors. A 32-bit PC must compute in SSE's registers: the older ones round as they like.
same_bits_builds(NAME i686 LABEL cross PROCESSOR i686 VARIANTS O2 O3 NEEDS i686-linux-gnu-g++
  ARGUMENTS -DCMAKE_CXX_COMPILER=i686-linux-gnu-g++ "-DCMAKE_CXX_FLAGS=-msse2 -mfpmath=sse"
    -DCMAKE_EXE_LINKER_FLAGS=-static)
same_bits_builds(NAME aarch64 LABEL cross PROCESSOR aarch64 VARIANTS O2 O3
  NEEDS aarch64-linux-gnu-g++ qemu-aarch64 RUN qemu-aarch64
  ARGUMENTS -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ -DCMAKE_EXE_LINKER_FLAGS=-static)

# WebAssembly, by the newest Clang whose library for it is there.
set(wasm_clang clang++-19)
foreach(version 18 19 20)
  if(EXISTS /usr/lib/llvm-${version}/bin/wasm-ld AND EXISTS /usr/bin/clang++-${version})
    set(wasm_clang clang++-${version})
  endif()
endforeach()
same_bits_builds(NAME wasm LABEL cross PROCESSOR wasm32 VARIANTS O2 O3 simd128
  NEEDS ${wasm_clang} node /usr/include/wasm32-wasi/c++/v1/cstdint /usr/lib/wasm32-wasi/libc.a
  RUN node --no-warnings ${CMAKE_CURRENT_SOURCE_DIR}/run_wasm.mjs
  ARGUMENTS -DCMAKE_SYSTEM_NAME=Generic -DCMAKE_SYSTEM_PROCESSOR=wasm32 -DCMAKE_CXX_COMPILER=${wasm_clang}
    -DCMAKE_CXX_COMPILER_TARGET=wasm32-wasi "-DCMAKE_CXX_FLAGS=-stdlib=libc++ -fno-exceptions")
