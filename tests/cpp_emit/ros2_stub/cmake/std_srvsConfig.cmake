# SPDX-License-Identifier: Apache-2.0
# std_srvs' targets, for tests.
if(TARGET std_srvs::std_srvs)
  return()
endif()
add_library(std_srvs::std_srvs INTERFACE IMPORTED)
set_target_properties(std_srvs::std_srvs PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR}/../include)
set(std_srvs_TARGETS std_srvs::std_srvs)
