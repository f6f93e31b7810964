# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT

# That compare.cmake names each kind of difference. WORK is a folder for its files.
file(MAKE_DIRECTORY ${WORK})
file(WRITE ${WORK}/table.txt "# a table\na.b 01\nc.d 02\n")

# printing(ROWS SENTENCE): a program with these rows must be refused with this sentence; "" means taken.
function(printing rows sentence)
  file(WRITE ${WORK}/output.txt "${rows}")
  execute_process(COMMAND ${CMAKE_COMMAND} -DTABLE=${WORK}/table.txt -P ${CMAKE_CURRENT_LIST_DIR}/compare.cmake --
      ${CMAKE_COMMAND} -E cat ${WORK}/output.txt
    RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(sentence STREQUAL "")
    set(wanted "a toy: 2 rows equal")
  else()
    set(wanted "${sentence}")
  endif()
  string(FIND "${said}" "${wanted}" place)
  if(place EQUAL -1 OR (result EQUAL 0 AND sentence) OR (NOT result EQUAL 0 AND NOT sentence))
    message(SEND_ERROR "not '${wanted}' for\n${rows}\nbut ${result}\n${said}")
  endif()
endfunction()

printing("build a toy\nkernels plain\na.b 01\nc.d 02\n" "")
printing("build a toy\nkernels plain\nc.d 02\na.b 01\nkernels fast\na.b 01\nc.d 02\n" "")
printing("build a toy\nkernels plain\na.b 01\nc.d 03\n" "differs  c.d (kernels plain): 03, not 02")
printing("build a toy\nkernels plain\na.b 01\nc.d NaN\n" "differs  c.d (kernels plain): NaN, not 02")
printing("build a toy\nkernels plain\na.b 01\n" "missing  c.d")
printing("build a toy\nkernels plain\na.b 01\nc.d 02\ne.f 04\n" "new      e.f")
printing("build a toy\nkernels plain\na.b 01\na.b 01\nc.d 02\n" "twice    a.b")
printing("build a toy\nkernels plain\na.b 01\nc.d 02\nkernels fast\na.b 02\nc.d 02\n" "differs  a.b (kernels fast)")
printing("build a toy\nkernels plain\na.b 01\nc.d 02\nkernels fast\n" "missing  a.b (kernels fast)")
printing("a.b 01\nc.d 02\n" "no build or no kernels")
