# SPDX-License-Identifier: Apache-2.0
# A component is a folder. Its subfolders are listed in the order of their dependencies (docs/architecture.md). Sources
# are found by their folder.

# sources_of(RESULT FOLDER ...): the .cpp files of these folders below the current one, "." for the current one.
function(sources_of result)
  set(found "")
  foreach(folder ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
    if(NOT sources)
      message(FATAL_ERROR "${CMAKE_CURRENT_SOURCE_DIR}/${folder} has no sources")
    endif()
    list(APPEND found ${sources})
  endforeach()
  set(${result} ${found} PARENT_SCOPE)
endfunction()

# unite(RESULT TARGET SOURCES ...): the files to compile for these sources. With ROBOCHART_UNITY, they are groups of at
# most twenty sources, each of which parses the common headers once. So names without linkage differ in the folders that
# are united. A group includes its sources by their places in the project: CMake's own UNITY_BUILD writes absolute
# paths, which become part of the preprocessed text, so that ccache would find nothing in another clone.
function(unite result target)
  list(LENGTH ARGN count)
  if(NOT ROBOCHART_UNITY OR count EQUAL 0)
    set(${result} ${ARGN} PARENT_SCOPE)
    return()
  endif()
  set(most 20)
  list(GET ARGN 0 first)
  get_filename_component(folder ${first} DIRECTORY)
  file(RELATIVE_PATH folder ${CMAKE_CURRENT_SOURCE_DIR} ${folder})
  string(MAKE_C_IDENTIFIER "${folder}" folder)
  math(EXPR groups "(${count} + ${most} - 1) / ${most}")
  set(number 0)
  foreach(source ${ARGN})
    math(EXPR group "${number} * ${groups} / ${count}")
    file(RELATIVE_PATH place ${CMAKE_SOURCE_DIR} ${source})
    string(APPEND includes_${group} "#include \"${place}\"\n")
    math(EXPR number "${number} + 1")
  endforeach()
  set(files "")
  math(EXPR last "${groups} - 1")
  foreach(group RANGE ${last})
    set(united ${CMAKE_CURRENT_BINARY_DIR}/united/${target}/${folder}_${group}.cpp)
    file(CONFIGURE OUTPUT ${united} CONTENT "${includes_${group}}" @ONLY)
    list(APPEND files ${united})
  endforeach()
  set(${result} ${files} PARENT_SCOPE)
endfunction()

# warn_as_united(TARGET): switches off two warnings for sources that are included. The first treats such a source as a
# header, the second finds names of other sources. Builds without ROBOCHART_UNITY use both.
function(warn_as_united target)
  if(ROBOCHART_UNITY)
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage> -Wno-shadow)
  endif()
endfunction()

# The number of cases of each law that RapidCheck tries, from one seed, so that a run of the tests has one result. Under
# sanitizers, a few cases show the faults of memory. `tests/long.sh rounds` tries more from a new seed.
set(law_cases 40)
if(ROBOCHART_SANITIZE)
  set(law_cases 12)
endif()

# Optimisation of tests took half of a cold build, and their own code takes little time to run.
set(test_options -O0)

# robochart_component(NAME [LIGHT | SEARCH | TESTS] FOLDERS ... [SOURCES generated files ...] DEPENDS ...): a static
# library, robochart_NAME. Builds other than Debug optimise it with -O2. LIGHT: -O1, because it does little of the work at
# run time, which saves a quarter of its compile time. SEARCH: -O3, because its loops take most of the time of a check.
# TESTS: only tests use it, and it has their compile options.
function(robochart_component name)
  cmake_parse_arguments(COMPONENT "LIGHT;SEARCH;TESTS" "" "FOLDERS;SOURCES;DEPENDS" ${ARGN})
  sources_of(sources ${COMPONENT_FOLDERS})
  unite(files robochart_${name} ${sources})
  add_library(robochart_${name} STATIC ${files} ${COMPONENT_SOURCES})
  target_link_libraries(robochart_${name} PUBLIC ${ROBOCHART_FMT} ${COMPONENT_DEPENDS})
  warn_as_united(robochart_${name})
  set(optimisation -O2)
  if(COMPONENT_TESTS)
    set(optimisation ${test_options})
  elseif(COMPONENT_LIGHT)
    set(optimisation -O1)
  elseif(COMPONENT_SEARCH)
    set(optimisation -O3)
  endif()
  if(COMPONENT_TESTS OR NOT CMAKE_BUILD_TYPE STREQUAL Debug)
    target_compile_options(robochart_${name} PRIVATE ${optimisation})
  endif()
endfunction()

# robochart_tests(NAME FOLDERS ... [ALONE folders ...] [SOURCES more files ...] DEPENDS ...): a GoogleTest program,
# tests_NAME. ALONE: folders whose sources use the same names with different meanings; they are compiled one by one.
# Programs in ROBOCHART_TESTS_ELSEWHERE are left out.
function(robochart_tests name)
  if(name IN_LIST ROBOCHART_TESTS_ELSEWHERE)
    return()
  endif()
  cmake_parse_arguments(TESTS "" "" "FOLDERS;ALONE;SOURCES;DEPENDS" ${ARGN})
  set(files ${TESTS_SOURCES})
  foreach(folder ${TESTS_FOLDERS})  # folders are not mixed: many tests have helpers with the same names
    sources_of(in_folder ${folder})
    if(NOT folder IN_LIST TESTS_ALONE)
      unite(in_folder tests_${name} ${in_folder})
    endif()
    list(APPEND files ${in_folder})
  endforeach()
  add_executable(tests_${name} ${files})
  warn_as_united(tests_${name})
  target_compile_options(tests_${name} PRIVATE ${test_options})
  precompile_tests(tests_${name})
  target_link_libraries(tests_${name} PRIVATE ${TESTS_DEPENDS} robochart_source_folder GTest::gtest GTest::gmock GTest::gtest_main)
  gtest_discover_tests(tests_${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 120 
    PROPERTIES TIMEOUT 600 ENVIRONMENT "RC_PARAMS=seed=36 max_success=${law_cases}")
endfunction()

# robochart_embed_texts(RESULT FOLDER folder HEADER header NAMESPACE n FUNCTION f): generates a source that contains the
# files of a folder below the current one (embed_texts.cmake); RESULT receives its path.
function(robochart_embed_texts result)
  cmake_parse_arguments(EMBED "" "FOLDER;HEADER;NAMESPACE;FUNCTION" "" ${ARGN})
  set(folder ${CMAKE_CURRENT_SOURCE_DIR}/${EMBED_FOLDER})
  set(script ${CMAKE_SOURCE_DIR}/scripts/cmake/embed_texts.cmake)
  set(made ${CMAKE_CURRENT_BINARY_DIR}/${result}.cpp)
  file(GLOB_RECURSE texts CONFIGURE_DEPENDS ${folder}/*)
  add_custom_command(
    OUTPUT ${made}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DHEADER=${EMBED_HEADER} -DNAMESPACE=${EMBED_NAMESPACE}
            -DFUNCTION=${EMBED_FUNCTION} -DOUTPUT=${made} -P ${script}
    DEPENDS ${texts} ${script}
    VERBATIM)
  set(${result} ${made} PARENT_SCOPE)
endfunction()
