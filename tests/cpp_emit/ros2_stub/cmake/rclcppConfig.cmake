# SPDX-License-Identifier: Apache-2.0
# rclcpp's target, for tests.
if(TARGET rclcpp::rclcpp)
  return()
endif()
add_library(rclcpp::rclcpp INTERFACE IMPORTED)
set_target_properties(rclcpp::rclcpp PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR}/../include)
