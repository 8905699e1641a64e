// SPDX-License-Identifier: Apache-2.0
// The Markov decision process of a component: the operational semantics of its timed process, in which the steps that
// leave a probabilistic junction are the branches of one choice. Every other step (internal, event or tock) is a
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

/// The scheduler that resolves choices.
enum class Scheduler {
    any,     ///< all possible schedulers
    urgent,  ///< steps that need neither an input nor time have priority, because the platform accepts outputs at once
    uniform  ///< all choices of a state are equally likely
};

/// The action of choices that let time pass.
inline constexpr const char* tock_action = "tock";

/// A set of observed events as a bit set, lowest bit first.
using EventSet = std::uint32_t;
inline constexpr std::size_t most_observed = 16;

/// The action of choices with exactly these events; "" for no event.
[[nodiscard]] std::string observed_action(EventSet events);

/// The input of the construction.
struct Sources {
    const ir::System& system;
    const ir::Instantiation& instantiation;
    const csp_emit::Provenance& provenance;
    const lts::EventTable& events;
    const std::vector<Seat>& seats;
    /// Events to which rewards refer; at most `most_observed`.
    const std::vector<ObservedEvent>& observed;
};

struct DecisionProcess {
    markov::Model model;
    markov::StateSet deadlocks;            ///< only time can pass
    std::vector<lts::StateIndex> origins;  ///< for each state, its state in the exploration
    std::vector<EventSet> happening;  ///< the sets of events of choices, without duplicates; contains the empty set
};

/// Throws Wrong if the probabilities of a junction are not a distribution.
[[nodiscard]] DecisionProcess decision_process(const Exploration&, StateReader&, const Sources&, Scheduler,
                                               diagnostics::Pollable& budget);

}  // namespace robochart::probability
