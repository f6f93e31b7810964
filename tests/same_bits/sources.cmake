# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT

# The cases, for programs on a PC, in WebAssembly and on boards; each adds a main function of its own.
list(APPEND same_bits_sources
  canny_cases.cpp
  canny_row_cases.cpp
  canny_stage_cases.cpp
  cases.cpp
  frame_plane_cases.cpp
  hough_line_cases.cpp
  hough_patch_cases.cpp
  hough_plane_cases.cpp
  inputs.cpp
  line_fit_cases.cpp
  number_cases.cpp
  octree_cases.cpp
  plane_fit_cases.cpp
  ransac_cases.cpp
  ransac_search_cases.cpp
  report.cpp)
list(TRANSFORM same_bits_sources PREPEND ${CMAKE_CURRENT_LIST_DIR}/)

# What a program prints of itself: same_bits_name(TARGET "-O2, Cortex-M3").
function(same_bits_name target name)
  target_compile_definitions(${target} PRIVATE
    "SAME_BITS_BUILD=\"${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}, ${name}\"")
endfunction()
