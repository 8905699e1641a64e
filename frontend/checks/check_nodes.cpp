// SPDX-License-Identifier: Apache-2.0
// Checks the rules about nodes, transitions and actions (language reference 2: S2 to PT2).
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "frontend/checks/checks.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

/// The transitions of a container, indexed by source and target. The index is built once, because containers may be
/// large. It is used for lookup only, so the order of pointers never matters.
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

std::vector<const Transition*> transitions_from(const Ways& ways, const State& node) {
    const auto found = ways.out.find(&node);
    return found != ways.out.end() ? found->second : std::vector<const Transition*>();
}

bool has_incoming(const Ways& ways, const State& node) {
    return ways.in.contains(&node);
}

std::size_t count(const NodeContainer& container, DeclKind kind) {
    return static_cast<std::size_t>(
        std::ranges::count_if(container.nodes, [&](const auto& n) { return n->kind == kind; }));
}

void check_actions(const State& state, Diagnostics& out) {
    constexpr std::string_view words[] = {"entry", "during", "exit"};
    const Action* first[] = {nullptr, nullptr, nullptr};
    std::size_t seen[] = {0, 0, 0};
    for (const Action& action : state.actions) {
        const auto kind = static_cast<std::size_t>(action.kind);
        if (first[kind] == nullptr) first[kind] = &action;
        if (++seen[kind] == 2)
            out.report(rules::s2, action.span, {state.name, std::string(words[kind])})
                .notes.push_back({first[kind]->span, "the first one"});
    }
}

void check_final(const State& state, Diagnostics& out) {
    if (!state.actions.empty()) out.report(rules::fs2, state.name_span, {state.name});
    if (!state.nodes.empty()) out.report(rules::fs3, state.name_span, {state.name, "nodes"});
    if (!state.transitions.empty()) out.report(rules::fs3, state.name_span, {state.name, "transitions"});
}

// ---------------------------------------------------------------- probabilities

}  // namespace

std::optional<double> constant_value(const Expr& expr, int constants) {
    const auto arg = [&](std::size_t i) { return constant_value(*expr.args[i], constants); };
    if (expr.kind == ExprKind::parenthesised) return arg(0);
    if (expr.kind == ExprKind::name) {
        const auto* named = dynamic_cast<const Variable*>(expr.target);
        const bool known = named != nullptr && named->kind == DeclKind::constant && named->initial && constants > 0;
        return known ? constant_value(*named->initial, constants - 1) : std::nullopt;
    }
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
        case BinaryOp::iff:
        case BinaryOp::implies:
        case BinaryOp::disjunction:
        case BinaryOp::conjunction:
        case BinaryOp::equal:
        case BinaryOp::not_equal:
        case BinaryOp::greater:
        case BinaryOp::greater_equal:
        case BinaryOp::less:
        case BinaryOp::less_equal:
        case BinaryOp::in:
        case BinaryOp::modulus:
        case BinaryOp::concat:
            break;
    }
    return std::nullopt;
}

namespace {

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

/// A product of variables and constants without a known value, sorted by pointer. Used for lookup only.
using Product = std::vector<const Declaration*>;
/// A polynomial: each product with its coefficient. The empty product is the constant term.
using Polynomial = std::map<Product, double>;

Polynomial add_polynomials(Polynomial left, const Polynomial& right, double factor) {
    for (const auto& [product, value] : right) left[product] += factor * value;
    return left;
}

std::optional<Polynomial> multiply_polynomials(const Polynomial& left, const Polynomial& right) {
    constexpr std::size_t most = 64;  // more terms than any real junction has
    if (left.size() * right.size() > most) return std::nullopt;
    Polynomial result;
    for (const auto& [a, factor_a] : left)
        for (const auto& [b, factor_b] : right) {
            Product both = a;
            both.insert(both.end(), b.begin(), b.end());
            std::ranges::sort(both, std::less<>());
            result[both] += factor_a * factor_b;
        }
    return result;
}

/// Reads an expression of names, numbers, `+`, `-`, `*` and division by numbers as a polynomial over the names without
/// a value in the model. All names are read at the same instant. At most `constants` nested definitions are followed,
/// because each can double the size of the polynomial.
std::optional<Polynomial> read_polynomial(const Expr& expr, int constants = 6) {
    const auto arg = [&](std::size_t i) { return read_polynomial(*expr.args[i], constants); };
    if (expr.kind == ExprKind::integer || expr.kind == ExprKind::real)
        return Polynomial{{{}, std::strtod(expr.text.c_str(), nullptr)}};
    if (expr.kind == ExprKind::parenthesised) return arg(0);
    if (expr.kind == ExprKind::name) {
        const auto* named = dynamic_cast<const Variable*>(expr.target);
        if (named == nullptr) return std::nullopt;
        const bool given = named->kind == DeclKind::constant && named->initial;
        if (given) return constants > 0 ? read_polynomial(*named->initial, constants - 1) : std::nullopt;
        return Polynomial{{{named}, 1}};
    }
    const bool negation = expr.kind == ExprKind::unary && *expr.unary == UnaryOp::negate;
    if (!negation && expr.kind != ExprKind::binary) return std::nullopt;
    auto left = arg(0);
    if (!left) return std::nullopt;
    if (negation) return add_polynomials({}, *left, -1);
    const auto right = arg(1);
    if (!right) return std::nullopt;
    switch (*expr.binary) {
        case BinaryOp::plus:
            return add_polynomials(std::move(*left), *right, 1);
        case BinaryOp::minus:
            return add_polynomials(std::move(*left), *right, -1);
        case BinaryOp::times:
            return multiply_polynomials(*left, *right);
        case BinaryOp::divide: {
            const bool number = right->size() == 1 && right->begin()->first.empty() && right->begin()->second != 0;
            return number ? std::optional(add_polynomials({}, *left, 1 / right->begin()->second)) : std::nullopt;
        }
        case BinaryOp::iff:
        case BinaryOp::implies:
        case BinaryOp::disjunction:
        case BinaryOp::conjunction:
        case BinaryOp::equal:
        case BinaryOp::not_equal:
        case BinaryOp::greater:
        case BinaryOp::greater_equal:
        case BinaryOp::less:
        case BinaryOp::less_equal:
        case BinaryOp::in:
        case BinaryOp::modulus:
        case BinaryOp::concat:
            break;
    }
    return std::nullopt;
}

/// Checks that the probabilities add up to 1 for all values of the names in them: `p` and `1 - p` add up to 1 for every
/// `p`. A constant sum other than 1 is an error.
void check_probability_sum(const Ways& ways, const State& node, Diagnostics& out) {
    std::optional<Polynomial> total = Polynomial{};
    for (const Transition* transition : transitions_from(ways, node)) {
        if (!transition->probability) return;  // PJ1 reports it
        const auto number = constant_value(*transition->probability);
        const auto way = number ? std::optional(Polynomial{{{}, *number}}) : read_polynomial(*transition->probability);
        total = total && way ? std::optional(add_polynomials(std::move(*total), *way, 1)) : std::nullopt;
    }
    constexpr double tolerance = 1e-9;
    const auto open = [](const auto& term) { return !term.first.empty() && std::abs(term.second) > tolerance; };
    if (!total || std::ranges::any_of(*total, open)) {
        out.report(rules::pj3_unknown, node.name_span, {node.name});
        return;
    }
    const double whole = (*total)[{}];
    if (std::abs(whole - 1) > tolerance)
        out.report(rules::pj3, node.name_span, {node.name, fmt::format("{:g}", whole)});
}

// ---------------------------------------------------------------- nodes and transitions

void check_node(const Ways& ways, const State& node, Diagnostics& out) {
    const std::size_t count = transitions_from(ways, node).size();
    if (node.kind == DeclKind::initial) {
        if (count != 1) out.report(rules::ij2, node.name_span, {node.name, count == 0 ? "no" : std::to_string(count)});
    } else if (node.kind == DeclKind::junction || node.kind == DeclKind::probabilistic) {
        if (count == 0) out.report(rules::j1, node.name_span, {node.name});
        if (!has_incoming(ways, node)) out.report(rules::j2, node.name_span, {node.name});
        if (node.kind == DeclKind::probabilistic && count > 0) check_probability_sum(ways, node, out);
    } else if (node.kind == DeclKind::final) {
        check_final(node, out);
    } else {
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

/// Reports a wrong number of initial junctions. Notes point at each initial junction after the first.
void wrong_initials(const NodeContainer& container, const Rule& rule, const Declaration& owner,
                    std::vector<std::string> arguments, Diagnostics& out) {
    auto& finding = out.report(rule, owner.name_span, std::move(arguments));
    std::size_t seen = 0;
    for (const auto& node : container.nodes)
        if (node->kind == DeclKind::initial && ++seen > 1)
            finding.notes.push_back({node->name_span, "another initial junction"});
}

void check_stm4(const NodeContainer& container, const Declaration& owner, const std::string& kind, Diagnostics& out) {
    if (!container.nodes.empty() && count(container, DeclKind::state) + count(container, DeclKind::final) == 0)
        out.report(rules::stm4, owner.name_span, {kind, owner.name});
}

void check_inner(const State& state, Diagnostics& out) {
    if (state.kind != DeclKind::state || (state.nodes.empty() && state.transitions.empty())) return;
    const std::size_t initials = count(state, DeclKind::initial);
    const std::string number = initials == 0 ? "no" : std::to_string(initials);
    if (initials != 1) wrong_initials(state, rules::stm3_inner, state, {"composite state", state.name, number}, out);
    check_stm4(state, state, "composite state", out);
}

void check_top(const Machine& machine, Diagnostics& out) {
    const bool operation = machine.kind == DeclKind::operation;
    check_stm4(machine, machine, operation ? "operation" : "state machine", out);
    const std::size_t initials = count(machine, DeclKind::initial);
    const std::string number = initials == 0 ? "no" : std::to_string(initials);
    if (initials == 1 || (operation && machine.nodes.empty())) return;
    if (operation)
        wrong_initials(machine, rules::stm3_inner, machine, {"operation", machine.name, number}, out);
    else
        wrong_initials(machine, rules::stm3, machine, {machine.name, number}, out);
}

}  // namespace

void check_nodes(const Machine& machine, Diagnostics& out) {
    check_top(machine, out);
    walk_tree(machine, [&](const NodeContainer& container) {
        const Ways ways(container);
        for (const auto& node : container.nodes) {
            check_node(ways, *node, out);
            check_inner(*node, out);
        }
        for (const auto& transition : container.transitions) check_transition(*transition, out);
    });
}

}  // namespace robochart::frontend
