// What a question watches along the runs of a system.
#pragma once

#include <memory>
#include <optional>

#include "checker/lts/transition_system.hpp"
#include "checker/refine/search/stability.hpp"
#include "checker/refine/search/violation.hpp"

namespace robochart::refine {

/// Nodes advance by visible events and tick; taus keep the node.
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
    /// The same answer every time.
    virtual Advance advance(Node node, process::Event event) = 0;
    /// What is wrong with a run that ends in this node and can go on like this. Of an unstable state the events come in
    /// no order; a monitor that observes states only is given one event for all.
    virtual std::optional<ViolationKind> examine(Node node, const Offer& offer) = 0;
    /// Every event keeps the one node: runs are not watched, only states are.
    [[nodiscard]] virtual bool watches_states_only() const { return false; }
    /// Whether a violation after `larger` is one after `smaller` too, by the same run or a shorter one.
    [[nodiscard]] virtual bool includes(Node /*larger*/, Node /*smaller*/) const { return false; }
    /// A monitor that gives the same answers, for use in another thread at the same time; null if there is none.
    [[nodiscard]] virtual std::unique_ptr<Monitor> another() { return nullptr; }
};

}  // namespace robochart::refine
