# SPDX-License-Identifier: Apache-2.0
# Writes command_identity.cpp with PROGRAM's build ID as READELF prints it. An unchanged file is not written again.
execute_process(COMMAND ${READELF} --notes ${PROGRAM} OUTPUT_VARIABLE notes RESULT_VARIABLE failed)
set(bytes "")
if(NOT failed AND notes MATCHES "Build ID: ([0-9a-f]+)")
  string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${CMAKE_MATCH_1}")
endif()
string(REGEX REPLACE "\\\\x" "" digits "${bytes}")
string(LENGTH "${digits}" length)
math(EXPR length "${length} / 2")
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
#include "app/mpi/command_identity.hpp"

std::string robochart::app::command_identity() {
    return {"@bytes@", @length@};
}
]])
