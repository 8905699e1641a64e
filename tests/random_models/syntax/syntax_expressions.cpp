// SPDX-License-Identifier: Apache-2.0
// Builds the expressions of random syntax trees.
#include <array>

#include "tests/random_models/syntax/syntax_builder.hpp"

namespace robochart::random_models {

using namespace frontend;

namespace {

// Levels of the grammar (language reference 1.1), lowest precedence first.
constexpr int quantifier_level = -1;
constexpr int not_level = 4;
constexpr int compare_level = 5;
constexpr int the_level = 6;
constexpr int let_level = 7;
constexpr int if_level = 8;
constexpr int cast_level = 9;
constexpr int plus_level = 10;
constexpr int concat_level = 12;
constexpr int negate_level = 13;
constexpr int select_level = 14;
constexpr int call_level = 15;
constexpr int atom_level = 16;

int level_of(BinaryOp op) {
    switch (op) {
        case BinaryOp::iff:
            return 0;
        case BinaryOp::implies:
            return 1;
        case BinaryOp::disjunction:
            return 2;
        case BinaryOp::conjunction:
            return 3;
        case BinaryOp::plus:
        case BinaryOp::minus:
            return plus_level;
        case BinaryOp::times:
        case BinaryOp::divide:
        case BinaryOp::modulus:
            return plus_level + 1;
        case BinaryOp::concat:
            return concat_level;
        case BinaryOp::equal:
        case BinaryOp::not_equal:
        case BinaryOp::greater:
        case BinaryOp::greater_equal:
        case BinaryOp::less:
        case BinaryOp::less_equal:
        case BinaryOp::in:
            break;
    }
    return compare_level;
}

ExprPtr make(ExprKind kind) {
    auto expr = std::make_unique<Expr>();
    expr->kind = kind;
    return expr;
}

}  // namespace

ExprPtr SyntaxBuilder::expression(std::size_t depth) {
    return at(quantifier_level, depth);
}

/// Returns an expression with a precedence of at least `level`, in parentheses if necessary.
ExprPtr SyntaxBuilder::at(int level, std::size_t depth) {
    Leveled made = any(depth);
    if (made.level >= level && !random_.chance(5)) return std::move(made.expr);
    ExprPtr group = make(ExprKind::parenthesised);
    group->args.push_back(std::move(made.expr));
    return group;
}

SyntaxBuilder::Leveled SyntaxBuilder::any(std::size_t depth) {
    if (probabilistic_ && random_.chance(30)) return probabilistic(depth);
    if (depth == 0) return atom(0);
    switch (random_.below(10)) {
        case 0:
            return atom(depth - 1);
        case 1:
        case 2:
            return binder(depth - 1);
        case 3:
        case 4:
            return bracketed(depth - 1);
        case 5:
            return selection(depth - 1);
        default:
            return operation(depth - 1);
    }
}

void SyntaxBuilder::add_list(std::vector<ExprPtr>& list, std::size_t least, std::size_t most, std::size_t depth) {
    for (std::size_t i = random_.between(least, most); i > 0; --i) list.push_back(expression(depth));
}

ExprPtr SyntaxBuilder::literal() {
    static const std::vector<std::string> integers = {"0", "1", "007", "42", "9223372036854775807"};
    static const std::vector<std::string> reals = {"0.5", "3.25", "0.000000000000000001", "12.0"};
    static const std::vector<std::string> strings = {
        "\"\"", "'go'", "\"a \\\" b\"", "'it\\'s'", "\"// no comment\"", "'\xC3\xA9 /* \\\\'", "\"{ } ; @\""};
    static const std::vector<std::string> booleans = {"true", "false"};
    constexpr ExprKind kinds[] = {ExprKind::integer, ExprKind::real, ExprKind::string, ExprKind::boolean};
    const std::vector<std::string>* texts[] = {&integers, &reals, &strings, &booleans};
    const std::size_t way = random_.below(4);
    ExprPtr expr = make(kinds[way]);
    expr->text = random_.pick(*texts[way]);
    return expr;
}

SyntaxBuilder::Leveled SyntaxBuilder::atom(std::size_t) {
    constexpr std::array kinds = {ExprKind::result,      ExprKind::to,   ExprKind::from, ExprKind::since,
                                  ExprKind::since_entry, ExprKind::name, ExprKind::name};
    const std::size_t way = random_.below(3 + kinds.size());
    if (way < 3) return {literal(), atom_level};
    ExprPtr expr = make(kinds.at(way - 3));
    if (expr->kind == ExprKind::name || expr->kind == ExprKind::since_entry) expr->name = qualified();
    if (expr->kind == ExprKind::since) expr->name = simple();
    return {std::move(expr), atom_level};
}

/// Returns operators with their operands.
SyntaxBuilder::Leveled SyntaxBuilder::operation(std::size_t depth) {
    constexpr std::size_t operators = 17;
    const std::size_t way = random_.below(operators + 6);
    if (way < operators) {
        const auto op = static_cast<BinaryOp>(way);
        const int level = level_of(op);
        ExprPtr expr = make(ExprKind::binary);
        expr->binary = op;
        expr->args.push_back(at(level, depth));
        expr->args.push_back(at(level + 1, depth));
        return {std::move(expr), level};
    }
    if (way < operators + 2) {
        const bool negates = way == operators;
        const int level = negates ? negate_level : not_level;
        ExprPtr expr = make(ExprKind::unary);
        expr->unary = negates ? UnaryOp::negate : UnaryOp::logical_not;
        expr->args.push_back(at(level, depth));
        return {std::move(expr), level};
    }
    if (way < operators + 4) {
        ExprPtr expr = make(ExprKind::if_then_else);
        add_list(expr->args, 3, 3, depth);
        return {std::move(expr), if_level};
    }
    ExprPtr expr = make(way == operators + 4 ? ExprKind::cast : ExprKind::is_type);
    expr->args.push_back(at(plus_level, depth));
    expr->type_expr = type(depth);
    return {std::move(expr), cast_level};
}

void SyntaxBuilder::typed_bindings(Expr& expr, std::size_t depth) {
    for (std::size_t i = random_.between(1, 2); i > 0; --i)
        expr.bindings.push_back({variable(DeclKind::bound_variable, depth), nullptr});
    expr.args.push_back(random_.chance(50) ? expression(depth) : nullptr);
}

/// Returns a form that binds names.
SyntaxBuilder::Leveled SyntaxBuilder::binder(std::size_t depth) {
    constexpr ExprKind kinds[] = {ExprKind::forall, ExprKind::exists, ExprKind::exists_unique,    ExprKind::lambda,
                                  ExprKind::the,    ExprKind::let,    ExprKind::set_comprehension};
    ExprPtr expr = make(kinds[random_.below(7)]);
    if (expr->kind == ExprKind::let) {
        for (std::size_t i = random_.between(1, 2); i > 0; --i) {
            Binding binding;
            binding.variable = std::make_unique<Variable>(DeclKind::bound_variable);
            binding.variable->name = name();
            binding.value = expression(depth);
            expr->bindings.push_back(std::move(binding));
        }
        expr->args.push_back(at(let_level, depth));
        return {std::move(expr), let_level};
    }
    typed_bindings(*expr, depth);
    if (expr->kind == ExprKind::the) {
        expr->args.push_back(at(the_level, depth));
        return {std::move(expr), the_level};
    }
    const bool comprehension = expr->kind == ExprKind::set_comprehension;
    expr->args.push_back(comprehension && random_.chance(40) ? nullptr : expression(depth));
    return {std::move(expr), comprehension ? atom_level : quantifier_level};
}

/// Returns a matrix such as `[| a, b; c, d |]`.
ExprPtr SyntaxBuilder::matrix(std::size_t depth) {
    ExprPtr expr = make(ExprKind::matrix);
    expr->columns = random_.between(1, 3);
    const std::size_t rows = random_.between(1, 2);
    add_list(expr->args, rows * expr->columns, rows * expr->columns, depth);
    return expr;
}

SyntaxBuilder::Leveled SyntaxBuilder::bracketed(std::size_t depth) {
    switch (random_.below(9)) {
        case 0: {
            ExprPtr expr = make(ExprKind::tuple);
            add_list(expr->args, 0, 3, depth);
            return {std::move(expr), atom_level};
        }
        case 1: {
            ExprPtr expr = make(ExprKind::record);
            expr->name = qualified();
            for (std::size_t i = random_.between(1, 2); i > 0; --i) {
                Binding binding;
                binding.variable = std::make_unique<Variable>(DeclKind::field);
                binding.variable->name = name();
                binding.value = expression(depth);
                expr->bindings.push_back(std::move(binding));
            }
            return {std::move(expr), atom_level};
        }
        case 2: {
            ExprPtr expr = make(ExprKind::sequence);
            for (std::size_t i = random_.below(4); i > 0; --i) expr->args.push_back(at(plus_level, depth));
            return {std::move(expr), atom_level};
        }
        case 3: {
            ExprPtr expr = make(ExprKind::set);
            add_list(expr->args, 0, 3, depth);
            return {std::move(expr), atom_level};
        }
        case 4: {
            ExprPtr expr = make(ExprKind::set_range);
            add_list(expr->args, 2, 2, depth);
            return {std::move(expr), atom_level};
        }
        case 5: {
            ExprPtr expr = make(ExprKind::range);
            add_list(expr->args, 2, 2, depth);
            expr->lower_closed = random_.chance(50);
            expr->upper_closed = random_.chance(50);
            return {std::move(expr), atom_level};
        }
        case 6:
            return {matrix(depth), atom_level};
        default: {
            ExprPtr expr = make(random_.chance(50) ? ExprKind::inverse : ExprKind::transpose);
            add_list(expr->args, 1, 1, depth);
            return {std::move(expr), atom_level};
        }
    }
}

/// Returns a call of a function, which is a name or another atom.
ExprPtr SyntaxBuilder::call(std::size_t depth) {
    ExprPtr expr = make(ExprKind::call);
    ExprPtr function = random_.chance(70) ? nullptr : at(atom_level, depth);
    if (function == nullptr)
        expr->name = qualified();
    else if (function->kind == ExprKind::name)
        expr->name = std::move(function->name);
    else
        expr->callee = std::move(function);
    add_list(expr->args, 0, 3, depth);
    return expr;
}

SyntaxBuilder::Leveled SyntaxBuilder::selection(std::size_t depth) {
    const std::size_t way = random_.below(3);
    if (way == 0) return {call(depth), call_level};
    ExprPtr expr = make(way == 1 ? ExprKind::member : ExprKind::index);
    expr->args.push_back(at(way == 1 ? select_level : call_level, depth));
    if (way == 1)
        expr->text = name();
    else
        add_list(expr->args, 1, 2, depth);
    return {std::move(expr), select_level};
}

/// Returns an assignable expression: a name with accesses to its parts.
ExprPtr SyntaxBuilder::target(std::size_t depth) {
    ExprPtr expr = make(ExprKind::name);
    expr->name = qualified();
    while (random_.chance(30)) {
        ExprPtr step = make(random_.chance(50) ? ExprKind::member : ExprKind::index);
        step->args.push_back(std::move(expr));
        if (step->kind == ExprKind::member)
            step->text = name();
        else
            add_list(step->args, 1, 2, depth);
        expr = std::move(step);
    }
    return expr;
}

}  // namespace robochart::random_models
