# Headers of the standard library and of fmt, which nearly every source reads, are compiled once: between a seventh and a
# third of the time of one source is theirs, and one or two seconds of a group of sources (ROBOCHART_UNITY). Such a build
# does not notice a header that a source forgets to include; those of the presets `dev` and `clang` do.

set(precompiled_headers
  <algorithm> <array> <charconv> <chrono> <cmath> <cstddef> <cstdint> <deque> <filesystem> <functional> <limits> <map> <memory>
  <mutex> <optional> <set> <span> <stdexcept> <string> <string_view> <tuple> <unordered_map> <unordered_set> <utility>
  <variant> <vector> <fmt/format.h> <fmt/ranges.h>)

# precompile(TARGET KIND): the target's sources read these headers before their first line. Targets of one kind, which are
# compiled with the same options, share one file: `program`, or `tests`, which reads GoogleTest's too.
function(precompile target kind)
  if(NOT ROBOCHART_PRECOMPILED)
    return()
  endif()
  set(library robochart_precompiled_${kind})
  if(NOT TARGET ${library})
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/precompiled.cpp CONTENT "")
    add_library(${library} OBJECT ${CMAKE_BINARY_DIR}/precompiled.cpp)
    target_link_libraries(${library} PRIVATE ${ROBOCHART_FMT})
    target_precompile_headers(${library} PRIVATE ${precompiled_headers})
    if(kind STREQUAL "tests")
      target_compile_options(${library} PRIVATE ${test_options})
      target_link_libraries(${library} PRIVATE GTest::gtest GTest::gmock)
      target_precompile_headers(${library} PRIVATE <gmock/gmock.h> <gtest/gtest.h>)
    endif()
  endif()
  target_precompile_headers(${target} REUSE_FROM ${library})
endfunction()
