// The part of a process that stays in place while it runs: the operators above its components. An operator that one
// operand outlives (exception, sequence, interrupt, choice) keeps its place too: the operands not running are off.
// So a state of the whole is one state a component, in a vector of fixed length.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "checker/process/operational_semantics.hpp"

namespace robochart::machine {

using process::Op;
using process::TermId;
using NodeId = std::uint32_t;

struct Node {
    enum class Kind {
        leaf,       ///< a component, explored from `term`
        gate,       ///< a component made for an operator: one state that offers the operator's own first events
        operation,  ///< an operator over children
        again,      ///< where control comes back to the node `again`
    };
    Kind kind = Kind::leaf;
    Op op = Op::stop;
    TermId term{};  ///< leaf, operation: what it stands for (calls unfolded)
    /// Operation. Sliding, internal choice and prefix have their gate as the first child; the others their operands.
    std::vector<NodeId> children;
    NodeId again = 0;
    NodeId region = 0;             ///< the region that contains it: the nearest prioritise above, or the root
    std::uint32_t first_slot = 0;  ///< the components below it: [first_slot, end_slot)
    std::uint32_t end_slot = 0;
};

/// Nodes in an order where children come after their parents; node 0 is the root.
struct Skeleton {
    std::vector<Node> nodes;
    std::vector<NodeId> slots;  ///< of each component, its node
    std::size_t prefixes = 0;   ///< taken apart, to get to the parallel operators behind them
};

/// Takes a term apart, down to the terms in `leaves` and those without operators that stay; compressed terms in
/// `left_out` are their operands. Nothing if it has no parallel operator to take apart. May evaluate definitions and
/// throw what they throw. `poll` may throw to stop.
///
/// Events before a parallel operator are looked through, so that a process can start its components or move between
/// modes. Where that does not come back to where it began, as in COUNT(n) = up -> COUNT(n + 1) [] go -> (A ||| B), it
/// is given up for the whole term: what begins with an event is then one component.
[[nodiscard]] std::optional<Skeleton> skeleton_of(process::TermStore& terms, TermId term,
                                                  const std::set<TermId>& leaves, const std::set<TermId>& left_out,
                                                  const std::function<void()>& poll);

}  // namespace robochart::machine
