# SPDX-License-Identifier: Apache-2.0
# Precompiles headers of the standard library, of fmt and of GoogleTest, which almost every test includes: they take two
# to four seconds of processor time in each group of sources. Such a build does not notice that a test lacks an include;
# the other presets do.

set(precompiled_headers
  <algorithm> <array> <charconv> <chrono> <cmath> <cstddef> <cstdint> <deque> <filesystem> <functional> <limits> <map> <memory>
  <mutex> <optional> <set> <span> <stdexcept> <string> <string_view> <tuple> <unordered_map> <unordered_set> <utility>
  <variant> <vector> <fmt/format.h> <fmt/ranges.h> <gmock/gmock.h> <gtest/gtest.h>)

# precompile_tests(TARGET): the sources of a test program include these headers before their first line. All test
# programs have the same compile options and share one precompiled header.
function(precompile_tests target)
  if(NOT ROBOCHART_PRECOMPILED)
    return()
  endif()
  if(NOT TARGET robochart_precompiled)
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled.cpp CONTENT "")
    add_library(robochart_precompiled OBJECT ${CMAKE_BINARY_DIR}/precompiled.cpp)
    target_link_libraries(robochart_precompiled PRIVATE ${ROBOCHART_FMT} GTest::gtest GTest::gmock)
    target_compile_options(robochart_precompiled PRIVATE ${test_options})
    target_precompile_headers(robochart_precompiled PRIVATE ${precompiled_headers})
  endif()
  target_precompile_headers(${target} REUSE_FROM robochart_precompiled)
endfunction()
