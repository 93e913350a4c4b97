# SPDX-License-Identifier: Apache-2.0
#
# A stranger's day: new plugin from the installed template, configure, build, test, validate, run. Nothing of the source tree
# is used. The first thing that goes wrong ends it.
#
#   cmake -D KIND=object -D ID=org.example.clip -D STAGE=<prefix> -D WORK=<dir> -D GENERATOR=Ninja -D COMPILER=g++
#         -P trial.cmake

set(folder ${WORK}/${ID})
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${WORK})
string(REGEX REPLACE ".*\\." "" file ${ID})

function(do what)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT result EQUAL 0)
    string(JOIN " " command ${ARGN})
    message(FATAL_ERROR "${what} failed (${result}): ${command}\n${out}")
  endif()
  message(STATUS "${what}\n${out}")
endfunction()

do("new" ${STAGE}/bin/swage new ${KIND} ${ID} --dir ${folder})
do("configure" ${CMAKE_COMMAND} -S ${folder} -B ${folder}/build -G ${GENERATOR} -D CMAKE_PREFIX_PATH=${STAGE}
  -D CMAKE_CXX_COMPILER=${COMPILER}
  "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror")
file(STRINGS ${folder}/build/CMakeCache.txt how REGEX "^CMAKE_BUILD_TYPE:STRING=Release$")
if(NOT how)
  message(FATAL_ERROR "a plugin is not built optimised unless told otherwise")
endif()
do("build" ${CMAKE_COMMAND} --build ${folder}/build)
do("test and validate" ${CMAKE_CTEST_COMMAND} --test-dir ${folder}/build --output-on-failure --no-tests=error)
foreach(made IN ITEMS ${ID}.so plugin.json)
  if(NOT EXISTS ${folder}/build/plugins/${ID}/${made})
    message(FATAL_ERROR "the bundle has no ${made}")
  endif()
endforeach()
do("validate the lesson file" ${STAGE}/bin/swage validate ${folder}/try_${file}.json
  --plugin-dir ${folder}/build/plugins)
# a driver whose hardware is not there says so, and what to do
if(KIND STREQUAL "hardware")
  execute_process(COMMAND ${STAGE}/bin/swage run ${folder}/try_${file}.json --plugin-dir ${folder}/build/plugins --headless --store :none:
    RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(result EQUAL 0 OR NOT out MATCHES "The port .* cannot be opened: .*Set \"port\" to the tracker's.")
    message(FATAL_ERROR "run without the hardware (${result}): ${out}")
  endif()
  return()
endif()
do("run" ${STAGE}/bin/swage run ${folder}/try_${file}.json --plugin-dir ${folder}/build/plugins --headless
  --as-fast-as-possible --store :none:)
