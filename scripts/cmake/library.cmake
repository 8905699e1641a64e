# SPDX-License-Identifier: Apache-2.0
# The library robochart::driver for other programs (docs/library.md): one archive with the driver and all components
# that it needs, one public header, and a file for `find_package(robochart-verify)`. The target `robochart_library` makes
# the archive; without it only the other two files are installed.
include(GNUInstallDirs)

# collect_libraries(TARGET): adds the archives of a component and of all components that it links to the global property
# LIBRARY_ARCHIVES, and the libraries from elsewhere to LIBRARY_OTHERS.
function(collect_libraries target)
  get_property(archives GLOBAL PROPERTY LIBRARY_ARCHIVES)
  if(target IN_LIST archives)
    return()
  endif()
  set_property(GLOBAL APPEND PROPERTY LIBRARY_ARCHIVES ${target})
  get_target_property(linked ${target} LINK_LIBRARIES)
  foreach(library IN LISTS linked)
    set(type "")
    if(TARGET ${library})
      get_target_property(type ${library} TYPE)
      get_target_property(imported ${library} IMPORTED)
    endif()
    if(type STREQUAL "STATIC_LIBRARY" AND NOT imported)
      collect_libraries(${library})
    elseif(library AND NOT library MATCHES "^(nlohmann_json::nlohmann_json|Boost::headers)$")  # these are only headers
      set_property(GLOBAL APPEND PROPERTY LIBRARY_OTHERS ${library})
    endif()
  endforeach()
endfunction()
collect_libraries(robochart_driver)
get_property(archives GLOBAL PROPERTY LIBRARY_ARCHIVES)
get_property(others GLOBAL PROPERTY LIBRARY_OTHERS)
list(REMOVE_DUPLICATES others)

set(archive ${CMAKE_BINARY_DIR}/librobochart_driver.a)
set(script "create ${archive}\n")
set(files "")
foreach(component IN LISTS archives)
  string(APPEND script "addlib $<TARGET_FILE:${component}>\n")
  list(APPEND files $<TARGET_FILE:${component}>)
endforeach()
file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/library.mri CONTENT "${script}save\nend\n")
add_custom_command(OUTPUT ${archive}
  COMMAND ${CMAKE_COMMAND} -E rm -f ${archive}
  COMMAND sh -c "${CMAKE_AR} -M < ${CMAKE_BINARY_DIR}/library.mri"
  DEPENDS ${archives} ${files} ${CMAKE_BINARY_DIR}/library.mri
  VERBATIM)
if(ROBOCHART_TESTS)  # a test links it
  set(always ALL)
endif()
add_custom_target(robochart_library ${always} DEPENDS ${archive})

# Lists the other libraries by name, because their paths differ between machines.
set(driver_needs "")
set(driver_finds "")
foreach(library IN LISTS others)
  if(library MATCHES "^(.+)::.+$")
    set(package ${CMAKE_MATCH_1})
    list(APPEND driver_needs ${library})
    list(APPEND driver_finds ${package})
  elseif(IS_ABSOLUTE ${library})
    get_filename_component(name ${library} NAME_WE)
    string(REGEX REPLACE "^lib" "" name ${name})
    list(APPEND driver_needs ${name})
  else()
    list(APPEND driver_needs ${library})
  endif()
endforeach()
list(REMOVE_DUPLICATES driver_finds)
file(RELATIVE_PATH driver_archive ${CMAKE_INSTALL_FULL_DATADIR}/robochart-verify/cmake
     ${CMAKE_INSTALL_FULL_LIBDIR}/librobochart_driver.a)
file(RELATIVE_PATH driver_headers ${CMAKE_INSTALL_FULL_DATADIR}/robochart-verify/cmake
     ${CMAKE_INSTALL_FULL_INCLUDEDIR})
configure_file(${CMAKE_SOURCE_DIR}/scripts/cmake/robochart-driver.cmake.in ${CMAKE_BINARY_DIR}/robochart-driver.cmake @ONLY)

install(FILES ${archive} DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development OPTIONAL)
install(FILES ${CMAKE_SOURCE_DIR}/driver/robochart_verify.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        COMPONENT development)
install(FILES ${CMAKE_BINARY_DIR}/robochart-driver.cmake DESTINATION ${CMAKE_INSTALL_DATADIR}/robochart-verify/cmake
        COMPONENT development)
