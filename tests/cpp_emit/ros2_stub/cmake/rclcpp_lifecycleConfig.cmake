# SPDX-License-Identifier: Apache-2.0
# rclcpp_lifecycle's target, for tests.
if(TARGET rclcpp_lifecycle::rclcpp_lifecycle)
  return()
endif()
add_library(rclcpp_lifecycle::rclcpp_lifecycle INTERFACE IMPORTED)
set_target_properties(rclcpp_lifecycle::rclcpp_lifecycle PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR}/../include)
