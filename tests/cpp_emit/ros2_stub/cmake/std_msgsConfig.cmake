# SPDX-License-Identifier: Apache-2.0
# std_msgs' targets, for tests.
if(TARGET std_msgs::std_msgs)
  return()
endif()
add_library(std_msgs::std_msgs INTERFACE IMPORTED)
set_target_properties(std_msgs::std_msgs PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR}/../include)
set(std_msgs_TARGETS std_msgs::std_msgs)
