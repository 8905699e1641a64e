# SPDX-License-Identifier: Apache-2.0
# Installs the man page, completions, licences, examples and documents, in addition to the program and the libraries of
# the language; also a target that removes installed files. Headers of generated code are not installed: they are
# embedded in the program, which writes them with the code.
include(GNUInstallDirs)

# Runs at configuration, so that `cmake --install` needs only the program.
set(man_page ${CMAKE_SOURCE_DIR}/docs/robochart-verify.1)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${man_page})
find_program(GZIP_PROGRAM gzip REQUIRED)
execute_process(COMMAND ${GZIP_PROGRAM} -9 --no-name --stdout ${man_page}
                OUTPUT_FILE ${CMAKE_BINARY_DIR}/robochart-verify.1.gz COMMAND_ERROR_IS_FATAL ANY)
install(FILES ${CMAKE_BINARY_DIR}/robochart-verify.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)

set(completions ${CMAKE_SOURCE_DIR}/editors/completion)
install(FILES ${completions}/robochart-verify.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        RENAME robochart-verify)
install(FILES ${completions}/_robochart-verify DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${completions}/robochart-verify.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

install(FILES ${CMAKE_SOURCE_DIR}/LICENSE ${CMAKE_SOURCE_DIR}/AUTHORS ${CMAKE_SOURCE_DIR}/CITATION.cff
              ${CMAKE_SOURCE_DIR}/scripts/cmake/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${CMAKE_SOURCE_DIR}/corpus/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs/pictures DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(CODE "set(sources \"${CMAKE_SOURCE_DIR}\")
set(build \"${CMAKE_BINARY_DIR}\")
set(destination \"${CMAKE_INSTALL_DOCDIR}\")
include(\"${CMAKE_SOURCE_DIR}/scripts/cmake/install_pages.cmake\")")

add_custom_target(uninstall COMMAND ${CMAKE_COMMAND} -DMANIFEST=${CMAKE_BINARY_DIR}/install_manifest.txt
                  -P ${CMAKE_SOURCE_DIR}/scripts/cmake/uninstall.cmake VERBATIM)

# `find_package(robochart-verify)` for other projects: a function that adds tests (docs/ci.md).
install(FILES ${CMAKE_SOURCE_DIR}/scripts/cmake/robochart-verify-config.cmake
        DESTINATION ${CMAKE_INSTALL_DATADIR}/robochart-verify/cmake)
