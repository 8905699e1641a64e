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

/// Receives the successors of one state, in an order that depends on the model alone.
class SuccessorSink {
public:
    virtual ~SuccessorSink() = default;
    /// `revealed`: for tau, the event that hiding made invisible (or tau itself); else equal to `event`.
    virtual void add(Event event, StateView target, Event revealed) = 0;
};

class ReducedSystem;

/// What can be searched: an initial packed state, the successors of a state, names of events.
class TransitionSystem {
public:
    virtual ~TransitionSystem() = default;
    /// Words of every packed state; fixed for the system's life.
    [[nodiscard]] virtual std::size_t width() const = 0;
    virtual void initial(std::span<Word> state) = 0;
    virtual void successors(StateView state, SuccessorSink& sink) = 0;
    /// The same system once more, for use in another thread at the same time; its states are the same words. Null where
    /// that is not possible. Several threads may ask at once, while nothing else is asked.
    [[nodiscard]] virtual std::unique_ptr<TransitionSystem> another() const { return nullptr; }
    /// Names of events; systems that are compared share one table.
    [[nodiscard]] virtual const EventTable& events() const = 0;
    /// `poll` is called now and then during long work inside the system, and may throw to stop it. Empty: none.
    virtual void watch(const std::function<void()>& /*poll*/) {}
    /// The same process by a slower semantics that shares nothing with this one but the definitions: what a search
    /// finds here is replayed there before it is believed. Null: none.
    [[nodiscard]] TransitionSystem* reference() const { return reference_.get(); }
    void set_reference(std::shared_ptr<TransitionSystem> reference) { reference_ = std::move(reference); }
    /// The same process with fewer states: its initial state is equal to this one's by branching bisimilarity with
    /// explicit divergence, which keeps every model. It may outlive this system. Null where no way is known. `poll` may
    /// throw to stop.
    [[nodiscard]] virtual std::unique_ptr<ReducedSystem> reduced(const std::function<void()>& /*poll*/) const;
    /// Equal parts of the states that can be exchanged, in sets: each exchange is an automorphism of the system
    /// (docs/search.md, "Symmetry"). Empty where none are known. `poll` may throw to stop.
    [[nodiscard]] virtual std::vector<ReplicaSet> replicas(const std::function<void()>& /*poll*/) const { return {}; }
    /// How many states the successors of all states so far were led on from.
    [[nodiscard]] virtual std::uint64_t chased() const { return 0; }
    /// Whether a state is one word, a process::TermId.
    [[nodiscard]] virtual bool states_are_terms() const { return false; }
    /// The state as people read it: for processes the definitions each component is in, with arguments.
    [[nodiscard]] virtual std::string describe(StateView state) const = 0;

private:
    std::shared_ptr<TransitionSystem> reference_;
};

/// A system of which other states stand for some states, which a row of taus leads to. The states are the system's own.
class ReducedSystem : public TransitionSystem {
public:
    /// The states after `state`, one tau after the other, up to the one that stands for it. Empty if it does so itself.
    [[nodiscard]] virtual std::vector<std::vector<Word>> chase(StateView state) = 0;
};

inline std::unique_ptr<ReducedSystem> TransitionSystem::reduced(const std::function<void()>& /*poll*/) const {
    return nullptr;
}

}  // namespace robochart::lts
