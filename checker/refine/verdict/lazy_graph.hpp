// SPDX-License-Identifier: Apache-2.0
// Explores a system on demand: a state gets a number and is expanded only when it is needed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "checker/lts/state_store.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/search/stability.hpp"

namespace robochart::refine {

/// The states of a system that is explored on demand. The transitions of a state are sorted by event.
class LazyGraph {
public:
    explicit LazyGraph(lts::TransitionSystem& system, Budget& budget);

    struct Edge {
        process::Event event;
        lts::StateIndex target;
    };
    lts::StateIndex initial();
    /// Returns the operands of a state that is an external choice (TransitionSystem::choice_operands).
    std::vector<lts::StateIndex> choice_operands(lts::StateIndex state);
    /// Returns the transitions of the state, ascending by event. Expands the state if necessary. The result is valid
    /// until the next call.
    std::span<const Edge> edges(lts::StateIndex state);
    /// Returns the transitions with one event. The result is valid until the next call.
    std::span<const Edge> edges(lts::StateIndex state, process::Event event);
    [[nodiscard]] Offer state_offer(lts::StateIndex state);
    /// Returns the number of states known so far.
    [[nodiscard]] std::size_t size() const { return states_.size(); }
    /// Returns the packed state with this number.
    [[nodiscard]] lts::StateView state(lts::StateIndex index) const { return states_[index]; }

private:
    struct Extent {
        std::uint64_t first = 0;
        std::uint32_t count = 0;
        bool expanded = false;
    };
    class Collector;
    lts::StateIndex number_state(lts::StateView state);
    void expand(lts::StateIndex state);

    lts::TransitionSystem& system_;
    Budget& budget_;
    lts::StateStore states_;
    std::vector<Extent> extents_;
    std::vector<Edge> edges_;
};

}  // namespace robochart::refine
