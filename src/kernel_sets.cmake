# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT

# Kernels are made once for each instruction set. What is made so needs the flags of its set and nothing else
# may have them: the library runs on every 64-bit x86 processor and takes a table only when asked to.
set(straightedge_kernel_sets sse2 avx2 avx512)
set(straightedge_flags_of_sse2)
set(straightedge_flags_of_avx2 -mavx2 -mpopcnt)
# GCC 12 warns of numbers that its own header leaves open on purpose.
set(straightedge_flags_of_avx512 -mavx512f -mavx512bw -mavx512dq -mavx512vl -mpopcnt
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized> $<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized>)

# The library that the kernels of a folder go into.
set(straightedge_kernel_library straightedge_core)

# The longest vectors, in bits, that a folder's plain loops become. A processor that has used 512 bits may run
# slower for a while: where short loops lie between other code, that costs more than they save.
set(straightedge_longest_vectors 512)

# straightedge_kernels_for(MODULE SET SOURCES...): the sources as one more part of the library, with
# STRAIGHTEDGE_KERNEL_SET defined as the set.
function(straightedge_kernels_for module set)
  set(target straightedge_${module}_${set})
  add_library(${target} OBJECT ${ARGN})
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
  target_compile_definitions(${target} PRIVATE STRAIGHTEDGE_KERNEL_SET=${set})
  straightedge_flags(${target})
  target_compile_options(${target} PRIVATE -fno-exceptions -fno-rtti -fno-math-errno
    ${straightedge_flags_of_${set}} $<$<NOT:$<CONFIG:Debug>>:-O3>)
  target_sources(${straightedge_kernel_library} PRIVATE $<TARGET_OBJECTS:${target}>)
endfunction()

# straightedge_kernels(MODULE SOURCES...): plain loops that compilers turn into vector code by themselves. The
# same text for every set, in the namespace of the set (base/kernel_set.hpp), and once without: the plain one,
# which is the one for SSE2 too.
function(straightedge_kernels module)
  target_sources(${straightedge_kernel_library} PRIVATE ${ARGN})
  # GCC 12 turns loops into vector code at -O3 alone.
  set_source_files_properties(${ARGN} TARGET_DIRECTORY ${straightedge_kernel_library} PROPERTIES
    COMPILE_OPTIONS $<$<AND:$<CXX_COMPILER_ID:GNU>,$<NOT:$<CONFIG:Debug>>>:-O3>)
  if(STRAIGHTEDGE_X86_64)
    foreach(set avx2 avx512)
      straightedge_kernels_for(${module} ${set} ${ARGN})
      target_compile_options(straightedge_${module}_${set} PRIVATE
        -mprefer-vector-width=${straightedge_longest_vectors})
    endforeach()
  endif()
endfunction()
