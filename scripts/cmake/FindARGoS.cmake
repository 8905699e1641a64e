# SPDX-License-Identifier: Apache-2.0
# ARGoS 3 (https://github.com/ilpincy/argos3), built from its sources; -DARGoS_ROOT=PREFIX selects an installation
# outside the system's folders. ARGoS' own configuration changes compiler flags and fails for other prefixes, so this
# module searches the header and the libraries. Sets ARGoS_FOUND, ARGoS_LIBRARY_DIR and the target ARGoS::ARGoS: the
# core and the plugins for e-pucks. Some plugins only register themselves and have no symbols that the program
# references.
find_path(ARGoS_INCLUDE_DIR argos3/core/simulator/simulator.h)
find_library(ARGoS_LIBRARY argos3core_simulator PATH_SUFFIXES argos3)
set(argos_plugins epuck genericrobot dynamics2d media entities)
set(argos_libraries)
foreach(plugin ${argos_plugins})
  find_library(ARGoS_${plugin}_LIBRARY argos3plugin_simulator_${plugin} PATH_SUFFIXES argos3)
  list(APPEND argos_libraries ${ARGoS_${plugin}_LIBRARY})
  list(APPEND argos_required ARGoS_${plugin}_LIBRARY)
  mark_as_advanced(ARGoS_${plugin}_LIBRARY)
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ARGoS REQUIRED_VARS ARGoS_LIBRARY ARGoS_INCLUDE_DIR ${argos_required})
if(ARGoS_FOUND)
  get_filename_component(ARGoS_LIBRARY_DIR ${ARGoS_LIBRARY} DIRECTORY)
  if(NOT TARGET ARGoS::ARGoS)
    add_library(ARGoS::ARGoS INTERFACE IMPORTED)
    set_target_properties(ARGoS::ARGoS PROPERTIES
      INTERFACE_INCLUDE_DIRECTORIES ${ARGoS_INCLUDE_DIR}
      INTERFACE_LINK_OPTIONS "-Wl,--no-as-needed;-Wl,-rpath,${ARGoS_LIBRARY_DIR};-Wl,-rpath-link,${ARGoS_LIBRARY_DIR}"
      INTERFACE_LINK_LIBRARIES "${argos_libraries};${ARGoS_LIBRARY}")
  endif()
endif()
mark_as_advanced(ARGoS_INCLUDE_DIR ARGoS_LIBRARY)
