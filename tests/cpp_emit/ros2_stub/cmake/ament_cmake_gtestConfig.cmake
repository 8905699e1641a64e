# SPDX-License-Identifier: Apache-2.0
# The command of ament_cmake_gtest, for tests.
find_package(GTest REQUIRED)
find_package(Threads REQUIRED)
function(ament_add_gtest name)
  enable_testing()
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} GTest::gtest GTest::gtest_main Threads::Threads)
  add_test(NAME ${name} COMMAND ${name})
endfunction()
