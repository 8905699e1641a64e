// A scenario bound to a controller: which input each feed fills, what each output drives.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cpp_emit/simulator_api.hpp"
#include "simulation/scenario/scenario.hpp"

namespace robochart::simulation {

inline constexpr std::uint32_t no_slot = 0xffffffffU;

/// A feed with places instead of names.
struct BoundFeed {
    const Feed* feed = nullptr;
    std::uint32_t input = 0;
    std::uint32_t sensor = no_slot;    ///< in Scenario::sensors; none: the drive
    std::uint32_t request = no_slot;   ///< bit that the operation sets
    std::uint32_t variable = no_slot;  ///< slot of the argument; none: the literal
};

/// What an output of the controller does, one after the other.
struct Effect {
    enum class Kind { store, request, drive };
    Kind kind = Kind::store;
    bool whole = false;      ///< store: of a whole number
    std::uint32_t slot = 0;  ///< of the variable, the bit, or the place in Scenario::drives
};

struct BoundStimulus {
    const Stimulus* stimulus = nullptr;
    std::uint32_t input = 0;
    bool real = false;
    double value = 0;       ///< a number; truth values: 0, 1; literals: the place in their enumeration
    bool argument = false;  ///< raised by the environment: the value is the argument of its command
};

struct BoundSpeeds {
    const Drive* drive = nullptr;
    std::uint32_t linear = 0;  ///< slots
    std::uint32_t angular = 0;
};

struct BoundWorldFeed {
    const WorldFeed* feed = nullptr;
    std::uint32_t number = 0;  ///< in Environment::feeds
    std::uint32_t input = 0;
    bool boolean = false;  ///< of a condition: its truth value; else it is there while it holds
};

/// What a command of the environment does.
struct BoundAct {
    const WorldAct* act = nullptr;
    std::vector<std::optional<BoundStimulus>> raised;  ///< stimulus: of each kind of robots that has the event
};

/// The environment's controller.
struct WorldPlan {
    std::uint32_t inputs = 0;
    std::vector<BoundWorldFeed> feeds;
    std::vector<std::vector<BoundAct>> acts;  ///< of each output
};

/// Of the first kind of robots; the others beside it.
struct Plan {
    const Scenario* scenario = nullptr;
    std::uint32_t inputs = 0;
    std::vector<BoundFeed> feeds;
    std::vector<BoundStimulus> stimuli;
    std::vector<std::vector<Effect>> effects;  ///< of each output
    std::vector<double> variables;             ///< initial values of the slots
    std::vector<std::uint32_t> messages;       ///< of each sensor: the slot that robots send, or `no_slot`
    std::optional<BoundSpeeds> speeds;         ///< the drive follows two variables
    std::uint32_t requests = 0;
    std::vector<Plan> others;  ///< of each kind in Scenario::others; they have none themselves
    std::optional<WorldPlan> environment;

    [[nodiscard]] const Plan& of_kind(std::size_t kind) const { return kind == 0 ? *this : others[kind - 1]; }
};

/// What a scenario is bound to: the controllers of its kinds of robots in their order, and that of its environment.
struct Emissions {
    std::vector<const cpp_emit::DriveEmission*> kinds;
    const cpp_emit::DriveEmission* environment = nullptr;  ///< null: there is none
};

/// Binds; what does not fit is reported. The plan refers to the scenario.
[[nodiscard]] Plan bind(const Scenario&, const Emissions&, diagnostics::Diagnostics&);
/// Of a scenario with one kind of robots and nothing else.
[[nodiscard]] Plan bind(const Scenario&, const cpp_emit::DriveEmission&, diagnostics::Diagnostics&);

}  // namespace robochart::simulation
