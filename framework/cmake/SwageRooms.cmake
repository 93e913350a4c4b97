# SPDX-License-Identifier: Apache-2.0
#
# How rooms, plugins and tests of this repository are compiled: one set of flags for all.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 11)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

# same recording, same bits: no contraction, no -march, no fast-math anywhere
add_library(swage_flags INTERFACE)
target_compile_options(swage_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -ffp-contract=off)
if(SWAGE_SANITIZE)
  list(JOIN SWAGE_SANITIZE "," sanitizers)
  add_compile_options(-fsanitize=${sanitizers} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${sanitizers})
  # gcc tells the code by __SANITIZE_ADDRESS__, clang 14 does not
  add_compile_definitions(SWAGE_SANITIZED)
  if("thread" IN_LIST SWAGE_SANITIZE)
    add_compile_definitions(SWAGE_SANITIZED_THREADS)
    # tests that count allocations bring an operator new, and so does clang's runtime: the first one holds
    add_link_options(-Wl,-z,muldefs)
  endif()
endif()

# ENVIRONMENT of tests in which something crashes on purpose: the crash is for those who wait for it, not for a sanitizer, and
# threads of ours bring a stack for signals of their own
set(SWAGE_CRASHES "ASAN_OPTIONS=use_sigaltstack=0:handle_segv=0:handle_abort=0" "TSAN_OPTIONS=handle_segv=0:handle_abort=0:die_after_fork=0")

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

# Whole builds compile ten files at once, as most of a file's time is its headers: a room takes a third of the time, everything (many
# tests are one file) two thirds. Names in anonymous namespaces have to be distinct within a batch. Off where one file is edited and
# built again (preset dev).
option(SWAGE_BATCHES "Compile files in batches" OFF)
# clang says "shadows" of a member and a name of another file of the batch; preset dev keeps the warning
if(SWAGE_BATCHES AND CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  target_compile_options(swage_flags INTERFACE -Wno-shadow)
endif()
function(swage_batches target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${SWAGE_BATCHES} UNITY_BUILD_BATCH_SIZE 10)
  # gcc 12 says it of std::variant where functions of several files are inlined into each other; preset dev keeps the warning
  if(SWAGE_BATCHES AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
  endif()
endfunction()

# swage_not_stepping(<target>): rooms that take no part in a step, where the optimiser takes half of a whole build; -O1 in batches, as
# shipped (-O2) in every other preset
function(swage_not_stepping target)
  if(SWAGE_BATCHES AND CMAKE_BUILD_TYPE STREQUAL RelWithDebInfo)
    target_compile_options(${target} PRIVATE -O1)
  endif()
endfunction()

# swage_room(<name> [SOURCES ...] [LINKS ...])  ->  target swage_<name>, sources relative to the room's folder
function(swage_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;LINKS" ${ARGN})
  if(ROOM_SOURCES)
    add_library(swage_${name} STATIC ${ROOM_SOURCES})
    target_include_directories(swage_${name} PUBLIC ${CMAKE_SOURCE_DIR}/framework)
    target_link_libraries(swage_${name} PUBLIC ${ROOM_LINKS} PRIVATE swage_flags)
    swage_batches(swage_${name})
  else()
    add_library(swage_${name} INTERFACE)
    target_include_directories(swage_${name} INTERFACE ${CMAKE_SOURCE_DIR}/framework)
    target_link_libraries(swage_${name} INTERFACE ${ROOM_LINKS})
  endif()
endfunction()

# swage_test(<name> SOURCES ... LINKS ... [LABELS ...] [ENVIRONMENT ...] [TIMEOUT s] [SHARDS n] [WAITS])  ->  CTest entry <name>
# WAITS: it sleeps more than it works, as a driver's test does; three of them share a core
# SHARDS: its tests run in n processes at once; for tests that mostly wait, or that are long and many
function(swage_test name)
  cmake_parse_arguments(TEST "WAITS" "TIMEOUT;SHARDS" "SOURCES;LINKS;LABELS;ENVIRONMENT;ARGS" ${ARGN})
  string(REPLACE "." "_" target test_${name})
  add_executable(${target} ${TEST_SOURCES})
  target_link_libraries(${target} PRIVATE ${TEST_LINKS} GTest::gtest GTest::gmock GTest::gtest_main swage_flags)
  target_include_directories(${target} PRIVATE ${CMAKE_BINARY_DIR}/tests/include)
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  swage_batches(${target})
  # a third less to compile; what is under test keeps -O2, and its bits are the same at every level
  if(SWAGE_BATCHES AND CMAKE_BUILD_TYPE STREQUAL RelWithDebInfo)
    target_compile_options(${target} PRIVATE -O1 -g0 -Wno-mismatched-new-delete)  # gcc 12 says it of an operator new that -O1 inlines
  endif()
  if(TEST_SHARDS)
    add_test(NAME ${name} COMMAND ${CMAKE_SOURCE_DIR}/tests/in_shards.sh ${TEST_SHARDS} $<TARGET_FILE:${target}> ${TEST_ARGS})
  else()
    add_test(NAME ${name} COMMAND ${target} ${TEST_ARGS})
  endif()
  # only so that a hang ends: no test takes a tenth of it, however busy the machine is
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 900)
  endif()
  if(SWAGE_SANITIZE) # up to ten times as slow
    math(EXPR TEST_TIMEOUT "10 * ${TEST_TIMEOUT}")
  endif()
  # in thirds of a core: scripts/test.sh gives three for each core
  set(processors 3)
  if(TEST_WAITS)
    set(processors 1)
  endif()
  set_tests_properties(${name} PROPERTIES PROCESSORS ${processors} TIMEOUT ${TEST_TIMEOUT} LABELS "${TEST_LABELS}"
    ENVIRONMENT "${TEST_ENVIRONMENT}")
endfunction()

# swage_sources(<out> <source>...)  ->  what a test links of each source, relative to the root: the object that the plugin of its
# folder compiles anyway, or the source itself where no plugin does
function(swage_sources out)
  set(linked)
  foreach(source IN LISTS ARGN)
    get_filename_component(folder ${CMAKE_SOURCE_DIR}/${source} DIRECTORY)
    get_filename_component(file ${source} NAME)
    set(found ${CMAKE_SOURCE_DIR}/${source})
    set(targets)
    if(EXISTS ${folder}/CMakeLists.txt AND source MATCHES "^(plugins|devices|lessons)/")
      get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
    endif()
    foreach(target IN LISTS targets)
      get_target_property(type ${target} TYPE)
      get_target_property(compiled ${target} SOURCES)
      if(type STREQUAL MODULE_LIBRARY AND file IN_LIST compiled)
        string(REPLACE "." "\\." pattern ${file})
        set(found "$<FILTER:$<TARGET_OBJECTS:${target}>,INCLUDE,/${pattern}>")
      endif()
    endforeach()
    list(APPEND linked ${found})
  endforeach()
  set(${out} ${linked} PARENT_SCOPE)
endfunction()

# adds every folder below `parent` that has a CMakeLists.txt, in alphabetical order
function(swage_add_folders parent)
  file(GLOB folders CONFIGURE_DEPENDS ${parent}/*/CMakeLists.txt)
  foreach(file IN LISTS folders)
    get_filename_component(folder ${file} DIRECTORY)
    add_subdirectory(${folder})
  endforeach()
endfunction()
