# SPDX-License-Identifier: Apache-2.0
# rcl_interfaces' targets, for tests.
if(TARGET rcl_interfaces::rcl_interfaces)
  return()
endif()
add_library(rcl_interfaces::rcl_interfaces INTERFACE IMPORTED)
set_target_properties(rcl_interfaces::rcl_interfaces PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR}/../include)
set(rcl_interfaces_TARGETS rcl_interfaces::rcl_interfaces)
