# SPDX-License-Identifier: Apache-2.0
# nav2_msgs' targets, for tests.
if(TARGET nav2_msgs::nav2_msgs)
  return()
endif()
add_library(nav2_msgs::nav2_msgs INTERFACE IMPORTED)
set_target_properties(nav2_msgs::nav2_msgs PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR}/../include)
set(nav2_msgs_TARGETS nav2_msgs::nav2_msgs)
