# SPDX-License-Identifier: Apache-2.0
# Installs README.md, CHANGELOG.md and the pages of docs/ in one folder and adapts their links. docs/README.md becomes
# DOCUMENTS.md, because README.md is in the same folder. A link to a file that is only in the sources becomes plain text.
# The installation runs this with `sources`, `build` and `destination`.
# This is at the top level and not in a function, so that CMake adds the files to its list of installed files.
if(NOT IS_ABSOLUTE "${destination}")
  set(destination "${CMAKE_INSTALL_PREFIX}/${destination}")
endif()
set(only_in_sources "\\.\\./|editors/|cpp_emit/|CONTRIBUTING\\.md|robochart-verify\\.1")
file(GLOB pages RELATIVE "${sources}" "${sources}/docs/*.md")
foreach(page IN LISTS pages ITEMS README.md CHANGELOG.md)
  file(READ "${sources}/${page}" text)
  string(REPLACE "](docs/" "](" text "${text}")
  string(REPLACE "](README.md" "](DOCUMENTS.md" text "${text}")  # in docs/, or README.md's link to docs/README.md
  string(REPLACE "](../README.md" "](README.md" text "${text}")
  string(REPLACE "](../CHANGELOG.md" "](CHANGELOG.md" text "${text}")
  string(REGEX REPLACE "\\[([^]]*)\\]\\((${only_in_sources})[^)]*\\)" "\\1" text "${text}")
  get_filename_component(name "${page}" NAME)
  if(page STREQUAL "docs/README.md")
    set(name DOCUMENTS.md)
  endif()
  file(WRITE "${build}/pages/${name}" "${text}")
  file(INSTALL "${build}/pages/${name}" DESTINATION "${destination}")
endforeach()
