# SPDX-License-Identifier: Apache-2.0
#
# clang reads plugins of each kind, with every kind of parameter between them; g++ built them. What one compiler takes the other may refuse,
# as a consteval function that hands its arguments on. Syntax alone: some seconds a file. Skipped where there is no clang.
# usage: cmake -D SOURCE=... -P second_compiler.cmake
find_program(clang NAMES clang++ clang++-14)
if(NOT clang)
  message("SKIPPED: there is no clang here")
  return()
endif()
set(failed 0)
foreach(file IN ITEMS devices/skilled/skilled.cpp devices/mouse/mouse.cpp lessons/ring/ring_lesson.cpp plugins/thread/thread.cpp plugins/coupling_grasp/grasp.cpp)
  if(NOT EXISTS ${SOURCE}/${file})
    message(FATAL_ERROR "${file} is not here any more: name another plugin of its kind")
  endif()
  execute_process(COMMAND ${clang} -std=c++20 -fsyntax-only -Wall -Wextra -Werror -I${SOURCE}/framework/sdk/include -I${SOURCE}/framework -I${SOURCE}/devices
    -I${SOURCE}/plugins -I${SOURCE}/lessons -I${SOURCE} -isystem /usr/include/eigen3 ${SOURCE}/${file} RESULT_VARIABLE code ERROR_VARIABLE said)
  if(NOT code EQUAL 0)
    message("${file}:\n${said}")
    set(failed 1)
  endif()
endforeach()
if(failed)
  message(FATAL_ERROR "clang refuses what g++ takes")
endif()
