# SPDX-License-Identifier: Apache-2.0
# cmake -DA=<program> -DB=<program> -P rod_bits_test.cmake: both print the same
execute_process(COMMAND ${A} OUTPUT_VARIABLE a RESULT_VARIABLE failed_a)
execute_process(COMMAND ${B} OUTPUT_VARIABLE b RESULT_VARIABLE failed_b)
message(STATUS "${a}${b}")
if(failed_a OR failed_b OR NOT a STREQUAL b OR a STREQUAL "")
  message(FATAL_ERROR "The rod's bits depend on the level of optimisation or on the compiler:\n${a}${b}")
endif()
