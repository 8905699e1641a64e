// SPDX-License-Identifier: Apache-2.0
// Reports nodes that cannot be reached from the initial junction of their container. The choice between enabled
// transitions is free (semantics 3.4), so a path to a node is possible unless one of its transitions can never be
// taken.
#include <algorithm>
#include <unordered_set>

#include "frontend/lint/lints.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

using Nodes = std::unordered_set<const State*>;

class Reachability {
public:
    Reachability(const NodeContainer& container, const Never& never)
        : container_(container), never_(never), graph_(container) {}

    void check(Diagnostics& out) {
        bool begins = false;
        for (const auto& node : container_.nodes)
            if (node->kind == DeclKind::initial) {
                begins = true;
                add_from(*node, reached_);
            }
        if (!begins) return;
        for (const auto& node : container_.nodes)
            if (!is_covered(*node) && cut_off(*node)) add_from(*node, reported_);
        // Nodes without an incoming transition are reported first, then groups of nodes that are reachable only from
        // each other.
        for (const auto& node : container_.nodes)
            if (!is_covered(*node) && is_root(*node)) report(*node, out);
        for (const auto& node : container_.nodes)
            if (!is_covered(*node)) report(*node, out);
    }

    [[nodiscard]] const Nodes& reached_nodes() const { return reached_; }

private:
    void add_from(const State& start, Nodes& nodes) const {
        std::vector<const State*> open{&start};
        nodes.insert(&start);
        while (!open.empty()) {
            const State* node = open.back();
            open.pop_back();
            for (const Transition* way : graph_.transitions_from(*node))
                if (!never_.contains(way) && nodes.insert(way->target).second) open.push_back(way->target);
        }
    }

    [[nodiscard]] bool is_covered(const State& node) const {
        return reached_.contains(&node) || reported_.contains(&node);
    }

    [[nodiscard]] bool is_root(const State& node) const {
        for (const Transition* way : graph_.transitions_into(node))
            if (!never_.contains(way) && way->source != &node) return false;
        return true;
    }

    /// True if a transition that is never taken leads from a reachable node to this node. RC-W04 reports the
    /// transition, so the node itself is not reported.
    [[nodiscard]] bool cut_off(const State& node) const {
        const auto& ways = graph_.transitions_into(node);
        return std::ranges::any_of(
            ways, [&](const Transition* way) { return never_.contains(way) && reached_.contains(way->source); });
    }

    void report(const State& node, Diagnostics& out) {
        add_from(node, reported_);
        auto& finding = out.report(rules::w_unreachable, node.name_span, {std::string(to_text(node.kind)), node.name});
        for (const Transition* way : graph_.transitions_into(node)) {
            if (way->source == &node) continue;
            finding.notes.push_back(
                {way->name_span, "this transition leads to the node, but its source is not reached"});
            return;
        }
    }

    const NodeContainer& container_;
    const Never& never_;
    const Graph graph_;
    Nodes reached_, reported_;
};

void check(const NodeContainer& container, const Never& never, Diagnostics& out) {
    Reachability reachability(container, never);
    reachability.check(out);
    for (const auto& node : container.nodes)
        if (reachability.reached_nodes().contains(node.get())) check(*node, never, out);
}

}  // namespace

void lint_reachability(const Machine& machine, const Never& never, Diagnostics& out) {
    check(machine, never, out);
}

}  // namespace robochart::frontend
