// SPDX-License-Identifier: Apache-2.0
// Compiles expressions. See code.hpp; evaluate.cpp contains the evaluation.
#include "prism/explore/code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <set>

#include "prism/explore/rules.hpp"

namespace robochart::prism {

std::string Value::text() const {
    if (type == Type::boolean) return integer != 0 ? "true" : "false";
    return type == Type::integer ? fmt::format("{}", integer) : real.text();
}

Code::Code(std::map<std::string, std::uint32_t, std::less<>> variables, std::vector<Type> types, Values constants)
    : variables_(std::move(variables)), types_(std::move(types)), constants_(std::move(constants)) {}

void Code::define(const std::string& name, Value value) {
    constants_[name] = std::move(value);
}

Code::Root Code::add(const Node& node, Span span) {
    nodes_.push_back(node);
    spans_.push_back(span);
    return static_cast<Root>(nodes_.size() - 1);
}

Code::Root Code::constant_node(const Value& value, Span span) {
    Node node;
    node.type = value.type;
    node.value = value.integer;
    if (value.type == Type::real) {
        node.a = static_cast<std::uint32_t>(reals_.size());
        reals_.push_back(value.real);
    }
    return add(node, span);
}

Code::Root Code::compile(const ExprPtr& expr) {
    known_.clear();
    return compiled(expr);
}

Code::Root Code::compiled(const ExprPtr& expr) {
    if (const auto found = known_.find(expr.get()); found != known_.end()) return found->second;
    Root root = 0;
    switch (expr->op) {
        case Op::boolean:
            root = constant_node({Type::boolean, expr->text == "true" ? 1 : 0, {}}, expr->span);
            break;
        case Op::integer: {
            std::int64_t value = 0;
            std::from_chars(expr->text.data(), expr->text.data() + expr->text.size(), value);
            root = constant_node({Type::integer, value, {}}, expr->span);
            break;
        }
        case Op::real:
            root = constant_node({Type::real, 0, Real(decimal(expr->text))}, expr->span);
            break;
        case Op::name:
            root = name(*expr);
            break;
        case Op::call:
            root = fold_constants(call(*expr));
            break;
        default:
            root = fold_constants(operation(*expr));
            break;
    }
    known_[expr.get()] = root;
    return root;
}

Code::Root Code::name(const Expr& expr) {
    if (const auto found = variables_.find(expr.text); found != variables_.end()) {
        Node node;
        node.op = Operation::variable;
        node.type = types_[found->second];
        node.a = found->second;
        return add(node, expr.span);
    }
    const auto found = constants_.find(expr.text);
    if (found == constants_.end()) throw EvaluationError(rules::constant_open, expr.span, {expr.text});
    return constant_node(found->second, expr.span);
}

Code::Root Code::operation(const Expr& expr) {
    Node node;
    node.type = Type::boolean;
    switch (expr.op) {
        case Op::conditional:
            node.op = Operation::conditional;
            break;
        case Op::implies:
            node.op = Operation::implies;
            break;
        case Op::iff:
            node.op = Operation::iff;
            break;
        case Op::disjunction:
            node.op = Operation::disjunction;
            break;
        case Op::conjunction:
            node.op = Operation::conjunction;
            break;
        case Op::negation:
            node.op = Operation::negation;
            break;
        case Op::add:
            node.op = Operation::add;
            break;
        case Op::subtract:
            node.op = Operation::subtract;
            break;
        case Op::multiply:
            node.op = Operation::multiply;
            break;
        case Op::divide:
            node.op = Operation::divide;
            break;
        case Op::power:
            node.op = Operation::power;
            break;
        case Op::minus:
            node.op = Operation::minus;
            break;
        // clang-format off
        case Op::boolean: case Op::integer: case Op::real: case Op::name: case Op::label: case Op::equal:
        case Op::unequal: case Op::less: case Op::less_equal: case Op::greater: case Op::greater_equal: case Op::call:
        case Op::probability: case Op::steady: case Op::reward: case Op::forall_paths: case Op::exists_path:
        case Op::filter: case Op::next: case Op::eventually: case Op::globally: case Op::until: case Op::weak_until:
        case Op::release: case Op::cumulative: case Op::total: case Op::instantaneous: case Op::long_run:
            return comparison(expr);
    }
    // clang-format on
    std::uint32_t* const places[] = {&node.a, &node.b, &node.c};
    bool real = expr.op == Op::divide;
    for (std::size_t i = 0; i < expr.parts.size(); ++i) {
        *places[i] = compiled(expr.parts[i]);
        real = real || type(*places[i]) == Type::real;
    }
    const bool numeric = node.op >= Operation::add;
    if (numeric) node.type = real ? Type::real : Type::integer;
    if (node.op == Operation::conditional) node.type = real ? Type::real : type(node.b);
    return add(node, expr.span);
}

/// Compiles a comparison. Comparisons of a variable with a constant have special operations, because most guards
/// consist of them.
Code::Root Code::comparison(const Expr& expr) {
    Node node;
    node.type = Type::boolean;
    node.a = compiled(expr.parts[0]);
    node.b = compiled(expr.parts[1]);
    const bool real = type(node.a) == Type::real || type(node.b) == Type::real;
    const bool simple = !real && nodes_[node.a].op == Operation::variable && is_constant(node.b);
    Operation family = Operation::equal;
    if (real) family = Operation::real_equal;
    if (simple) family = Operation::variable_equal;
    const auto offset = static_cast<unsigned>(expr.op) - static_cast<unsigned>(Op::equal);
    node.op = static_cast<Operation>(static_cast<unsigned>(family) + offset);
    if (simple) {
        node.value = nodes_[node.b].value;
        node.a = nodes_[node.a].a;
    }
    return add(node, expr.span);
}

Code::Root Code::call(const Expr& expr) {
    static const std::map<std::string, Operation, std::less<>> functions{
        {"min", Operation::minimum}, {"max", Operation::maximum}, {"floor", Operation::floor},
        {"ceil", Operation::ceil},   {"round", Operation::round}, {"pow", Operation::power},
        {"mod", Operation::mod},     {"log", Operation::log}};
    Node node;
    node.op = functions.find(expr.text)->second;
    std::vector<Root> arguments;
    bool real = false;
    for (const ExprPtr& part : expr.parts) {
        arguments.push_back(compiled(part));
        real = real || type(arguments.back()) == Type::real;
    }
    if (node.op == Operation::log ||
        (real && node.op != Operation::floor && node.op != Operation::ceil && node.op != Operation::round))
        node.type = Type::real;
    if (node.op == Operation::minimum || node.op == Operation::maximum) {
        node.a = static_cast<std::uint32_t>(lists_.size());
        lists_.insert(lists_.end(), arguments.begin(), arguments.end());
        node.b = static_cast<std::uint32_t>(lists_.size());
    } else {
        node.a = arguments[0];
        if (arguments.size() > 1) node.b = arguments[1];
    }
    return add(node, expr.span);
}

std::vector<Code::Root> Code::operands(const Node& node) const {
    using enum Operation;
    if (node.op == constant || node.op == variable) return {};
    if (node.op >= variable_equal && node.op <= variable_greater_equal) return {};
    if (node.op == minimum || node.op == maximum) return {lists_.begin() + node.a, lists_.begin() + node.b};
    if (node.op == conditional) return {node.a, node.b, node.c};
    const bool one = node.op == negation || node.op == minus || node.op == floor || node.op == ceil || node.op == round;
    return one ? std::vector<Root>{node.a} : std::vector<Root>{node.a, node.b};
}

/// Evaluates an expression that reads no variable, and replaces it by its value. If the evaluation fails, the
/// expression stays, because the model may never evaluate it.
Code::Root Code::fold_constants(Root root) {
    const Node node = nodes_[root];
    using enum Operation;
    if (node.op == conditional && is_constant(node.a)) {
        const Root taken = nodes_[node.a].value != 0 ? node.b : node.c;
        if (type(taken) == node.type) return taken;
    }
    if (node.op == conjunction && is_constant(node.a)) return nodes_[node.a].value != 0 ? node.b : node.a;
    if (node.op == disjunction && is_constant(node.a)) return nodes_[node.a].value != 0 ? node.a : node.b;
    if (node.op == conjunction && is_constant(node.b) && nodes_[node.b].value != 0) return node.a;
    if (node.op == disjunction && is_constant(node.b) && nodes_[node.b].value == 0) return node.a;
    const std::vector<Root> parts = operands(node);
    const bool fixed = !parts.empty() && std::ranges::all_of(parts, [&](Root r) { return is_constant(r); });
    if (!fixed) return root;
    try {
        return constant_node(value(root, nullptr), spans_[root]);
    } catch (const EvaluationError&) {
        return root;
    }
}

std::vector<std::uint32_t> Code::variables(Root root) const {
    std::set<std::uint32_t> found;
    std::set<Root> seen;
    std::vector<Root> open{root};
    while (!open.empty()) {
        const Root at = open.back();
        open.pop_back();
        if (!seen.insert(at).second) continue;
        const Node& node = nodes_[at];
        using enum Operation;
        if (node.op == variable || (node.op >= variable_equal && node.op <= variable_greater_equal))
            found.insert(node.a);
        for (const Root part : operands(node)) open.push_back(part);
    }
    return {found.begin(), found.end()};
}

}  // namespace robochart::prism
