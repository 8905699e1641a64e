// SPDX-License-Identifier: Apache-2.0
// Computes the skeleton of a process: the operators above its components. The skeleton never changes. It also contains
// operators that end when an operand replaces them (exception, sequence, interrupt, choice); the components of operands
// that do not run are off. So a state of the process is a vector of fixed length, with one state for each component.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/process/operational_semantics.hpp"

namespace robochart::machine {

using process::Op;
using process::TermId;
using NodeId = std::uint32_t;

struct Node {
    enum class Kind {
        leaf,       ///< a component, which is explored from `term`
        gate,       ///< a component that belongs to an operator: one state, with the operator's own first events
        operation,  ///< an operator over children
        again,      ///< the process continues at the node `again`
    };
    Kind kind = Kind::leaf;
    Op op = Op::stop;
    TermId term{};  ///< leaf, operation: its term after unfolding calls
    /// The children of an operation. For sliding choice, internal choice and prefix, the first child is the gate. All
    /// other children are operands.
    std::vector<NodeId> children;
    NodeId again = 0;
    NodeId region = 0;             ///< the region that contains the node: the nearest enclosing prioritise, or the root
    std::uint32_t first_slot = 0;  ///< the components below the node: [first_slot, end_slot)
    std::uint32_t end_slot = 0;
};

/// The nodes of a process. Children follow their parents; node 0 is the root.
struct Skeleton {
    std::vector<Node> nodes;
    std::vector<NodeId> slots;  ///< by component: its node
    std::size_t prefixes = 0;   ///< number of prefixes split to reach parallel operators
};

/// Splits a term at its operators. Stops at the terms in `leaves`, and at terms without operators that stay. Replaces
/// the compressed terms in `left_out` by their operands. Returns no value if there is no parallel operator. May
/// evaluate definitions, and throws their exceptions. Polls the budget.
///
/// Also searches for parallel operators after prefixes, because a process may perform events before it starts its
/// components, or switch between modes. This fails if the prefixes never lead back to an earlier term, as in COUNT(n) =
/// up -> COUNT(n + 1) [] go -> (A ||| B). In this case, no prefix is split, and a subterm that begins with an event
/// becomes one component.
[[nodiscard]] std::optional<Skeleton> skeleton_of(process::TermStore& terms, TermId term,
                                                  const std::set<TermId>& leaves, const std::set<TermId>& left_out,
                                                  diagnostics::Pollable& budget);

}  // namespace robochart::machine
