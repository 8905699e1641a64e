# SPDX-License-Identifier: Apache-2.0
# diagnostic_msgs' targets, for tests.
if(TARGET diagnostic_msgs::diagnostic_msgs)
  return()
endif()
add_library(diagnostic_msgs::diagnostic_msgs INTERFACE IMPORTED)
set_target_properties(diagnostic_msgs::diagnostic_msgs PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR}/../include)
set(diagnostic_msgs_TARGETS diagnostic_msgs::diagnostic_msgs)
