// SPDX-License-Identifier: Apache-2.0
// Defines the interface between searches and processes. Process terms, compiled machines, explicit graphs and generated
// code implement this interface.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/lts/event.hpp"
#include "checker/lts/symmetry.hpp"

namespace robochart::lts {

using Word = std::uint32_t;
using StateView = std::span<const Word>;

/// Receives the successors of one state, in an order that depends only on the model.
class SuccessorSink {
public:
    virtual ~SuccessorSink() = default;
    /// Receives one transition. If `event` is tau, `revealed` is the event that hiding made invisible, or tau itself.
    /// Otherwise `revealed` equals `event`.
    virtual void add(Event event, StateView target, Event revealed) = 0;
};

class FinerSystem;
class ReducedSystem;

/// The steps that a reduced system may follow without storing the states between them (docs/search.md, "Confluent
/// taus").
enum class Followed {
    taus,   ///< follow taus; the reduced system gives the same answer to every check
    steps,  ///< follow any event; the reduced system only shows whether the process can deadlock
};

/// A system that can be searched: an initial packed state, the successors of a state, names of events.
class TransitionSystem {
public:
    virtual ~TransitionSystem() = default;
    /// Returns the number of words of every packed state; it is constant during the system's lifetime.
    [[nodiscard]] virtual std::size_t width() const = 0;
    virtual void initial(std::span<Word> state) = 0;
    virtual void successors(StateView state, SuccessorSink& sink) = 0;
    /// Returns another instance of the same system for another thread. A state has the same words in both instances.
    /// Returns null if the system cannot be copied. Several threads may call this function at the same time, but no
    /// other function of the system.
    [[nodiscard]] virtual std::unique_ptr<TransitionSystem> clone_for_thread() const { return nullptr; }
    /// Returns the operands of a state that is an external choice, at least two, as states. The rules of [] give the
    /// transitions of the choice from the operands (checker/process/firing_rules.cpp, fire_external_choice). Returns an
    /// empty list for other states, and if the system does not know the operands.
    [[nodiscard]] virtual std::vector<std::vector<Word>> choice_operands(StateView /*state*/) { return {}; }
    /// Returns the names of events. Systems that are compared share one table.
    [[nodiscard]] virtual const EventTable& events() const = 0;
    /// Sets the budget that the system polls during long work. The budget must outlive that work.
    /// `diagnostics::unlimited` stops the polling.
    virtual void set_budget(diagnostics::Pollable& /*budget*/) {}
    /// Returns the same process in a slower, independent semantics, which shares only the definitions with this system.
    /// Results of a search are replayed in this semantics before they are reported. Returns null if the process has no
    /// such semantics.
    [[nodiscard]] TransitionSystem* reference() const { return reference_.get(); }
    void set_reference(std::shared_ptr<TransitionSystem> reference) { reference_ = std::move(reference); }
    /// Returns the same process with fewer states, or null if no reduction is known. Followed::taus: the initial states
    /// of both systems are branching bisimilar with explicit divergence, so every model is preserved. Followed::steps:
    /// the result has a state without transitions iff this system has one. The result may outlive this system. Polls
    /// the budget.
    [[nodiscard]] virtual std::unique_ptr<ReducedSystem> make_reduced_system(Followed /*followed*/,
                                                                             diagnostics::Pollable& /*budget*/) const;
    /// Returns true if the rules of the process prove that it has no cycle of taus (docs/search.md, "Static proofs").
    /// The result false means that there is no proof, and not that a cycle exists. Polls the budget.
    [[nodiscard]] virtual bool excludes_tau_cycles(diagnostics::Pollable& /*budget*/) const { return false; }
    /// Returns true if the rules of the process prove that no state has a tau, two transitions with the same
    /// event, or tick together with another event. The result false only means that there is no proof. Polls the
    /// budget.
    [[nodiscard]] virtual bool excludes_choices(diagnostics::Pollable& /*budget*/) const { return false; }
    /// Returns a system with the same states and fewer transitions, including all transitions that are on cycles of
    /// taus. Returns null if the rules exclude no tau from such cycles. Polls the budget.
    [[nodiscard]] virtual std::unique_ptr<TransitionSystem> make_cycle_system(diagnostics::Pollable& /*budget*/) const {
        return nullptr;
    }
    /// Returns the same process with parts that were not minimised, or null if this process is unknown or too large.
    /// The result is strongly bisimilar to this system. It is used to display runs, because its transitions have the
    /// exact names of hidden events. A state of a minimised part, in contrast, has the names of only one of the states
    /// that it represents. Polls the budget.
    [[nodiscard]] virtual std::unique_ptr<FinerSystem> make_finer_system(diagnostics::Pollable& /*budget*/) const;
    /// Returns sets of equal parts of the states. Exchanging two parts of a set is an automorphism of the system
    /// (docs/search.md, "Symmetry"). Returns an empty list if no such parts are known. Polls the budget.
    [[nodiscard]] virtual std::vector<ReplicaSet> replicas(diagnostics::Pollable& /*budget*/) const { return {}; }
    /// Returns the number of states that were skipped so far by following confluent taus.
    [[nodiscard]] virtual std::uint64_t chased_state_count() const { return 0; }
    /// Returns true if a state is one word that contains a process::TermId.
    [[nodiscard]] virtual bool states_are_terms() const { return false; }
    /// Returns a readable description of the state: for processes the definition of each component, with arguments.
    [[nodiscard]] virtual std::string describe(StateView state) const = 0;

private:
    std::shared_ptr<TransitionSystem> reference_;
};

/// A reduced system. If it follows steps from one state to another, the second state may represent the first state and
/// all states between the two. All states of a reduced system are states of the original system.
class ReducedSystem : public TransitionSystem {
public:
    [[nodiscard]] virtual Followed followed() const = 0;
    /// Returns the states on the path of followed steps from `state` to its representative. The result is empty if the
    /// state represents itself.
    [[nodiscard]] virtual std::vector<std::vector<Word>> followed_path(StateView state) = 0;
};

/// A system before its parts were minimised.
class FinerSystem : public TransitionSystem {
public:
    /// Writes the state of the minimised system that is strongly bisimilar to `state`. `state` must be reachable.
    virtual void minimised_state(StateView state, std::span<Word> minimised) const = 0;
    /// Returns the width of the minimised system.
    [[nodiscard]] virtual std::size_t minimised_width() const = 0;
};

inline std::unique_ptr<FinerSystem> TransitionSystem::make_finer_system(diagnostics::Pollable& /*budget*/) const {
    return nullptr;
}

inline std::unique_ptr<ReducedSystem> TransitionSystem::make_reduced_system(Followed /*followed*/,
                                                                            diagnostics::Pollable& /*budget*/) const {
    return nullptr;
}

}  // namespace robochart::lts
