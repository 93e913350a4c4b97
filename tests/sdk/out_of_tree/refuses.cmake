# SPDX-License-Identifier: Apache-2.0
#
# swage_add_plugin() refuses what cannot become a plugin, with a sentence:  cmake -D MODULE=SwageAddPlugin.cmake -P refuses.cmake

# in a child: one call
if(DEFINED CALL)
  include(${MODULE})
  swage_add_plugin(${CALL})
  return()
endif()

function(expect_refusal call sentence)
  execute_process(COMMAND ${CMAKE_COMMAND} "-DCALL=${call}" -D MODULE=${MODULE} -P ${CMAKE_CURRENT_LIST_FILE}
    RESULT_VARIABLE result ERROR_VARIABLE words OUTPUT_QUIET)
  string(REGEX REPLACE "[ \n]+" " " words "${words}")
  if(result EQUAL 0)
    message(SEND_ERROR "swage_add_plugin(${call}) was taken")
  endif()
  string(FIND "${words}" "${sentence}" at)
  if(at EQUAL -1)
    message(SEND_ERROR "swage_add_plugin(${call}) says: ${words}\ninstead of: ${sentence}")
  endif()
endfunction()

expect_refusal("clip;SOURCES;clip.cpp" "ID \"\" is not a reverse domain such as org.example.clip")
expect_refusal("clip;ID;clip;SOURCES;clip.cpp" "ID \"clip\" is not a reverse domain such as org.example.clip")
expect_refusal("clip;ID;org.Example.clip;SOURCES;clip.cpp" "ID \"org.Example.clip\" is not a reverse domain")
expect_refusal("clip;ID;org.example.clip" "swage_add_plugin(clip): no SOURCES")
expect_refusal("clip;NOINSTALL;ID;org.example.clip;SOURCES;clip.cpp" "\"NOINSTALL\" is not understood")

# what is right comes as far as making the library, which a script may not do
expect_refusal("clip;ID;org.example.clip;SOURCES;clip.cpp;NO_INSTALL" "add_library command is not scriptable")
