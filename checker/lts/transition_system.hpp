// SPDX-License-Identifier: Apache-2.0
// The interface between searches and processes: an initial packed state, successors, and names.
// Process terms, compiled machines, explicit graphs and generated code implement it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

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

class ReducedSystem;

/// A system that can be searched: an initial packed state, the successors of a state, names of events.
class TransitionSystem {
public:
    virtual ~TransitionSystem() = default;
    /// Number of words of every packed state; constant during the system's lifetime.
    [[nodiscard]] virtual std::size_t width() const = 0;
    virtual void initial(std::span<Word> state) = 0;
    virtual void successors(StateView state, SuccessorSink& sink) = 0;
    /// Another instance of the same system for use in another thread; its states are the same words. Null if this is
    /// not possible. Several threads may call it at once while no other function is called.
    [[nodiscard]] virtual std::unique_ptr<TransitionSystem> another() const { return nullptr; }
    /// Names of events; systems that are compared share one table.
    [[nodiscard]] virtual const EventTable& events() const = 0;
    /// `poll` is called regularly during long work inside the system, and may throw to stop it. Empty: none.
    virtual void watch(const std::function<void()>& /*poll*/) {}
    /// The same process by a slower semantics that shares only the definitions with this one: results of a search are
    /// replayed there before they are reported. Null: none.
    [[nodiscard]] TransitionSystem* reference() const { return reference_.get(); }
    void set_reference(std::shared_ptr<TransitionSystem> reference) { reference_ = std::move(reference); }
    /// The same process with fewer states: its initial state is branching bisimilar with explicit divergence to this
    /// system's, which preserves every model. It may outlive this system. Null if no reduction is known. `poll` may
    /// throw to stop.
    [[nodiscard]] virtual std::unique_ptr<ReducedSystem> reduced(const std::function<void()>& /*poll*/) const;
    /// Equal parts of the states that can be exchanged, in sets: each exchange is an automorphism of the system
    /// (docs/search.md, "Symmetry"). Empty if none are known. `poll` may throw to stop.
    [[nodiscard]] virtual std::vector<ReplicaSet> replicas(const std::function<void()>& /*poll*/) const { return {}; }
    /// The number of states that were left out so far because a chain of taus leads on from them.
    [[nodiscard]] virtual std::uint64_t chased() const { return 0; }
    /// Whether a state is one word, a process::TermId.
    [[nodiscard]] virtual bool states_are_terms() const { return false; }
    /// A readable description of the state: for processes the definition of each component, with arguments.
    [[nodiscard]] virtual std::string describe(StateView state) const = 0;

private:
    std::shared_ptr<TransitionSystem> reference_;
};

/// A system in which some states are represented by others, which a sequence of taus reaches. The states are those of
/// the original system.
class ReducedSystem : public TransitionSystem {
public:
    /// The states after `state`, one tau after the other, up to its representative. Empty if it represents itself.
    [[nodiscard]] virtual std::vector<std::vector<Word>> chase(StateView state) = 0;
};

inline std::unique_ptr<ReducedSystem> TransitionSystem::reduced(const std::function<void()>& /*poll*/) const {
    return nullptr;
}

}  // namespace robochart::lts
