# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT

# Fails if PROGRAM has an instruction that multiplies and adds with one rounding.
execute_process(COMMAND ${OBJDUMP} -d --no-show-raw-insn ${PROGRAM}
  OUTPUT_VARIABLE code COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "vfn?m(add|sub)[a-z0-9]*" fused "${code}")
string(REGEX MATCHALL "vmulsd|vmulss" products "${code}")
list(LENGTH fused count)
list(LENGTH products expected)
if(count GREATER 0)
  list(REMOVE_DUPLICATES fused)
  message(FATAL_ERROR "${PROGRAM} has ${count} fused instructions: ${fused}")
elseif(expected EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} has no product at all; is it code for AVX?")
endif()
message("no fused instruction beside ${expected} products")
