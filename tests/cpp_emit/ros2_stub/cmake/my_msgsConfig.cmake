# SPDX-License-Identifier: Apache-2.0
# my_msgs' targets, for tests.
if(TARGET my_msgs::my_msgs)
  return()
endif()
add_library(my_msgs::my_msgs INTERFACE IMPORTED)
set_target_properties(my_msgs::my_msgs PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR}/../include)
set(my_msgs_TARGETS my_msgs::my_msgs)
