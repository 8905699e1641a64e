// The Markov decision process of a component: the operational semantics of its timed process, in which the steps that
// leave a probabilistic junction are the branches of one choice. Every other step, internal ones, events and tock, is a
// choice of its own.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "checker/lts/transition_system.hpp"
#include "checker/markov/model/model.hpp"
#include "csp_emit/base/emission.hpp"
#include "probability/process/exploration.hpp"
#include "probability/process/observers.hpp"
#include "probability/process/state_reader.hpp"
#include "probability/process/weights.hpp"

namespace robochart::probability {

/// Who resolves the choices.
enum class Scheduler {
    any,     ///< every way to choose
    urgent,  ///< what needs neither an input nor time comes before inputs and time: the platform takes outputs at once
    uniform  ///< all choices of a state are equally likely
};

/// The action of choices that let time pass.
inline constexpr const char* tock_action = "tock";

/// Sets of observed events are sets of bits, from that of the first on.
using EventSet = std::uint32_t;
inline constexpr std::size_t most_observed = 16;

/// The action of choices that are just these events: of none of them, "".
[[nodiscard]] std::string observed_action(EventSet events);

/// What the process is made of.
struct Sources {
    const ir::System& system;
    const ir::Instantiation& instantiation;
    const csp_emit::Provenance& provenance;
    const lts::EventTable& events;
    const std::vector<Seat>& seats;
    /// Events that rewards speak of; at most `most_observed`.
    const std::vector<ObservedEvent>& observed;
};

struct DecisionProcess {
    markov::Model model;
    markov::StateSet deadlocks;            ///< nothing is possible any more but that time passes
    std::vector<lts::StateIndex> origins;  ///< of each state, that of the exploration
    std::vector<EventSet> happening;       ///< the sets of events that are choices, each once; the empty set is one
};

/// Throws Wrong where the probabilities of a junction are no distribution.
[[nodiscard]] DecisionProcess decision_process(const Exploration&, StateReader&, const Sources&, Scheduler,
                                               const std::function<void()>& poll);

}  // namespace robochart::probability
