// SPDX-License-Identifier: Apache-2.0
// Component machines are the explicit leaves of a compiled process. FDR calls them low-level machines (Gibson-Robinson
// et al., "FDR3: a parallel refinement checker for CSP", STTT 2016, section 3).
#pragma once

#include <cassert>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "checker/process/operational_semantics.hpp"

namespace robochart::machine {

using process::Event;
using process::EventSet;
using process::TermId;

/// A state of one component. The state `size()` is "off": the component has not started, or it has ended.
using Local = std::uint32_t;

/// An explicit machine. Edges refer to events by their index in the alphabet. State 0 is the initial state.
class Component {
public:
    struct Edge {
        std::uint32_t event;  ///< index in the alphabet
        Event revealed;       ///< for tau: the event that was hidden, or tau itself; otherwise the event
        Local target;
    };
    using Edges = std::span<const Edge>;

    /// An edge of a machine that is being built. Unlike Edge, it contains the event itself.
    struct RawEdge {
        Event event;
        Event revealed;
        Local target;
    };
    /// `rows` contains the edges of each state, ordered by event. `meaning` contains a term for each state.
    Component(const std::vector<std::vector<RawEdge>>& rows, std::vector<TermId> meaning);

    [[nodiscard]] std::size_t size() const { return meaning_.size(); }
    [[nodiscard]] std::size_t edge_count() const { return edges_.size(); }
    /// Returns all events on edges, ascending, including tau and tick.
    [[nodiscard]] const EventSet& alphabet() const { return alphabet_; }
    [[nodiscard]] TermId term_of(Local state) const {
        assert(state < meaning_.size());
        return meaning_[state];
    }
    /// Returns all edges of a state, ordered by event; none if the component is off.
    [[nodiscard]] Edges edges(Local state) const {
        if (state >= meaning_.size()) return {};
        return Edges(edges_).subspan(first_[state], first_[state + 1U] - first_[state]);
    }
    /// Returns the edges of a state that have this event.
    [[nodiscard]] Edges edges(Local state, std::uint32_t event) const;

private:
    void index();

    EventSet alphabet_;
    std::vector<TermId> meaning_;
    std::vector<std::uint32_t> first_;
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> by_event_;  // index: state * (alphabet + 1) + event; not built if it would be large
};

using ComponentPtr = std::shared_ptr<const Component>;

}  // namespace robochart::machine
