// SPDX-License-Identifier: Apache-2.0
// Computes the reachable states by saturation (Ciardo, Luettgen and Siminiceanu, "Saturation: an efficient iteration
// strategy for symbolic state-space generation", TACAS 2001). A node is saturated if no step that depends only on its
// level and lower levels adds a tuple to its set. Nodes are saturated from the lowest level up. A step is fired at its
// highest level. The nodes that it creates below this level are saturated immediately.
#pragma once

#include <deque>
#include <vector>

#include "checker/symbolic/relations.hpp"

namespace robochart::symbolic {

class Saturation {
public:
    /// The computation polls the budget.
    Saturation(const Relations& relations, const std::vector<Step>& steps, Diagrams& diagrams,
               diagnostics::Pollable& budget);
    ~Saturation() { diagrams_.set_users({}); }
    Saturation(const Saturation&) = delete;
    Saturation& operator=(const Saturation&) = delete;

    /// Returns the states that the steps reach from the initial state. `initial` contains the values of this state by
    /// level; the first element is unused. The caller must keep the result.
    [[nodiscard]] Node reachable(const std::vector<Value>& initial);

private:
    /// A node that is being changed. It contains its children by value.
    struct Row {
        std::vector<Node> children;
        std::vector<Value> values;  ///< values whose child is not `nothing`, in any order
        std::vector<bool> waits;    ///< by value: whether it is in the queue of saturate
    };
    /// Steps with the same highest level that differ only in their relation on this level.
    struct TopSteps {
        LocalRelation local;
        Chain rest = no_link;
        Node guard = everything;
    };

    void list_steps(const std::vector<Step>& steps, diagnostics::Pollable& budget);
    void clear(Level level);
    bool add(Level level, Value value, Node more);
    [[nodiscard]] Node pack(Level level);
    [[nodiscard]] Node saturate(Level level);
    void fire_steps(Level level, Value value, std::deque<Value>& queue);
    [[nodiscard]] Node fire(Level level, Node states, Chain chain, Node guard);

    const Relations& relations_;
    Diagrams& diagrams_;
    std::vector<Row> rows_;                     // by level
    std::vector<std::vector<TopSteps>> steps_;  // by level
};

}  // namespace robochart::symbolic
