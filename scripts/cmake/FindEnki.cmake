# SPDX-License-Identifier: Apache-2.0
# Enki (https://github.com/enki-community/enki), Debian: libenki-dev. Enki's own configuration requires Qt even without
# the viewer, so this module searches the header and the library. Sets Enki_FOUND and the target Enki::Enki.
find_path(Enki_INCLUDE_DIR enki/PhysicalEngine.h)
find_library(Enki_LIBRARY enki)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Enki REQUIRED_VARS Enki_LIBRARY Enki_INCLUDE_DIR)
if(Enki_FOUND AND NOT TARGET Enki::Enki)
  add_library(Enki::Enki UNKNOWN IMPORTED)
  set_target_properties(Enki::Enki PROPERTIES IMPORTED_LOCATION ${Enki_LIBRARY}
                        INTERFACE_INCLUDE_DIRECTORIES ${Enki_INCLUDE_DIR})
endif()
mark_as_advanced(Enki_INCLUDE_DIR Enki_LIBRARY)
