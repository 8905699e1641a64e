# SPDX-License-Identifier: Apache-2.0
# rclcpp_action' targets, for tests.
if(TARGET rclcpp_action::rclcpp_action)
  return()
endif()
add_library(rclcpp_action::rclcpp_action INTERFACE IMPORTED)
set_target_properties(rclcpp_action::rclcpp_action PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR}/../include)
set(rclcpp_action_TARGETS rclcpp_action::rclcpp_action)
