# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT

# The words of a script's command line that stand after "--": words_after_dashes(LIST).
function(words_after_dashes list)
  set(words)
  set(after OFF)
  math(EXPR last "${CMAKE_ARGC} - 1")
  foreach(i RANGE ${last})
    if(after)
      list(APPEND words "${CMAKE_ARGV${i}}")
    elseif(CMAKE_ARGV${i} STREQUAL "--")
      set(after ON)
    endif()
  endforeach()
  set(${list} "${words}" PARENT_SCOPE)
endfunction()
