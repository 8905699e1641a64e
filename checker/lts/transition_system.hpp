// SPDX-License-Identifier: Apache-2.0
// Defines the interface between searches and processes: an initial packed state, successors, and names of events.
// Process terms, compiled machines, explicit graphs and generated code implement the interface.
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
    /// Receives one transition. `revealed`: for tau, the event that hiding made invisible (or tau itself); otherwise
    /// equal to `event`.
    virtual void add(Event event, StateView target, Event revealed) = 0;
};

class FinerSystem;
class ReducedSystem;

/// The steps that a reduced system may follow without storing the intermediate states (docs/search.md, "Confluent
/// taus").
enum class Followed {
    taus,   ///< follow taus; the reduced system answers every question about the process
    steps,  ///< follow any event; the reduced system answers only whether the process can deadlock
};

/// A system that can be searched: an initial packed state, the successors of a state, names of events.
class TransitionSystem {
public:
    virtual ~TransitionSystem() = default;
    /// Returns the number of words of every packed state; it is constant during the system's lifetime.
    [[nodiscard]] virtual std::size_t width() const = 0;
    virtual void initial(std::span<Word> state) = 0;
    virtual void successors(StateView state, SuccessorSink& sink) = 0;
    /// Returns another instance of the same system for use in another thread. Both instances represent a state by the
    /// same words. Returns null if this is not possible. Several threads may call this function at the same time. No
    /// other function may be called at the same time.
    [[nodiscard]] virtual std::unique_ptr<TransitionSystem> clone_for_thread() const { return nullptr; }
    /// If the state is an external choice, returns its operands as states, at least two. The choice has the transitions
    /// that the rules of [] give it (checker/process/firing_rules.cpp, fire_external_choice). Returns an empty list for
    /// other states, and if the system does not know the operands.
    [[nodiscard]] virtual std::vector<std::vector<Word>> choice_operands(StateView /*state*/) { return {}; }
    /// Returns the names of events. Systems that are compared share one table.
    [[nodiscard]] virtual const EventTable& events() const = 0;
    /// Sets the budget that the system polls during long work. The budget must outlive that work. To stop the polling,
    /// pass `diagnostics::unlimited`.
    virtual void set_budget(diagnostics::Pollable& /*budget*/) {}
    /// Returns the same process in a slower, independent semantics. It shares only the definitions with this system.
    /// The results of a search are replayed in this semantics before they are reported. Returns null if there is no
    /// such semantics.
    [[nodiscard]] TransitionSystem* reference() const { return reference_.get(); }
    void set_reference(std::shared_ptr<TransitionSystem> reference) { reference_ = std::move(reference); }
    /// Returns the same process with fewer states, or null if no reduction is known. If only taus are followed, the
    /// initial states of both systems are branching bisimilar with explicit divergence, so every model is preserved. If
    /// all steps are followed, the result has a state without transitions iff this system has one. The result may
    /// outlive this system. Polls the budget.
    [[nodiscard]] virtual std::unique_ptr<ReducedSystem> make_reduced_system(Followed /*followed*/,
                                                                             diagnostics::Pollable& /*budget*/) const;
    /// Returns true if the rules of the process show that it has no cycle of taus (docs/search.md, "Static proofs"). If
    /// the result is false, the process may still have no cycle of taus. Polls the budget.
    [[nodiscard]] virtual bool excludes_tau_cycles(diagnostics::Pollable& /*budget*/) const { return false; }
    /// Returns true if the rules of the process show that no state has a tau, two transitions with the same event, or
    /// tick together with another event. If the result is false, the process may still have no such state. Polls the
    /// budget.
    [[nodiscard]] virtual bool excludes_choices(diagnostics::Pollable& /*budget*/) const { return false; }
    /// Returns a system with the same states and a part of the transitions, which includes all transitions on cycles of
    /// taus. Returns null if the rules exclude no tau. Polls the budget.
    [[nodiscard]] virtual std::unique_ptr<TransitionSystem> make_cycle_system(diagnostics::Pollable& /*budget*/) const {
        return nullptr;
    }
    /// Returns the same process as it was before its parts were minimised. Returns null if that process is not known or
    /// too large. The result is strongly bisimilar to this system. It is used to display runs, because its transitions
    /// have the exact names of hidden events. In contrast, a state of a minimised part has the names of only one of the
    /// states that it represents. Polls the budget.
    [[nodiscard]] virtual std::unique_ptr<FinerSystem> make_finer_system(diagnostics::Pollable& /*budget*/) const;
    /// Returns sets of equal parts of the states that can be exchanged. Each exchange is an automorphism of the system
    /// (docs/search.md, "Symmetry"). The result is empty if no exchanges are known. Polls the budget.
    [[nodiscard]] virtual std::vector<ReplicaSet> replicas(diagnostics::Pollable& /*budget*/) const { return {}; }
    /// Returns how many states were skipped so far because confluent taus lead from them to other states.
    [[nodiscard]] virtual std::uint64_t chased_state_count() const { return 0; }
    /// Returns true if a state is one word that contains a process::TermId.
    [[nodiscard]] virtual bool states_are_terms() const { return false; }
    /// Returns a readable description of the state: for processes the definition of each component, with arguments.
    [[nodiscard]] virtual std::string describe(StateView state) const = 0;

private:
    std::shared_ptr<TransitionSystem> reference_;
};

/// A reduced system. If a sequence of followed steps leads to a state, the state may represent the states before it in
/// the sequence. All states are states of the original system.
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
    /// Writes the state of the minimised system to which a reachable state is strongly bisimilar.
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
