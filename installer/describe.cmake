# SPDX-FileCopyrightText: 2026 The Hexapose authors
# SPDX-License-Identifier: MIT
# What a built program tells of its options becomes its man page, between the sections that are written by hand, and its
# completions. Needs PROGRAM, PROSE, VERSION, DATE, OUT (a path without extension).
function(describe form variable)
  execute_process(COMMAND ${PROGRAM} --describe ${form} OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  set(${variable} "${said}" PARENT_SCOPE)
endfunction()

describe(man OPTIONS)
string(STRIP "${OPTIONS}" OPTIONS)
configure_file(${PROSE} ${OUT}.1 @ONLY)
execute_process(COMMAND gzip -9nc ${OUT}.1 OUTPUT_FILE ${OUT}.1.gz COMMAND_ERROR_IS_FATAL ANY)
foreach(shell bash zsh fish)
  describe(${shell} text)
  file(WRITE ${OUT}.${shell} "${text}")
endforeach()
