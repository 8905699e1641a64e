// SPDX-License-Identifier: Apache-2.0
// Computes the skeleton of a process: the operators above its components, which never change. The skeleton also
// contains operators that one operand can replace (exception, sequence, interrupt, choice). Their inactive operands are
// off. So a state of the whole process is a vector of fixed length with one state for each component.
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
        gate,       ///< a component added for an operator: one state that offers the operator's own first events
        operation,  ///< an operator over children
        again,      ///< control returns to the node `again`
    };
    Kind kind = Kind::leaf;
    Op op = Op::stop;
    TermId term{};  ///< leaf, operation: its term after unfolding calls
    /// The children of an operation. The gate is the first child of sliding choice, internal choice and prefix; the
    /// others are operands.
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
    std::size_t prefixes = 0;   ///< number of prefixes taken apart to reach parallel operators
};

/// Splits a term at its operators, down to the terms in `leaves` and terms without operators that stay in place.
/// Compressed terms in `left_out` are replaced by their operands. Returns no value if there is no parallel operator to
/// split. May evaluate definitions and throw their exceptions. Polls the budget.
///
/// The function also looks for parallel operators after prefixes, because a process may perform events before it starts
/// its components, or switch between modes. This fails if the prefixes never lead back to an earlier term, as in
/// COUNT(n) = up -> COUNT(n + 1) [] go -> (A ||| B). Then the function does not look for parallel operators after any
/// prefix of the term, and a subterm that begins with an event becomes one component.
[[nodiscard]] std::optional<Skeleton> skeleton_of(process::TermStore& terms, TermId term,
                                                  const std::set<TermId>& leaves, const std::set<TermId>& left_out,
                                                  diagnostics::Pollable& budget);

}  // namespace robochart::machine
