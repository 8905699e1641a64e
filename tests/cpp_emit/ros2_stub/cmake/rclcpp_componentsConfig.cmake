# SPDX-License-Identifier: Apache-2.0
# The target and command of rclcpp_components, for tests. The real command generates a program with the node and builds
# it.
if(TARGET rclcpp_components::component)
  return()
endif()
add_library(rclcpp_components::component INTERFACE IMPORTED)
set_target_properties(rclcpp_components::component PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR}/../include)
function(rclcpp_components_register_node target)
  cmake_parse_arguments(NODE "" "PLUGIN;EXECUTABLE" "" ${ARGN})
  if(NOT TARGET ${target} OR NOT NODE_PLUGIN OR NOT NODE_EXECUTABLE)
    message(FATAL_ERROR "rclcpp_components_register_node: a target, PLUGIN and EXECUTABLE")
  endif()
  if(TARGET ${NODE_EXECUTABLE})
    message(FATAL_ERROR "rclcpp_components_register_node: ${NODE_EXECUTABLE} is a target already")
  endif()
endfunction()
