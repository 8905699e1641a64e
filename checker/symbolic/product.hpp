// SPDX-License-Identifier: Apache-2.0
// Decides refinement with the set of reachable pairs. A pair consists of a node of the specification's normal form and
// a state of the implementation (Roscoe, "Understanding Concurrent Systems", 16.1). The node is the highest variable.
// An event that can change the node is a relation on the node and on the variables of the event's rule. All other
// events leave the node unchanged (docs/search.md, "Decision diagrams").
#pragma once

#include <map>
#include <vector>

#include "checker/refine/verdict/normal_table.hpp"
#include "checker/symbolic/relations.hpp"

namespace robochart::symbolic {

class Product {
public:
    /// The highest level of the diagrams must be reserved for the node; all other levels belong to the variables of
    /// `relations`. `rules` are the rules that the steps of `relations` represent, in the same order. Polls the budget.
    Product(const refine::NormalTable& table, const std::vector<machine::WholeRule>& rules, Relations& relations,
            Diagrams& diagrams, diagnostics::Pollable& budget);

    /// Returns the steps between pairs. A pair has no step with an event that its node does not allow, and no step with
    /// an event after which the specification diverges.
    [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
    /// Returns the pairs of this set whose state can perform an event that the node does not allow.
    [[nodiscard]] Node forbidden(Node pairs);
    /// Returns the pairs of this set whose state refuses more than the node allows. Such a state is stable or has tick,
    /// and its acceptance includes none of the node's acceptances (refine/search/stability.hpp).
    [[nodiscard]] Node refusing(Node pairs);

private:
    [[nodiscard]] LocalRelation relation_of(process::Event event) const;
    [[nodiscard]] Node none_possible(std::vector<Step> steps);
    [[nodiscard]] Node none_possible_of(const std::vector<process::Event>& events);
    [[nodiscard]] std::vector<process::Event> forbidden_events(Value node) const;
    [[nodiscard]] Node refusing(const std::vector<process::EventSet>& acceptances, Node states, Node stable,
                                Node without_tick);
    [[nodiscard]] Node lacking(const process::EventSet& acceptance, Node states);

    const refine::NormalTable& table_;
    Relations& relations_;
    Diagrams& diagrams_;
    diagnostics::Pollable& budget_;
    std::map<process::Event, std::vector<Step>> by_event_;  // steps of the implementation
    // The states in which none of the events is possible.
    std::map<std::vector<process::Event>, Node> not_possible_;
    std::vector<Step> steps_;
};

}  // namespace robochart::symbolic
