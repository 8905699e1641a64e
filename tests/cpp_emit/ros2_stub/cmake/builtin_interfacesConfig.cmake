# SPDX-License-Identifier: Apache-2.0
# builtin_interfaces' targets, for tests.
if(TARGET builtin_interfaces::builtin_interfaces)
  return()
endif()
add_library(builtin_interfaces::builtin_interfaces INTERFACE IMPORTED)
set_target_properties(builtin_interfaces::builtin_interfaces PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR}/../include)
set(builtin_interfaces_TARGETS builtin_interfaces::builtin_interfaces)
