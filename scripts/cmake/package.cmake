# SPDX-License-Identifier: Apache-2.0
# Packages: `cpack` in a build tree of the preset `package` makes a .deb and a .tar.gz that can be unpacked anywhere.
# scripts/package.sh runs it and tests both.
set(CPACK_GENERATOR "TGZ;DEB")
set(CPACK_PACKAGE_CONTACT "The robochart-verify project")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "verification of RoboChart models")
set(CPACK_PACKAGE_FILE_NAME robochart-verify-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Reads models of robot controllers in RoboChart, reports what is wrong with
them, decides their assertions in the CSP semantics and shows counterexamples
as runs of the model, generates C++ controllers and checks that the code
refines the semantics. Decides the assertions of CSPM scripts too.
.
Comparing generated code with its model (conform) and simulating (simulate)
need a C++ compiler; everything else works without.")
# Computes the packages of the required libraries: only the C library if ROBOCHART_PORTABLE is on.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "g++")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "librsvg2-bin, ffmpeg")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# The library is a separate package, which depends on the program. The archive for all systems contains only the
# program.
set(CPACK_COMPONENTS_ALL Unspecified development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME robochart-verify)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME librobochart-verify-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "robochart-verify (= ${PROJECT_VERSION}), libsodium-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "g++, cmake")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
"library to load RoboChart models and to decide their claims
The static library robochart::driver with its header, for programs in C++.")
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_ARCHIVE_UNSPECIFIED_FILE_NAME ${CPACK_PACKAGE_FILE_NAME})
set(CPACK_ARCHIVE_DEVELOPMENT_FILE_NAME robochart-verify-dev-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_SOURCE_DIR}/scripts/cmake/package_generator.cmake)
include(CPack)
