// SPDX-License-Identifier: Apache-2.0
// Defines the interface by which a check observes the runs of a system.
#pragma once

#include <memory>
#include <optional>

#include "checker/lts/transition_system.hpp"
#include "checker/refine/search/stability.hpp"
#include "checker/refine/search/violation.hpp"

namespace robochart::refine {

/// Observes runs by nodes: a visible event or tick leads from one node to the next. Taus do not change the node.
class Monitor {
public:
    using Node = lts::Word;
    enum class Effect { follow, ignore, violation };
    struct Advance {
        Effect effect;
        Node node = 0;
    };

    virtual ~Monitor() = default;
    virtual Node start() = 0;
    /// Returns the effect of an event in this node. All calls with the same arguments must have the same result.
    virtual Advance advance(Node node, process::Event event) = 0;
    /// Returns the fault of a run that ends in this node and can continue with this offer. If the state is unstable,
    /// the events of the offer are unsorted. If the monitor observes only states, the offer contains one event, which
    /// represents all events.
    virtual std::optional<ViolationKind> examine(Node node, const Offer& offer) = 0;
    /// Returns true if the monitor has only one node, so that it observes states and not runs.
    [[nodiscard]] virtual bool watches_states_only() const { return false; }
    /// Returns true if every violation after `larger` is also a violation after `smaller`, with a run of at most the
    /// same length.
    [[nodiscard]] virtual bool includes(Node /*larger*/, Node /*smaller*/) const { return false; }
    /// Returns a monitor with the same answers for use in another thread, or null if this is not possible.
    [[nodiscard]] virtual std::unique_ptr<Monitor> clone_for_thread() { return nullptr; }
};

}  // namespace robochart::refine
