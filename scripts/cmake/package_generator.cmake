# SPDX-License-Identifier: Apache-2.0
# Read by CPack for each kind of package: only archives have a folder around their files.
if(CPACK_GENERATOR STREQUAL "TGZ")
  set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
endif()
