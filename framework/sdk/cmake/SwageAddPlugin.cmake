# SPDX-License-Identifier: Apache-2.0
#
# Functions that build a plugin, Swage's own and others alike.
#
#   swage_add_plugin(<target> ID <id> SOURCES <file>... [RESOURCES <file>...] [LINKS <library>...]
#                    [FOLDER <dir>] [NO_INSTALL] [NO_SIDECAR])
#
#     builds the bundle  <FOLDER>/<id>/  (FOLDER: <build>/plugins unless given) with
#       <id>.so      a module that exports swage_plugin_entry and nothing else
#       plugin.json  description of the module, written by swage-describe after linking
#       RESOURCES    copied beside them; the plugin finds them through swage::bundle_dir()
#       words*.json  translations beside the sources, copied as well (guide/languages.md)
#     and installs it below lib/swage/plugins. LINKS are the plugin's own libraries; the SDK and the toolkit are always linked.
#
#   swage_add_plugin_tests(<target> [STRICTNESS <1..10>])
#
#     adds the test <id>.validate, which runs `swage validate` on the bundle. Level 5 unless given.

include_guard(GLOBAL)

# Flags of the module: one exported symbol, all symbols bound at load time, the same arithmetic on all compilers.
function(_swage_plugin_flags target)
  set_target_properties(${target} PROPERTIES
    PREFIX "" SUFFIX ".so" POSITION_INDEPENDENT_CODE ON CXX_EXTENSIONS OFF
    C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    BUILD_RPATH "$ORIGIN" INSTALL_RPATH "$ORIGIN")
  target_compile_features(${target} PRIVATE cxx_std_20)
  target_compile_options(${target} PRIVATE -ffp-contract=off $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
  set(map ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/swage_plugin.map)
  target_link_options(${target} PRIVATE -Wl,-z,now -Wl,--version-script=${map})
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${map})

  # with clang, the program and not the module links the runtime of the sanitizers
  if(NOT (SWAGE_SANITIZE AND CMAKE_CXX_COMPILER_ID MATCHES Clang))
    target_link_options(${target} PRIVATE -Wl,-z,defs)
  endif()
endfunction()

# Finds swage-describe: the target of this build, otherwise the installed program.
function(_swage_describe_program out)
  if(TARGET swage-describe)
    set(${out} $<TARGET_FILE:swage-describe> PARENT_SCOPE)
    return()
  endif()
  find_program(SWAGE_DESCRIBE swage-describe HINTS ${SWAGE_PROGRAM_DIR})
  if(SWAGE_DESCRIBE)
    set(${out} ${SWAGE_DESCRIBE} PARENT_SCOPE)
  else()
    set(${out} "" PARENT_SCOPE)
  endif()
endfunction()

function(swage_add_plugin target)
  cmake_parse_arguments(PLUGIN "NO_INSTALL;NO_SIDECAR" "ID;FOLDER" "SOURCES;RESOURCES;LINKS" ${ARGN})
  if(NOT PLUGIN_ID MATCHES "^[a-z][a-z0-9_]*(\\.[a-z][a-z0-9_]*)+$")
    message(FATAL_ERROR "swage_add_plugin(${target}): ID \"${PLUGIN_ID}\" is not a reverse domain such as org.example.clip")
  endif()
  if(NOT PLUGIN_SOURCES)
    message(FATAL_ERROR "swage_add_plugin(${target}): no SOURCES")
  endif()
  if(PLUGIN_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "swage_add_plugin(${target}): \"${PLUGIN_UNPARSED_ARGUMENTS}\" is not understood")
  endif()
  if(NOT PLUGIN_FOLDER)
    set(PLUGIN_FOLDER ${CMAKE_BINARY_DIR}/plugins)
  endif()
  set(bundle ${PLUGIN_FOLDER}/${PLUGIN_ID})

  add_library(${target} MODULE ${PLUGIN_SOURCES})
  set_target_properties(${target} PROPERTIES
    OUTPUT_NAME ${PLUGIN_ID} LIBRARY_OUTPUT_DIRECTORY ${bundle}
    SWAGE_PLUGIN_ID ${PLUGIN_ID} SWAGE_PLUGIN_BUNDLE ${bundle})
  target_link_libraries(${target} PRIVATE swage::sdk ${PLUGIN_LINKS})
  if(TARGET swage::toolkit)
    target_link_libraries(${target} PRIVATE swage::toolkit)
  endif()
  if(TARGET swage_flags)
    target_link_libraries(${target} PRIVATE swage_flags)
  endif()
  _swage_plugin_flags(${target})

  # resources beside the module; a changed one is copied again
  file(GLOB words RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/words*.json)
  list(APPEND PLUGIN_RESOURCES ${words})
  list(REMOVE_DUPLICATES PLUGIN_RESOURCES)
  foreach(file IN LISTS PLUGIN_RESOURCES)
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    add_custom_command(TARGET ${target} POST_BUILD
      COMMAND ${CMAKE_COMMAND} -E copy_if_different ${CMAKE_CURRENT_SOURCE_DIR}/${file} ${bundle}/ VERBATIM)
  endforeach()

  # plugin.json is made from the module and never written by hand
  _swage_describe_program(describe)
  if(describe AND NOT PLUGIN_NO_SIDECAR)
    if(TARGET swage-describe)
      add_dependencies(${target} swage-describe)
    endif()
    add_custom_command(TARGET ${target} POST_BUILD
      COMMAND ${describe} $<TARGET_FILE:${target}> > ${bundle}/plugin.json
      COMMENT "Describing ${PLUGIN_ID}")
  endif()

  if(NOT PLUGIN_NO_INSTALL)
    set(place lib/swage/plugins/${PLUGIN_ID})
    install(TARGETS ${target} LIBRARY DESTINATION ${place})
    install(FILES ${bundle}/plugin.json DESTINATION ${place} OPTIONAL)
    if(PLUGIN_RESOURCES)
      install(FILES ${PLUGIN_RESOURCES} DESTINATION ${place})
    endif()
  endif()
endfunction()

function(swage_add_plugin_tests target)
  cmake_parse_arguments(TESTS "" "STRICTNESS" "" ${ARGN})
  if(NOT TESTS_STRICTNESS)
    set(TESTS_STRICTNESS 5)
  endif()
  get_target_property(id ${target} SWAGE_PLUGIN_ID)
  get_target_property(bundle ${target} SWAGE_PLUGIN_BUNDLE)
  if(TARGET swage)
    set(program $<TARGET_FILE:swage>)
  else()
    find_program(SWAGE_PROGRAM swage HINTS ${SWAGE_PROGRAM_DIR})
    set(program ${SWAGE_PROGRAM})
  endif()
  if(NOT program)
    message(STATUS "swage_add_plugin_tests(${target}): the program swage is not here, so ${id} is not validated")
    return()
  endif()
  set(limit)
  if(SWAGE_SANITIZE) # up to twenty times slower
    set(limit --limit 400)
  endif()
  add_test(NAME ${id}.validate COMMAND ${program} validate ${bundle} --strictness ${TESTS_STRICTNESS} ${limit})
endfunction()
