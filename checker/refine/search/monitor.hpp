// SPDX-License-Identifier: Apache-2.0
// What a check observes along the runs of a system.
#pragma once

#include <memory>
#include <optional>

#include "checker/lts/transition_system.hpp"
#include "checker/refine/search/stability.hpp"
#include "checker/refine/search/violation.hpp"

namespace robochart::refine {

/// Nodes advance by visible events and tick; taus do not change the node.
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
    /// Must return the same answer every time.
    virtual Advance advance(Node node, process::Event event) = 0;
    /// The fault of a run that ends in this node and can continue with this offer. For an unstable state, the events
    /// are unsorted; a monitor that observes only states gets one event for all.
    virtual std::optional<ViolationKind> examine(Node node, const Offer& offer) = 0;
    /// Whether there is a single node that every event keeps: only states are observed, not runs.
    [[nodiscard]] virtual bool watches_states_only() const { return false; }
    /// Whether every violation after `larger` is one after `smaller` too, by the same run or a shorter one.
    [[nodiscard]] virtual bool includes(Node /*larger*/, Node /*smaller*/) const { return false; }
    /// A monitor with the same answers for use in another thread; null if there is none.
    [[nodiscard]] virtual std::unique_ptr<Monitor> another() { return nullptr; }
};

}  // namespace robochart::refine
