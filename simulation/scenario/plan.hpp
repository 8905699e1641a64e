// SPDX-License-Identifier: Apache-2.0
// Binds a scenario to its controllers: the plan contains the input that each feed fills, and the effects of each
// output.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cpp_emit/simulator_api.hpp"
#include "simulation/scenario/scenario.hpp"

namespace robochart::simulation {

inline constexpr std::uint32_t no_slot = 0xffffffffU;

/// A feed with indices instead of names.
struct BoundFeed {
    const Feed* feed = nullptr;
    std::uint32_t input = 0;
    std::uint32_t sensor = no_slot;    ///< index in Scenario::sensors; `no_slot`: the drive
    std::uint32_t request = no_slot;   ///< the bit that the operation sets
    std::uint32_t variable = no_slot;  ///< slot of the argument; `no_slot`: the literal is used
};

/// One effect of an output of the controller; effects are executed in order.
struct Effect {
    enum class Kind { store, request, drive };
    Kind kind = Kind::store;
    bool whole = false;      ///< for `store`: the value is a whole number
    std::uint32_t slot = 0;  ///< the slot of the variable, the bit, or the index in Scenario::drives
};

struct BoundStimulus {
    const Stimulus* stimulus = nullptr;
    std::uint32_t input = 0;
    bool real = false;
    double value = 0;       ///< a number, a truth value (0 or 1), or the index of a literal in its enumeration
    bool argument = false;  ///< if the environment raises it: the value is the argument of the command
};

struct BoundSpeeds {
    const Drive* drive = nullptr;
    std::uint32_t linear = 0;  ///< slots
    std::uint32_t angular = 0;
};

struct BoundWorldFeed {
    const WorldFeed* feed = nullptr;
    std::uint32_t number = 0;  ///< index in Environment::feeds
    std::uint32_t input = 0;
    bool boolean = false;  ///< condition: send its truth value; false: the event is present while it is true
};

/// The effect of a command of the environment.
struct BoundAct {
    const WorldAct* act = nullptr;
    std::vector<std::optional<BoundStimulus>> raised;  ///< stimulus: by kind; no value for kinds without the event
};

/// The plan of the environment's controller.
struct WorldPlan {
    std::uint32_t inputs = 0;
    std::vector<BoundWorldFeed> feeds;
    std::vector<std::vector<BoundAct>> acts;  ///< the effects of each output
};

/// The plan of the first kind of robots, with the plans of the other kinds.
struct Plan {
    const Scenario* scenario = nullptr;
    std::uint32_t inputs = 0;
    std::vector<BoundFeed> feeds;
    std::vector<BoundStimulus> stimuli;
    std::vector<std::vector<Effect>> effects;  ///< by output of the controller
    std::vector<double> variables;             ///< initial values of the slots
    std::vector<std::uint32_t> messages;       ///< the slot that robots send for each sensor, or `no_slot`
    std::optional<BoundSpeeds> speeds;         ///< set if the drive follows two variables
    std::uint32_t requests = 0;
    std::vector<Plan> others;  ///< plans of the kinds in Scenario::others; empty in these plans
    std::optional<WorldPlan> environment;

    [[nodiscard]] const Plan& of_kind(std::size_t kind) const { return kind == 0 ? *this : others[kind - 1]; }
};

/// The controllers to which a scenario is bound: those of its kinds of robots, in the order of the kinds, and that of
/// its environment.
struct Emissions {
    std::vector<const cpp_emit::DriveEmission*> kinds;
    const cpp_emit::DriveEmission* environment = nullptr;  ///< null: no environment
};

/// Binds the scenario and reports mismatches. The plan refers to the scenario.
[[nodiscard]] Plan bind_scenario(const Scenario&, const Emissions&, diagnostics::Diagnostics&);
/// Binds a scenario with one kind of robots and no environment.
[[nodiscard]] Plan bind_scenario(const Scenario&, const cpp_emit::DriveEmission&, diagnostics::Diagnostics&);

}  // namespace robochart::simulation
