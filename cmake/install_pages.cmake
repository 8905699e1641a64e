# Installs README.md, CHANGELOG.md and the pages of docs/ side by side, with links that fit: README.md is not above docs/
# there, and what is only in the sources is no link. The installation runs this with `sources`, `build` and `destination`.
# At the top level, not in a function, so that CMake adds the files to its list of what was installed.
if(NOT IS_ABSOLUTE "${destination}")
  set(destination "${CMAKE_INSTALL_PREFIX}/${destination}")
endif()
set(only_in_sources "\\.\\./|editors/|cpp_emit/|CONTRIBUTING\\.md|robochart-verify\\.1")
file(GLOB pages "${sources}/docs/*.md")
foreach(page IN LISTS pages ITEMS "${sources}/README.md" "${sources}/CHANGELOG.md")
  file(READ "${page}" text)
  string(REPLACE "](docs/" "](" text "${text}")
  string(REPLACE "](../README.md" "](README.md" text "${text}")
  string(REGEX REPLACE "\\[([^]]*)\\]\\((${only_in_sources})[^)]*\\)" "\\1" text "${text}")
  get_filename_component(name "${page}" NAME)
  file(WRITE "${build}/pages/${name}" "${text}")
  file(INSTALL "${build}/pages/${name}" DESTINATION "${destination}")
endforeach()
