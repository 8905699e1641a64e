// SPDX-License-Identifier: Apache-2.0
// Reports junctions at which all guards may be false (semantics 3.4: the machine is then stuck), and guards that are
// never or always true.
#include <fmt/format.h>

#include "frontend/lint/lint_logic.hpp"
#include "frontend/lint/lints.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/types/typer.hpp"

namespace robochart::frontend {

namespace {

using logic::Answer;
using logic::Formula;
using logic::Reasoner;

constexpr std::size_t max_ways = 32;        ///< nodes with more transitions are skipped
constexpr unsigned max_junctions_back = 2;  ///< the number of junctions before a junction that contribute facts

class GuardReader {
public:
    GuardReader(const Graph& graph, bool fold) : reasoner_(fold), graph_(graph) {}

    /// Returns the condition under which a transition is enabled. `else` is the negation of the other transitions'
    /// conditions.
    Formula guard_of(const Transition& transition) {
        if (transition.condition) return reasoner_.read(*transition.condition);
        return transition.otherwise ? logic::negate_formula(some_holds(*transition.source))
                                    : logic::constant_formula(true);
    }

    Formula read(const Expr& expr) { return reasoner_.read(expr); }

    Formula some_holds(const State& node) {
        std::vector<Formula> ways;
        for (const Transition* way : graph_.transitions_from(node))
            if (!way->otherwise) ways.push_back(guard_of(*way));
        return logic::any_of(std::move(ways));
    }

    /// Returns the facts that are known when control reaches a junction: the guards on the path to it, except those
    /// that a later action invalidates.
    Formula known_at(const State& junction, unsigned depth) {
        if (junction.kind != DeclKind::junction || graph_.transitions_into(junction).size() > max_ways)
            return logic::constant_formula(true);
        std::vector<Formula> ways;
        for (const Transition* way : graph_.transitions_into(junction)) ways.push_back(known_after(*way, depth));
        return logic::any_of(std::move(ways));
    }

    [[nodiscard]] logic::Finding decide(const Formula& formula) const { return reasoner_.decide(formula); }

private:
    Formula known_after(const Transition& way, unsigned depth) {
        Effects effects;
        add_effects(*way.source, false, effects);
        if (way.action) add_effects(*way.action, effects);
        for (const auto& reset : way.resets) effects.writes.insert(reset.clock);
        const bool spoilt = effects.calls || effects.waits ||
                            (way.condition && mentions_any(*way.condition, effects.writes)) || way.otherwise;
        std::vector<Formula> facts;
        if (!spoilt) facts.push_back(guard_of(way));
        const bool quiet = effects.writes.empty() && !effects.calls && !effects.waits;
        if (quiet && depth > 0) facts.push_back(known_at(*way.source, depth - 1));
        return logic::all_of(std::move(facts));
    }

    Reasoner reasoner_;
    const Graph& graph_;
};

bool is_plain_junction(const State& node) {
    return node.kind == DeclKind::junction || node.kind == DeclKind::initial;
}

/// Reports RC-W02: for some values, all guards of a junction are false.
void check_junction(const Machine& machine, const Graph& graph, const State& node, Diagnostics& out) {
    const auto& ways = graph.transitions_from(node);
    if (!is_plain_junction(node) || ways.empty() || ways.size() > max_ways) return;
    for (const Transition* way : ways)
        if (way->otherwise || !way->condition) return;
    GuardReader reader(graph, true);
    std::vector<Formula> facts{logic::negate_formula(reader.some_holds(node)),
                               reader.known_at(node, max_junctions_back)};
    for (const ExprPtr& condition : machine.preconditions) facts.push_back(reader.read(*condition));
    const logic::Finding finding = reader.decide(logic::all_of(std::move(facts)));
    if (finding.answer != Answer::possible || !finding.trusted) return;
    const std::string when = finding.example.empty() ? "" : "when " + finding.example + ", ";
    const std::string kind = node.kind == DeclKind::initial ? "initial junction" : "junction";
    const std::string none_of = ways.size() == 1 ? "its only guard does not hold" : "none of its guards holds";
    auto& report = out.report(rules::w_stuck, node.name_span, {kind, node.name, when, none_of});
    constexpr std::size_t shown = 4;
    for (std::size_t i = 0; i < ways.size() && i < shown; ++i)
        report.notes.push_back({ways[i]->condition->span, fmt::format("`{}` needs this", ways[i]->name)});
}

/// Reports RC-W04 and RC-W05: a transition that can never fire, or a guard that is always true.
void check_condition(const Graph& graph, const Transition& transition, Never& never, Diagnostics& out) {
    const bool many = graph.transitions_from(*transition.source).size() > max_ways;
    if ((!transition.condition && !transition.otherwise) || (transition.otherwise && many)) return;
    GuardReader reader(graph, false);
    const Formula guard = reader.guard_of(transition);
    if (reader.decide(guard).answer == Answer::impossible) {
        never.insert(&transition);
        if (transition.condition)
            out.report(rules::w_never, transition.condition->span, {transition.name, to_text(*transition.condition)});
        else
            out.report(rules::w_else_never, transition.name_span, {transition.name, transition.source->name});
        return;
    }
    if (!transition.condition || strip_parentheses(*transition.condition).kind == ExprKind::boolean) return;
    if (reader.decide(logic::negate_formula(guard)).answer == Answer::impossible)
        out.report(rules::w_always, transition.condition->span, {transition.name, to_text(*transition.condition)});
}

}  // namespace

void lint_guards(const Machine& machine, Never& never, Diagnostics& out) {
    walk_tree(machine, [&](const NodeContainer& container) {
        const Graph graph(container);
        for (const auto& transition : container.transitions)
            if (transition->source != nullptr) check_condition(graph, *transition, never, out);
        for (const auto& node : container.nodes) check_junction(machine, graph, *node, out);
    });
}

}  // namespace robochart::frontend
