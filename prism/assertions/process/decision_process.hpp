// SPDX-License-Identifier: Apache-2.0
// Builds the Markov decision process of a component from the operational semantics of its timed process. The steps that
// leave a probabilistic junction become the branches of one choice. Every other step (internal, event or tock) is a
// separate choice.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/lts/transition_system.hpp"
#include "csp_emit/base/emission.hpp"
#include "prism/assertions/process/exploration.hpp"
#include "prism/assertions/process/observers.hpp"
#include "prism/assertions/process/state_reader.hpp"
#include "prism/assertions/process/weights.hpp"
#include "prism/markov/model/model.hpp"

namespace robochart::probability {

/// How the choices are resolved.
enum class Scheduler {
    any,     ///< all possible schedulers
    urgent,  ///< if the platform accepts outputs at once: steps that need no input and no time have priority
    uniform  ///< all choices of a state are equally likely
};

/// The action of choices that let time pass.
inline constexpr const char* tock_action = "tock";

/// A set of observed events as a bit set, lowest bit first.
using EventSet = std::uint32_t;
inline constexpr std::size_t most_observed = 16;

/// Returns the action of choices with exactly these events, or "" if there are none.
[[nodiscard]] std::string observed_action(EventSet events);

/// The input of the construction.
struct Sources {
    const ir::System& system;
    const ir::Instantiation& instantiation;
    const csp_emit::Provenance& provenance;
    const lts::EventTable& events;
    const std::vector<Seat>& seats;
    /// The events that rewards refer to; at most `most_observed`.
    const std::vector<ObservedEvent>& observed;
};

struct DecisionProcess {
    markov::Model model;
    markov::StateSet deadlocks;            ///< states in which only time can pass
    std::vector<lts::StateIndex> origins;  ///< for each state, its state in the exploration
    std::vector<EventSet> happening;  ///< the sets of events of choices, without duplicates; contains the empty set
};

/// Throws Wrong if the probabilities of a junction are not a distribution.
[[nodiscard]] DecisionProcess decision_process(const Exploration&, StateReader&, const Sources&, Scheduler,
                                               diagnostics::Pollable& budget);

}  // namespace robochart::probability
