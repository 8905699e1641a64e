// SPDX-License-Identifier: Apache-2.0
// Reports calls that never return (semantics 3.8: a call returns when the operation reaches its final state). Only
// calls in entry, exit and transition actions are reported. An operation that a during action calls may run until the
// state is left.
#include <map>

#include "frontend/lint/lints.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"

namespace robochart::frontend {

namespace {

bool can_end(const Machine& operation) {
    std::unordered_set<const State*> seen;
    std::vector<const State*> open;
    const Graph graph(operation);
    for (const auto& node : operation.nodes)
        if (node->kind == DeclKind::initial && seen.insert(node.get()).second) open.push_back(node.get());
    const bool begins = !open.empty();
    while (!open.empty()) {
        const State* node = open.back();
        open.pop_back();
        if (node->kind == DeclKind::final) return true;
        for (const Transition* way : graph.transitions_from(*node))
            if (seen.insert(way->target).second) open.push_back(way->target);
    }
    return !begins;
}

class Calls {
public:
    Calls(const std::map<std::string_view, const Machine*>& endless, ReportedCalls& reported, Diagnostics& out)
        : endless_(endless), reported_(reported), out_(out) {}

    void check(const NodeContainer& container) {
        for (const auto& node : container.nodes) {
            for (const Action& action : node->actions)
                if (action.statement && action.kind != ActionKind::during) check(*action.statement);
            check(*node);
        }
        for (const auto& transition : container.transitions)
            if (transition->action) check(*transition->action);
    }

private:
    void check(const Stmt& action) {
        walk_tree(action, [&](const Stmt& statement) {
            if (statement.kind != StmtKind::call || statement.declaration == nullptr) return;
            const auto called = endless_.find(statement.declaration->name);
            if (called == endless_.end() || !reported_.insert(&statement).second) return;
            out_.report(rules::w_endless, statement.span, {statement.declaration->name})
                .notes.push_back({called->second->name_span, "defined here, without a reachable final state"});
        });
    }

    const std::map<std::string_view, const Machine*>& endless_;
    ReportedCalls& reported_;
    Diagnostics& out_;
};

}  // namespace

void lint_termination(const Machine& operation, Diagnostics& out) {
    if (operation.terminates && !operation.nodes.empty() && !can_end(operation))
        out.report(rules::w_broken_promise, operation.name_span, {operation.name});
}

void lint_operations(const Component& controller, ReportedCalls& reported, Diagnostics& out) {
    std::map<std::string_view, const Machine*> endless;
    for (const Machine* operation : defined_operations(controller))
        if (!operation->nodes.empty() && !can_end(*operation)) endless.emplace(operation->name, operation);
    if (endless.empty()) return;
    Calls calls(endless, reported, out);
    for (const Declaration* part : controller.order)
        if (const auto* machine = follow_to<Machine>(part)) calls.check(*machine);
}

}  // namespace robochart::frontend
