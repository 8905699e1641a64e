// The files of an emission, one function each.
#pragma once

#include <string>

#include "cpp_emit/expressions/generation.hpp"
#include "cpp_emit/machine/machine_code.hpp"

namespace robochart::cpp_emit {

/// What the core's text consists of, shared by the files that use it.
struct Core {
    std::string name_space;              ///< "aggregation::AggregationFSM_core"
    std::string relative;                ///< the same as seen from the package's namespace
    std::string header;                  ///< file name
    std::vector<MachineCode> machines;   ///< as Component::units
    FrameLayout layout;                  ///< of State
    std::vector<const EventPort*> kept;  ///< Fault::event_kept: inputs that outlive the cycle
};

/// Generates the machines' code.
[[nodiscard]] Core make_core(const Generation&);
/// The core: enumerations, State, Inputs, Step and step().
[[nodiscard]] std::string core_header(const Generation&, const Core&);
/// The layout of State as a table, and names of its places (runtime/layout.hpp).
[[nodiscard]] std::string layout_header(const Generation&, const Core&);
/// The concept behind the comment that lists the platform's methods; calls like "turn(std::declval<Real>())".
void write_platform_concept(const std::vector<std::string>& calls, CodeWriter&);
/// The source that exports robochart_explore() (runtime/explore_abi.h).
[[nodiscard]] std::string shim_source(const Generation&, const Core&);

/// Where machines are busy on behalf of a state that awaits events, or rest while every transition on an event has a
/// condition.
[[nodiscard]] std::vector<EventPlace> event_places(const Generation&, const Core&);
/// Of the events that the platform raises, in the order of Inputs, which are awaited where a machine is busy, in
/// machines some action of which may take time.
[[nodiscard]] std::vector<bool> lost_in_actions(const Generation&, const Core&);

/// What a traced controller needs: its transitions by number, its runs as logs (runtime/trace.hpp, docs/traces.md).
[[nodiscard]] std::string trace_header(const Generation&, const Core&);
[[nodiscard]] std::string trace_header_name(const Generation&);

/// Texts of the headers in cpp_emit/runtime, built into the program.
[[nodiscard]] std::string runtime_header();
[[nodiscard]] std::string finite_header();
[[nodiscard]] std::string timer_header();
[[nodiscard]] std::string layout_helpers();
[[nodiscard]] std::string composed_header();
[[nodiscard]] std::string matrix_header();
[[nodiscard]] std::string eigen_header();
[[nodiscard]] std::string toolkit_header();
[[nodiscard]] std::string text_header();
[[nodiscard]] std::string explore_helpers();
[[nodiscard]] std::string explore_values();
[[nodiscard]] std::string explore_header();
[[nodiscard]] std::string drive_header();
[[nodiscard]] std::string monitor_header();
[[nodiscard]] std::string rules_header();
[[nodiscard]] std::string trace_helpers();
[[nodiscard]] std::string trace_files();
[[nodiscard]] std::string adaptive_header();
[[nodiscard]] std::string console_choices();
[[nodiscard]] std::string console_values();

/// "Generated from RoboChart ... edit the model" for the top of a file.
void file_comment(const Generation&, CodeWriter&, const std::string& what);
/// The C++ namespace of a package: "a::b", or "robot" without one.
[[nodiscard]] std::string package_namespace(const std::string& package);

}  // namespace robochart::cpp_emit
