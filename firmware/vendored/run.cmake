# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT

# Configures, builds and runs the stranger's firmware: cmake -DSOURCE=... -DBUILD=... -DEMULATOR=... -P run.cmake
file(REMOVE_RECURSE ${BUILD})
execute_process(COMMAND ${CMAKE_COMMAND} -G Ninja -S ${SOURCE}/firmware/vendored -B ${BUILD}
  --toolchain ${SOURCE}/firmware/toolchain.cmake -DSTRAIGHTEDGE_FOLDER=${SOURCE}
  -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --parallel 2 COMMAND_ERROR_IS_FATAL ANY)
# Nothing but the core came with the folder.
foreach(more straightedge/tests straightedge/bench straightedge/firmware)
  if(EXISTS ${BUILD}/straightedge/${more} OR EXISTS ${BUILD}/${more})
    message(FATAL_ERROR "${more} came along with the core")
  endif()
endforeach()
execute_process(COMMAND ${EMULATOR} -M mps2-an500 -nographic -monitor none -serial none
  -chardev stdio,id=semi,signal=off -semihosting-config enable=on,target=native,chardev=semi
  -kernel ${BUILD}/stranger COMMAND_ERROR_IS_FATAL ANY)
