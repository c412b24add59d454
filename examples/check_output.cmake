# SPDX-License-Identifier: GPL-3.0-or-later
# Runs PROGRAM without arguments and compares what it prints with the file EXPECTED, which the manual shows. With UPDATE
# the file is written anew.
execute_process(COMMAND "${PROGRAM}" OUTPUT_VARIABLE output RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} ended with ${status}")
endif()
if(UPDATE)
  file(WRITE "${EXPECTED}" "${output}")
  return()
endif()
if(NOT EXISTS "${EXPECTED}")
  message(FATAL_ERROR "${EXPECTED} is missing: the target example_outputs writes it")
endif()
file(READ "${EXPECTED}" expected)
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "${EXPECTED} is not what the example prints (the target example_outputs writes it anew).\n"
    "Expected:\n${expected}\nPrinted:\n${output}")
endif()
