// SPDX-License-Identifier: Apache-2.0
// Writes the files of an emission, with one function for each file.
#pragma once

#include <string>

#include "cpp_emit/expressions/generation.hpp"
#include "cpp_emit/machine/machine_code.hpp"

namespace robochart::cpp_emit {

/// The data of the core's text that several files use.
struct Core {
    std::string name_space;                     ///< qualified namespace: "aggregation::AggregationFSM_core"
    std::string relative;                       ///< the same namespace, relative to the package's
    std::string header;                         ///< file name
    std::vector<MachineCode> machines;          ///< in the order of Component::units
    FrameLayout layout;                         ///< layout of State
    std::vector<const EventPort*> kept_inputs;  ///< Fault::event_kept: inputs that are not cleared after the cycle
};

/// Generates the code of all machines.
[[nodiscard]] Core make_core(const Generation&);
/// Returns the core file: enumerations, State, Inputs, Step and step().
[[nodiscard]] std::string core_header(const Generation&, const Core&);
/// Returns the file with the layout of State as a table, and the names of places (runtime/layout.hpp).
[[nodiscard]] std::string layout_header(const Generation&, const Core&);
/// Writes the platform as a concept. The methods are also listed in a comment. `calls` contains calls such as
/// "turn(std::declval<Real>())".
void write_platform_concept(const std::vector<std::string>& calls, CodeWriter&);
/// Returns whether the code computes with tracked numbers and has inputs that are sequences of numbers.
[[nodiscard]] bool tracks_sequences(const Generation&);
/// Returns the source that exports robochart_explore() (runtime/explore_abi.h).
[[nodiscard]] std::string shim_source(const Generation&, const Core&);

/// Returns the places in which a machine is busy while its state awaits events, and the states in which every
/// transition on an event has a condition.
[[nodiscard]] std::vector<EventPlace> event_places(const Generation&, const Core&);
/// Returns, for each event that the platform raises, in the order of Inputs, whether it can be lost while a machine is
/// busy. This is possible if the machine awaits the event and has an action that may take time.
[[nodiscard]] std::vector<bool> lost_in_actions(const Generation&, const Core&);

/// Returns the header for a traced controller. It lists the transitions by number and writes runs as logs
/// (runtime/trace.hpp, docs/traces.md).
[[nodiscard]] std::string trace_header(const Generation&, const Core&);
[[nodiscard]] std::string trace_header_name(const Generation&);

/// The following functions return the texts of the headers in cpp_emit/runtime, which are built into this program.
[[nodiscard]] std::string runtime_header();
[[nodiscard]] std::string finite_header();
[[nodiscard]] std::string tracked_header();
[[nodiscard]] std::string tracked_sequences();
[[nodiscard]] std::string deployed_header();
[[nodiscard]] std::string timer_header();
[[nodiscard]] std::string layout_helpers();
[[nodiscard]] std::string composed_header();
[[nodiscard]] std::string matrix_header();
[[nodiscard]] std::string eigen_header();
[[nodiscard]] std::string toolkit_header();
[[nodiscard]] std::string views_header();
[[nodiscard]] std::string text_header();
[[nodiscard]] std::string explore_helpers();
[[nodiscard]] std::string explore_values();
[[nodiscard]] std::string explore_header();
[[nodiscard]] std::string probes_header();
[[nodiscard]] std::string drive_header();
[[nodiscard]] std::string monitor_header();
[[nodiscard]] std::string rules_header();
[[nodiscard]] std::string trace_helpers();
[[nodiscard]] std::string trace_files();
[[nodiscard]] std::string mcap_writer();
[[nodiscard]] std::string adaptive_header();
[[nodiscard]] std::string console_choices();
[[nodiscard]] std::string console_values();

/// Writes "Generated from RoboChart ... edit the model" at the top of a file.
void file_comment(const Generation&, CodeWriter&, const std::string& what);
/// Returns the C++ namespace for a package: "a::b", or "robot" for the unnamed package.
[[nodiscard]] std::string package_namespace(const std::string& package);

}  // namespace robochart::cpp_emit
