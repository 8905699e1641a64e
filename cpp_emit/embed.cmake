# SPDX-License-Identifier: Apache-2.0
# Builds the texts of the shipped headers into the program: one function for each header.
set(text "// Texts of cpp_emit/runtime, built in by embed.cmake.\n#include \"cpp_emit/files/files.hpp\"\n\nnamespace robochart::cpp_emit {\n\n")
foreach(pair runtime_header=runtime.hpp finite_header=finite.hpp tracked_header=tracked.hpp tracked_sequences=tracked_sequences.hpp deployed_header=deployed.hpp timer_header=timer.hpp layout_helpers=layout.hpp composed_header=composed.hpp matrix_header=matrix.hpp eigen_header=eigen.hpp toolkit_header=toolkit.hpp views_header=views.hpp text_header=text.hpp explore_helpers=explore.hpp explore_values=explore_values.hpp explore_header=explore_abi.h probes_header=probes.hpp drive_header=drive_abi.h monitor_header=monitor.hpp rules_header=rules.hpp trace_helpers=trace.hpp trace_files=trace_file.hpp mcap_writer=mcap_writer.hpp adaptive_header=adaptive.hpp console_choices=console_choices.hpp console_values=console_values.hpp)
  string(REGEX MATCH "^([a-z_]+)=(.+)$" _ ${pair})
  file(READ ${RUNTIME_DIR}/${CMAKE_MATCH_2} content)
  string(APPEND text "std::string ${CMAKE_MATCH_1}() {\n    return R\"--runtime--(${content})--runtime--\";\n}\n\n")
endforeach()
string(APPEND text "}  // namespace robochart::cpp_emit\n")
file(WRITE ${OUTPUT} "${text}")
