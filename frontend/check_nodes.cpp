// Rules about nodes, transitions and actions (language reference 2: S2 to PT2).
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "frontend/checks.hpp"
#include "frontend/print.hpp"
#include "frontend/rules.hpp"
#include "frontend/walk.hpp"

namespace robochart::frontend {

namespace {

/// The transitions of a container by their ends, read once: containers may be large. Looked up only, never walked.
struct Ways {
    explicit Ways(const NodeContainer& container) {
        for (const auto& transition : container.transitions) {
            out[transition->source].push_back(transition.get());
            in.insert(transition->target);
        }
    }
    std::map<const State*, std::vector<const Transition*>> out;
    std::set<const State*> in;
};

std::vector<const Transition*> outgoing(const Ways& ways, const State& node) {
    const auto found = ways.out.find(&node);
    return found != ways.out.end() ? found->second : std::vector<const Transition*>();
}

bool has_incoming(const Ways& ways, const State& node) {
    return ways.in.contains(&node);
}

std::size_t count(const NodeContainer& container, DeclKind kind) {
    return static_cast<std::size_t>(
        std::count_if(container.nodes.begin(), container.nodes.end(), [&](const auto& n) { return n->kind == kind; }));
}

void check_actions(const State& state, Diagnostics& out) {
    constexpr std::string_view words[] = {"entry", "during", "exit"};
    std::size_t seen[] = {0, 0, 0};
    for (const Action& action : state.actions) {
        const auto kind = static_cast<std::size_t>(action.kind);
        if (++seen[kind] == 2) out.report(rules::s2, action.span, {state.name, std::string(words[kind])});
    }
}

void check_final(const State& state, Diagnostics& out) {
    if (!state.actions.empty()) out.report(rules::fs2, state.name_span, {state.name});
    if (!state.nodes.empty()) out.report(rules::fs3, state.name_span, {state.name, "nodes"});
    if (!state.transitions.empty()) out.report(rules::fs3, state.name_span, {state.name, "transitions"});
}

// ---------------------------------------------------------------- probabilities

/// The value of an expression over literals.
std::optional<double> constant_value(const Expr& expr) {
    const auto arg = [&](std::size_t i) { return constant_value(*expr.args[i]); };
    if (expr.kind == ExprKind::parenthesised) return arg(0);
    if (expr.kind == ExprKind::integer || expr.kind == ExprKind::real) return std::strtod(expr.text.c_str(), nullptr);
    if (expr.kind == ExprKind::unary && *expr.unary == UnaryOp::negate) {
        const auto value = arg(0);
        return value ? std::optional(-*value) : std::nullopt;
    }
    if (expr.kind != ExprKind::binary) return std::nullopt;
    const auto left = arg(0);
    const auto right = arg(1);
    if (!left || !right) return std::nullopt;
    switch (*expr.binary) {
        case BinaryOp::plus:
            return *left + *right;
        case BinaryOp::minus:
            return *left - *right;
        case BinaryOp::times:
            return *left * *right;
        case BinaryOp::divide:
            return *right != 0 ? std::optional(*left / *right) : std::nullopt;
        default:
            return std::nullopt;
    }
}

void check_probability(const Transition& transition, Diagnostics& out) {
    const bool from_probabilistic = transition.source != nullptr && transition.source->kind == DeclKind::probabilistic;
    if (from_probabilistic && !transition.probability)
        out.report(rules::pj1, transition.name_span, {transition.name, transition.source->name});
    if (from_probabilistic && (transition.condition || transition.otherwise))
        out.report(rules::pj2, transition.name_span, {transition.name, transition.source->name});
    if (!transition.probability) return;
    if (transition.source != nullptr && !from_probabilistic)
        out.report(rules::pt1, transition.probability->span, {transition.name, transition.source->name});
    const auto value = constant_value(*transition.probability);
    if (!value) out.report(rules::pt2_unknown, transition.probability->span);
    if (value && (*value < 0 || *value > 1))
        out.report(rules::pt2, transition.probability->span, {to_text(*transition.probability)});
}

void check_probability_sum(const Ways& ways, const State& node, Diagnostics& out) {
    double sum = 0;
    for (const Transition* transition : outgoing(ways, node)) {
        const auto value = transition->probability ? constant_value(*transition->probability) : std::nullopt;
        if (!value) return;
        sum += *value;
    }
    constexpr double tolerance = 1e-9;
    if (std::abs(sum - 1) > tolerance) out.report(rules::pj3, node.name_span, {node.name, fmt::format("{:g}", sum)});
}

// ---------------------------------------------------------------- nodes and transitions

void check_node(const Ways& ways, const State& node, Diagnostics& out) {
    const std::size_t ways_out = outgoing(ways, node).size();
    switch (node.kind) {
        case DeclKind::initial:
            if (ways_out != 1)
                out.report(rules::ij2, node.name_span, {node.name, ways_out == 0 ? "no" : std::to_string(ways_out)});
            break;
        case DeclKind::junction:
        case DeclKind::probabilistic:
            if (ways_out == 0) out.report(rules::j1, node.name_span, {node.name});
            if (!has_incoming(ways, node)) out.report(rules::j2, node.name_span, {node.name});
            if (node.kind == DeclKind::probabilistic && ways_out > 0) check_probability_sum(ways, node, out);
            break;
        case DeclKind::final:
            check_final(node, out);
            break;
        default:
            check_actions(node, out);
    }
}

void check_trigger(const Transition& transition, Diagnostics& out) {
    if (!transition.trigger) return;
    if (transition.source != nullptr && transition.source->kind != DeclKind::state &&
        transition.source->kind != DeclKind::final)
        out.report(rules::j3, transition.trigger->span, {transition.name});
    const bool output = transition.trigger->kind == CommKind::output;
    if (output || transition.trigger->kind == CommKind::sync)
        out.report(rules::t2, transition.trigger->span, {transition.name, output ? "outputs" : "synchronises on"});
}

void check_transition(const Transition& transition, Diagnostics& out) {
    if (transition.target != nullptr && transition.target->kind == DeclKind::initial)
        out.report(rules::ij1, transition.to.span, {transition.name, transition.target->name});
    if (transition.source != nullptr && transition.source->kind == DeclKind::final)
        out.report(rules::fs1, transition.from.span, {transition.name, transition.source->name});
    check_trigger(transition, out);
    check_probability(transition, out);
}

void check_inner(const State& state, Diagnostics& out) {
    if (state.kind != DeclKind::state || (state.nodes.empty() && state.transitions.empty())) return;
    const std::size_t initials = count(state, DeclKind::initial);
    if (initials != 1)
        out.report(rules::stm3_inner, state.name_span, {"composite state", state.name, std::to_string(initials)});
    if (count(state, DeclKind::state) + count(state, DeclKind::final) == 0)
        out.report(rules::stm4, state.name_span, {state.name});
}

void check_top(const Machine& machine, Diagnostics& out) {
    const std::size_t initials = count(machine, DeclKind::initial);
    if (initials == 1) return;
    if (machine.kind == DeclKind::state_machine)
        out.report(rules::stm3, machine.name_span, {machine.name, initials == 0 ? "no" : std::to_string(initials)});
    else if (!machine.nodes.empty())
        out.report(rules::stm3_inner, machine.name_span, {"operation", machine.name, std::to_string(initials)});
}

}  // namespace

void check_nodes(const Machine& machine, Diagnostics& out) {
    check_top(machine, out);
    walk(machine, [&](const NodeContainer& container) {
        const Ways ways(container);
        for (const auto& node : container.nodes) {
            check_node(ways, *node, out);
            check_inner(*node, out);
        }
        for (const auto& transition : container.transitions) check_transition(*transition, out);
    });
}

}  // namespace robochart::frontend
