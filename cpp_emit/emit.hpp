// From the shared IR to C++ controllers: the founding paper's class mapping (Li et al., 2017) over a lean core of
// value-type state and a step function that runs to quiescence. Independent of the CSP semantics.
#pragma once

#include <string>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "semantics/instantiation.hpp"
#include "semantics/ir.hpp"

namespace robochart::cpp_emit {

/// A file to be written: path relative to the output folder, and its text.
struct OutputFile {
    std::string path;
    std::string text;
    bool keep = false;  ///< its reader's to change: not written where it is there
};

/// Seeded faults of the generator, for testing the conformance checker (conformance/mutants). `none` in production.
enum class Fault {
    none,
    guard_after_consume,     ///< event eaten under a false guard
    children_not_exited,     ///< leaving a composite does not exit its children
    composite_resumed,       ///< re-entered composite continues where it was
    input_not_awaited,       ///< input in an action read without waiting for the event
    single_transition_step,  ///< one transition per cycle instead of running to quiescence
    guard_negated,
    guard_dropped,
    clock_not_reset,
    clock_off_by_one,  ///< clock counts from 1 after a reset
    wrong_target,
    action_dropped,
    entry_dropped,
    exit_dropped,
    argument_swapped,  ///< first two arguments of calls exchanged
    assignment_dropped,
    event_kept,  ///< inputs survive the end of the cycle
    wait_dropped,
    trigger_value_old,  ///< guard reads the variable's old value, not the incoming one
    output_repeated,    ///< an output is made twice in one cycle
    send_not_awaited,   ///< the sender goes on without the receiver
    offer_kept,         ///< what was received is offered again
    buffer_kept,        ///< reading does not empty the buffer
    buffer_first,       ///< the buffer keeps its first value
    ended_by_one,       ///< one machine's end ends the component
    write_not_relayed,  ///< other machines do not see a write
    deadline_kept,      ///< a deadline that was met goes on
};

/// What is emitted: the classes with everything that the conformance check needs, or a project that builds as it
/// stands.
enum class Target {
    sources,  ///< the classes, the exploration interface, a console driver
    library,  ///< a CMake library to install
    main,     ///< a console program
    ros2,     ///< a package with a node
    enki,     ///< e-pucks in Enki
    argos,    ///< a controller of ARGoS
};

struct Options {
    Target target = Target::sources;
    Fault fault = Fault::none;
    std::uint32_t fault_site = 0;  ///< which applicable place (transition, call, … in textual order) carries the fault
    std::uint32_t cycle_length = 1;  ///< time units that pass between two control cycles
    /// For comments with file and line; null: comments name the model's elements only.
    const diagnostics::SourceManager* sources = nullptr;
};

struct Emission {
    std::vector<OutputFile> files;  ///< headers, sources, CMakeLists.txt, the runtime headers
    std::string
        shim;  ///< path of the source that exports the exploration interface (runtime/explore_abi.h); "" if none
    std::vector<std::string> sources;  ///< paths of the sources to compile with it
    std::uint32_t fault_sites = 0;     ///< how many places the requested fault applies to
};

/// Emits the controller of one state machine, controller or module. `component` is the path as in
/// ir::ComponentRef ("AggregationFSM", "AggregationModule"). What cannot be generated is refused by name.
[[nodiscard]] Emission emit(const ir::System&, const ir::Instantiation&, const ir::ComponentRef& component,
                            const Options&, diagnostics::Diagnostics&);

/// All headers that generated code may include, below robochart/.
[[nodiscard]] std::vector<OutputFile> shipped_headers();

}  // namespace robochart::cpp_emit
