// What is to be generated, and how; what was.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cpp_emit/plan/fault.hpp"
#include "diagnostics/diagnostic.hpp"

namespace robochart::cpp_emit {

namespace ros2 {
struct Mapping;
}

/// A file to be written: path relative to the output folder, and its text.
struct OutputFile {
    std::string path;
    std::string text;
    bool keep = false;  ///< its reader's to change: not written where it is there
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

/// How a machine whose programs never wait finds what an event does (dispatch).
enum class Strategy {
    automatic,      ///< by the number of states in which it rests
    nested_switch,  ///< by state, then by event
    table,          ///< a dense table of cases, one switch over them
};

/// What is generated, and how.
struct Options {
    Target target = Target::sources;
    Strategy strategy = Strategy::automatic;
    Fault fault = Fault::none;
    std::uint32_t fault_site = 0;  ///< which applicable place (transition, call, … in textual order) carries the fault
    std::uint32_t cycle_length = 1;  ///< time units that pass between two control cycles
    /// Where the model leaves a choice between transitions or of a wait, the code asks its platform (`pick`); else it
    /// takes the first, without a place to ask at.
    bool choices = false;
    /// The exploration interface is needed: what has more values than its tables take is refused (RC-G13). Else the
    /// interface is left out then, with a note (RC-G15).
    bool explored = true;
    /// Target::ros2: which messages carry what the component shows (cpp_emit/ros2/mapping.hpp); null: those of
    /// std_msgs.
    const ros2::Mapping* mapping = nullptr;
    /// For comments with file and line; null: comments name the model's elements only.
    const diagnostics::SourceManager* sources = nullptr;
};

/// What a cycle does is as it should be.
[[nodiscard]] constexpr bool faultless_cycle(const Options& options) {
    return options.fault == Fault::none || in_event_api(options.fault);
}

/// A place of a machine in which it may fail to take an event that it knows, or takes it late.
struct EventPlace {
    std::string member;             ///< as the state is printed: "state", "stm0.state"
    std::string place;              ///< as the place is printed: "enter_A_1"
    std::string element;            ///< for people: "enters Busy::A (busy.rct:7)"
    bool busy = false;              ///< an action is in progress; else the machine rests
    std::vector<bool> events = {};  ///< of the events that the platform raises, in the order of Inputs, which of them
    /// For each of these events how far outside the state is that has the innermost transition for it: 0 is the state
    /// where the machine rests, 1 the one around it; no_level if none has one or an action is in progress.
    std::vector<std::uint32_t> level = {};
    static constexpr std::uint32_t no_level = UINT32_MAX;
};

/// What was generated for one component.
struct Emission {
    std::vector<OutputFile> files;  ///< headers, sources, CMakeLists.txt, the runtime headers
    std::string
        shim;  ///< path of the source that exports the exploration interface (runtime/explore_abi.h); "" if none
    std::vector<std::string> sources;  ///< paths of the sources to compile with it
    std::uint32_t fault_sites = 0;     ///< how many places the requested fault applies to
    std::vector<EventPlace> event_places;
};

}  // namespace robochart::cpp_emit
