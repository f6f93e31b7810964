# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT

# What every target of the project is compiled with. Contraction is off because a fused
# multiply-add changes bits, and results must not depend on the machine.
function(straightedge_flags target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  if(PROJECT_IS_TOP_LEVEL)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion)
  endif()
  if(STRAIGHTEDGE_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
