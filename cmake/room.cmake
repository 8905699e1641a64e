# robochart_room(NAME SOURCES ... DEPENDS ...): one static library per room, robochart_NAME.
function(robochart_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;DEPENDS" ${ARGN})
  add_library(robochart_${name} STATIC ${ROOM_SOURCES})
  target_link_libraries(robochart_${name} PUBLIC fmt::fmt ${ROOM_DEPENDS})
endfunction()

# robochart_tests(NAME SOURCES ... DEPENDS ...): one GoogleTest program per room, tests_NAME.
function(robochart_tests name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;DEPENDS" ${ARGN})
  add_executable(tests_${name} ${ROOM_SOURCES})
  # A test is compiled far oftener than its own lines cost time: half of a cold build was optimizing them.
  target_compile_options(tests_${name} PRIVATE -O0)
  target_link_libraries(tests_${name} PRIVATE ${ROOM_DEPENDS} GTest::gtest GTest::gmock GTest::gtest_main)
  target_compile_definitions(tests_${name} PRIVATE ROBOCHART_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  gtest_discover_tests(tests_${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 120 PROPERTIES TIMEOUT 600)
endfunction()
