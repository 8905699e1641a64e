# SPDX-License-Identifier: Apache-2.0
# geometry_msgs' targets, for tests.
if(TARGET geometry_msgs::geometry_msgs)
  return()
endif()
add_library(geometry_msgs::geometry_msgs INTERFACE IMPORTED)
set_target_properties(geometry_msgs::geometry_msgs PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR}/../include)
set(geometry_msgs_TARGETS geometry_msgs::geometry_msgs)
