# SPDX-License-Identifier: Apache-2.0
# installs the build into an empty prefix, as a package would:  cmake -D BUILD=<dir> -D STAGE=<prefix> -P stage.cmake
file(REMOVE_RECURSE ${STAGE})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${STAGE} OUTPUT_QUIET ERROR_VARIABLE problem
  RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the build cannot be installed; is all of it built?\n${problem}")
endif()

# what is installed was described by the build: it is still the same library
execute_process(COMMAND ${STAGE}/bin/swage validate ${STAGE}/lib/swage/plugins/swage.object.solids --strictness 1
  OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "an installed plugin does not validate:\n${said}")
endif()

# an author without our sources reads the guide there
foreach(page README objects couplings devices lessons errors)
  if(NOT EXISTS ${STAGE}/share/swage/guide/${page}.md)
    message(FATAL_ERROR "the guide's page ${page}.md is not installed")
  endif()
endforeach()

# what the thesis is measured by: its map, the studies, the audit; a study runs from there
set(studies appendix_d pierce_laws)
set(shards 1/81 1/24)  # one attempt of each
foreach(page lessons/thesis.md lessons/insertion/insertion.md devices/skilled/skilled.md resources/charts/audit.md resources/charts/wrist_wound.svg)
  if(NOT EXISTS ${STAGE}/share/swage/${page})
    message(FATAL_ERROR "the page ${page} is not installed")
  endif()
endforeach()
foreach(study shard IN ZIP_LISTS studies shards)
  execute_process(COMMAND ${STAGE}/bin/swage study ${STAGE}/share/swage/lessons/studies/${study}.json --shard ${shard} --out ${STAGE}/figures_${study}
    OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "the installed study ${study} does not run:\n${said}")
  endif()
endforeach()
