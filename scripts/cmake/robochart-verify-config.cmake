# SPDX-License-Identifier: Apache-2.0
# For CMake projects that contain RoboChart models: `find_package(robochart-verify)`, then
#
#   robochart_verify(MODEL <file or folder> [NAME <test>] [VERB verify|check|conform|validate] [OPTIONS <option>...]
#                    [TIMEOUT <seconds>])
#
# adds a test that CTest runs. It passes if all verdicts are as claimed (exit 0). Output files go below the build tree.
# Defines robochart_verify_PROGRAM, the target robochart::verify for dependencies and, if the library is installed, the
# target robochart::driver (docs/library.md).
find_program(robochart_verify_PROGRAM robochart-verify HINTS "${CMAKE_CURRENT_LIST_DIR}/../../../bin")
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(robochart-verify REQUIRED_VARS robochart_verify_PROGRAM)

if(robochart-verify_FOUND AND NOT TARGET robochart::verify)
  add_executable(robochart::verify IMPORTED)
  set_target_properties(robochart::verify PROPERTIES IMPORTED_LOCATION "${robochart_verify_PROGRAM}")
endif()

include("${CMAKE_CURRENT_LIST_DIR}/robochart-driver.cmake" OPTIONAL)

function(robochart_verify)
  cmake_parse_arguments(PARSE_ARGV 0 wanted "" "MODEL;NAME;VERB;TIMEOUT" "OPTIONS")
  if(NOT wanted_MODEL OR wanted_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "robochart_verify(MODEL <file or folder> [NAME ...] [VERB ...] [OPTIONS ...] [TIMEOUT ...]): "
                        "unknown or missing: ${wanted_UNPARSED_ARGUMENTS}")
  endif()
  get_filename_component(model "${wanted_MODEL}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
  if(NOT EXISTS "${model}")
    message(FATAL_ERROR "robochart_verify: ${model} does not exist")
  endif()
  if(NOT wanted_VERB)
    set(wanted_VERB verify)
  endif()
  if(NOT wanted_VERB MATCHES "^(verify|check|conform|validate)$")
    message(FATAL_ERROR "robochart_verify: the verb ${wanted_VERB} is none of verify, check, conform, validate")
  endif()
  if(NOT wanted_NAME)
    get_filename_component(stem "${model}" NAME_WE)
    set(wanted_NAME "robochart.${wanted_VERB}.${stem}")
  endif()
  set(out "")
  if(wanted_VERB STREQUAL "verify")
    set(out --out "${CMAKE_CURRENT_BINARY_DIR}/${wanted_NAME}")
  endif()
  add_test(NAME "${wanted_NAME}"
           COMMAND "${robochart_verify_PROGRAM}" "${wanted_VERB}" "${model}" ${out} --color never ${wanted_OPTIONS})
  set_tests_properties("${wanted_NAME}" PROPERTIES LABELS robochart)
  if(wanted_TIMEOUT)
    set_tests_properties("${wanted_NAME}" PROPERTIES TIMEOUT "${wanted_TIMEOUT}")
  endif()
endfunction()
