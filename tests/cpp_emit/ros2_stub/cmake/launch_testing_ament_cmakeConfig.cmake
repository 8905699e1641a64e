# SPDX-License-Identifier: Apache-2.0
# The command of launch_testing_ament_cmake, for tests: the file exists and is Python.
find_program(STUB_PYTHON python3 REQUIRED)
function(add_launch_test file)
  enable_testing()
  add_test(NAME ${file} COMMAND ${STUB_PYTHON} -c
           "import ast, sys; ast.parse(open(sys.argv[1]).read())" ${CMAKE_CURRENT_SOURCE_DIR}/${file})
endfunction()
