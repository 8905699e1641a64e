// SPDX-License-Identifier: Apache-2.0
// The interface between searches and processes: an initial packed state, successors, and names.
// Process terms, compiled machines, explicit graphs and generated code implement it.
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
    /// `revealed`: for tau, the event that hiding made invisible (or tau itself); otherwise equal to `event`.
    virtual void add(Event event, StateView target, Event revealed) = 0;
};

class FinerSystem;
class ReducedSystem;

/// The steps that a reduced system may follow without storing the states in between (docs/search.md, "Confluent taus").
enum class Followed {
    taus,   ///< taus; the reduced system answers every question about the process
    steps,  ///< steps with any event; the reduced system answers only whether the process can deadlock
};

/// A system that can be searched: an initial packed state, the successors of a state, names of events.
class TransitionSystem {
public:
    virtual ~TransitionSystem() = default;
    /// Number of words of every packed state; constant during the system's lifetime.
    [[nodiscard]] virtual std::size_t width() const = 0;
    virtual void initial(std::span<Word> state) = 0;
    virtual void successors(StateView state, SuccessorSink& sink) = 0;
    /// Returns another instance of the same system for use in another thread; its states are the same words. Returns
    /// null if this is not possible. Several threads may call this function at the same time; meanwhile no other
    /// function may be called.
    [[nodiscard]] virtual std::unique_ptr<TransitionSystem> clone_for_thread() const { return nullptr; }
    /// If the state is an external choice, returns its operands as states, at least two: the choice has the transitions
    /// that the rules of [] give it (checker/process/firing_rules.cpp, fire_external_choice). Empty for other states,
    /// and if the system does not know.
    [[nodiscard]] virtual std::vector<std::vector<Word>> choice_operands(StateView /*state*/) { return {}; }
    /// Names of events; systems that are compared share one table.
    [[nodiscard]] virtual const EventTable& events() const = 0;
    /// Sets the budget that long work inside the system polls. It must outlive that work; `diagnostics::unlimited` ends
    /// its use.
    virtual void set_budget(diagnostics::Pollable& /*budget*/) {}
    /// Returns the same process in a slower, independent semantics, which shares only the definitions with this system.
    /// Results of a search are replayed in it before they are reported. Null if there is none.
    [[nodiscard]] TransitionSystem* reference() const { return reference_.get(); }
    void set_reference(std::shared_ptr<TransitionSystem> reference) { reference_ = std::move(reference); }
    /// Returns the same process with fewer states. If only taus are followed, its initial state is branching bisimilar
    /// with explicit divergence to that of this system, which preserves every model. If all steps are followed, it has
    /// a state without transitions iff this system has one. The result may outlive this system. Null if no reduction
    /// is known. Polls the budget.
    [[nodiscard]] virtual std::unique_ptr<ReducedSystem> make_reduced_system(Followed /*followed*/,
                                                                             diagnostics::Pollable& /*budget*/) const;
    /// Whether the rules of the process show that it has no cycle of taus (docs/search.md, "Static proofs"). If not,
    /// it may have one or none. Polls the budget.
    [[nodiscard]] virtual bool excludes_tau_cycles(diagnostics::Pollable& /*budget*/) const { return false; }
    /// Whether the rules of the process show that no state has a tau, two transitions with the same event, or tick
    /// together with another event. If not, there may be such states or none. Polls the budget.
    [[nodiscard]] virtual bool excludes_choices(diagnostics::Pollable& /*budget*/) const { return false; }
    /// Returns a system with the same states that has all transitions on cycles of taus, but not all other transitions.
    /// Null if the rules exclude no tau. Polls the budget.
    [[nodiscard]] virtual std::unique_ptr<TransitionSystem> make_cycle_system(diagnostics::Pollable& /*budget*/) const {
        return nullptr;
    }
    /// Returns the same process before its parts were minimised, or null if that is not known or too large. It is
    /// strongly bisimilar to this system, and its transitions have the names of hidden events that the process gives
    /// them: a state of a minimised part has the names of one of the states that it represents. It is used to display
    /// runs. Polls the budget.
    [[nodiscard]] virtual std::unique_ptr<FinerSystem> make_finer_system(diagnostics::Pollable& /*budget*/) const;
    /// Returns sets of equal parts of the states that can be exchanged. Each exchange is an automorphism of the system
    /// (docs/search.md, "Symmetry"). Empty if none are known. Polls the budget.
    [[nodiscard]] virtual std::vector<ReplicaSet> replicas(diagnostics::Pollable& /*budget*/) const { return {}; }
    /// The number of states that were skipped so far because confluent taus lead from them to other states.
    [[nodiscard]] virtual std::uint64_t chased_state_count() const { return 0; }
    /// Whether a state is one word, a process::TermId.
    [[nodiscard]] virtual bool states_are_terms() const { return false; }
    /// A readable description of the state: for processes the definition of each component, with arguments.
    [[nodiscard]] virtual std::string describe(StateView state) const = 0;

private:
    std::shared_ptr<TransitionSystem> reference_;
};

/// A reduced system, in which a state that a sequence of followed steps reaches may represent an earlier state. The
/// states are those of the original system.
class ReducedSystem : public TransitionSystem {
public:
    [[nodiscard]] virtual Followed followed() const = 0;
    /// Returns the states on the path of followed steps from `state` to its representative. Empty if the state
    /// represents itself.
    [[nodiscard]] virtual std::vector<std::vector<Word>> followed_path(StateView state) = 0;
};

/// A system before its parts were minimised.
class FinerSystem : public TransitionSystem {
public:
    /// Writes the state of the minimised system to which a reachable state is strongly bisimilar.
    virtual void minimised_state(StateView state, std::span<Word> minimised) const = 0;
    /// The width of the minimised system.
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
