# SPDX-License-Identifier: Apache-2.0
# sensor_msgs' targets, for tests.
if(TARGET sensor_msgs::sensor_msgs)
  return()
endif()
add_library(sensor_msgs::sensor_msgs INTERFACE IMPORTED)
set_target_properties(sensor_msgs::sensor_msgs PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR}/../include)
set(sensor_msgs_TARGETS sensor_msgs::sensor_msgs)
