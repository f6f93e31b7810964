# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT

# build.cmake -- [cmake arguments]: configures and builds the programs of builds/ in the folder BUILD.
include(${CMAKE_CURRENT_LIST_DIR}/words_after_dashes.cmake)
words_after_dashes(arguments)
execute_process(COMMAND ${CMAKE_COMMAND} --no-warn-unused-cli -S ${CMAKE_CURRENT_LIST_DIR}/builds -B ${BUILD} ${arguments}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --parallel 2 COMMAND_ERROR_IS_FATAL ANY)
