# SPDX-License-Identifier: Apache-2.0
# Removes the files that the last `cmake --install` of a build tree wrote. Folders stay, because other software may use
# them.
# cmake -DMANIFEST=build/install_manifest.txt -P uninstall.cmake
if(NOT EXISTS ${MANIFEST})
  message(FATAL_ERROR "nothing was installed from here: ${MANIFEST} does not exist")
endif()
file(STRINGS ${MANIFEST} installed)
foreach(file ${installed})
  message(STATUS "removing $ENV{DESTDIR}${file}")
  file(REMOVE "$ENV{DESTDIR}${file}")
endforeach()
