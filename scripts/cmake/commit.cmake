# SPDX-License-Identifier: Apache-2.0
# Writes a source with the commit that is built: cmake -DFOLDER=DIR -DOUTPUT=FILE.cpp -P commit.cmake
# An unchanged file is not written again, so that a build at the same commit compiles and links nothing.
set(id "")
set(modified false)
set(archived [[$Format:%H$]])  # `git archive` puts the commit here (.gitattributes)
execute_process(COMMAND git -C ${FOLDER} rev-parse --show-prefix
                OUTPUT_VARIABLE prefix RESULT_VARIABLE failed ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
if(archived MATCHES "^[0-9a-f]+$")
  set(id ${archived})
elseif(failed STREQUAL "0" AND prefix STREQUAL "")  # otherwise FOLDER is a part of another repository
  execute_process(COMMAND git -C ${FOLDER} rev-parse --verify --quiet HEAD
                  OUTPUT_VARIABLE id ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  execute_process(COMMAND git -C ${FOLDER} --no-optional-locks status --porcelain --untracked-files=no
                  OUTPUT_VARIABLE changes ERROR_QUIET)
  if(NOT changes STREQUAL "")
    set(modified true)
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
// Written by scripts/cmake/commit.cmake.
#include "app/base/built_commit.hpp"

robochart::app::Commit robochart::app::built_commit() {
    return {"@id@", @modified@};
}
]])
