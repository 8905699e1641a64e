// SPDX-License-Identifier: Apache-2.0
// Declares the options of a generation, and its result.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "base/durations/time_unit.hpp"
#include "cpp_emit/plan/fault.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

namespace ros2 {
struct Mapping;
}

/// A file to be written: its path relative to the output folder, and its text.
struct OutputFile {
    std::string path;
    std::string text;
    bool keep = false;  ///< the user may edit it, so an existing file is not overwritten
};

/// What the generator writes: the classes with everything that the conformance check needs, or a complete project that
/// can be built.
enum class Target {
    sources,  ///< the classes, the exploration interface, a console driver
    library,  ///< a CMake library that can be installed
    main,     ///< a console program
    ros2,     ///< a package with a node
    enki,     ///< e-pucks in Enki
    argos,    ///< a controller of ARGoS
    python,   ///< a module of Python
};

/// How `dispatch` finds the effect of an event, for a machine whose programs never wait.
enum class Strategy {
    automatic,      ///< chosen by the number of states in which the machine rests
    nested_switch,  ///< switch over the state, then over the event
    table,          ///< a dense table of cases, one switch over them
};

/// The greatest capacity of a list that an option can set.
inline constexpr std::uint32_t greatest_capacity = 65'536;

/// The data about a ROS 2 package in its manifest.
struct PackageFacts {
    std::string version = "0.1.0";
    std::string license;  ///< SPDX expression; "": not declared
    std::string maintainer = "the robot's maintainer";
    std::string email = "maintainer@example.org";
};

/// The order of events in a cycle, as claims files declare it (docs/claims.md, "Order in a cycle").
struct EventOrder {
    /// Two events that the platform raises: in a cycle with `event`, `dropped` is not raised. The names are those at
    /// the boundary. The numbers are indices among the events that the component receives (exploration_registers).
    struct Drop {
        std::string event, dropped;
        std::uint32_t event_input = 0, dropped_input = 0;
    };
    /// For each machine, by its number: the events whose transitions it tries before all others, in this order.
    std::map<std::uint32_t, std::vector<ir::EventId>> first = {};
    std::vector<Drop> drops = {};
};

/// When a node of ROS 2 begins a cycle.
enum class Dispatch {
    timer,      ///< when the time of a cycle has passed
    immediate,  ///< also when an input arrives; only for components that count no time
};

/// The options of a generation.
struct Options {
    Target target = Target::sources;
    Strategy strategy = Strategy::automatic;
    Fault fault = Fault::none;
    std::uint32_t fault_site = 0;  ///< the place (transition, call, … in textual order) that contains the fault, among
                                   ///< those to which it applies
    std::uint32_t cycle_length = 1;  ///< number of time units between two control cycles
    /// What the code does if the model leaves a choice between transitions or in a wait. If true, the code asks its
    /// platform (`pick`). If false, the code takes the first alternative and contains no call.
    bool choices = false;
    /// The capacities of lists in deployed code, by the name of an event or variable; 1 to greatest_capacity.
    std::map<std::string, std::size_t> capacities = {};
    /// Whether the exploration interface is required. If true, a component with more values than the interface's tables
    /// can contain is rejected (RC-G13). If false, the interface is then omitted, with a note (RC-G15).
    bool explored = true;
    /// The number of units in one real, if the code for exploration computes with tracked numbers
    /// (runtime/tracked.hpp). 0 if it computes with finite carriers.
    std::int64_t tracked_scale = 0;
    /// With tracked numbers: the length of the longest sequence with which the deployed code is run.
    std::size_t tracked_length = 0;
    /// For Target::ros2: the messages for the component's boundary (cpp_emit/ros2/mapping.hpp). If null, messages of
    /// std_msgs are used.
    const ros2::Mapping* mapping = nullptr;
    PackageFacts package = {};
    bool mapping_draft = false;  ///< Target::ros2: the only file is a mapping to start from
    durations::Unit unit = {};   ///< Target::ros2: the length of a time unit, if it is declared
    EventOrder order = {};
    bool model_names = false;  ///< Target::ros2: nodes, topics and files have the names of the model, not snake_case
    Dispatch dispatch = Dispatch::timer;  ///< Target::ros2
    /// Provides file and line for comments. If null, comments contain only the names of the model's elements.
    const diagnostics::SourceManager* sources = nullptr;
};

/// Returns whether the cycle has no seeded fault.
[[nodiscard]] constexpr bool faultless_cycle(const Options& options) {
    return options.fault == Fault::none || in_event_api(options.fault);
}

/// A place of a machine in which it may miss an event that it uses, or take it late.
struct EventPlace {
    std::string member;             ///< the member as it is printed: "state", "stm0.state"
    std::string place;              ///< the place as it is printed: "enter_A_1"
    std::string element;            ///< description: "enters Busy::A (busy.rct:7)"
    bool busy = false;              ///< whether an action is in progress; otherwise the machine rests
    std::vector<bool> events = {};  ///< for each event that the platform raises, in the order of Inputs: whether it is
                                    ///< concerned
    /// For each of these events, the level of the state with the innermost transition for it. Level 0 is the state in
    /// which the machine rests, 1 is its parent, and so on. The level is no_level if there is no such transition or an
    /// action is in progress.
    std::vector<std::uint32_t> level = {};
    static constexpr std::uint32_t no_level = UINT32_MAX;
};

/// The generated code of one component.
struct Emission {
    std::vector<OutputFile> files;  ///< headers, sources, CMakeLists.txt, the runtime headers
    std::string
        shim;  ///< path of the source that exports the exploration interface (runtime/explore_abi.h); "" if none
    std::vector<std::string> sources;      ///< paths of the sources that are compiled with it
    std::vector<std::string> sized_names;  ///< the names in Options::capacities that the component has
    std::uint32_t fault_sites = 0;         ///< number of places to which the requested fault applies
    std::vector<EventPlace> event_places;
};

}  // namespace robochart::cpp_emit
