// SPDX-License-Identifier: Apache-2.0
// Expressions. See parser.hpp.
#include <fmt/format.h>

#include <array>

#include "prism/syntax/parser.hpp"
#include "prism/syntax/rules.hpp"

namespace robochart::prism {
namespace {

struct Infix {
    std::string_view symbol;
    Op op;
    int level;
};

/// Left-associative operators by level, lowest precedence first. `!` is between levels 2 and 3.
constexpr std::array<Infix, 13> infixes{{
    {"<=>", Op::iff, 0},
    {"|", Op::disjunction, 1},
    {"&", Op::conjunction, 2},
    {"=", Op::equal, 3},
    {"!=", Op::unequal, 3},
    {"<", Op::less, 4},
    {"<=", Op::less_equal, 4},
    {">", Op::greater, 4},
    {">=", Op::greater_equal, 4},
    {"+", Op::add, 5},
    {"-", Op::subtract, 5},
    {"*", Op::multiply, 6},
    {"/", Op::divide, 6},
}};
constexpr int negation_level = 3;
constexpr int power_level = 7;

constexpr std::array<std::string_view, 9> functions{"min", "max", "floor", "ceil", "round",
                                                    "pow", "mod", "log",   "multi"};

bool is_function(std::string_view word) {
    for (const std::string_view function : functions)
        if (word == function) return true;
    return false;
}

}  // namespace

ExprPtr Parser::checked(Expr expr, Span from) {
    expr.span = since(from);
    ExprPtr result = make_expr(std::move(expr));
    if (result->height > max_height) fail(rules::too_deep, result->span, {fmt::format("{}", max_height)});
    return result;
}

ExprPtr Parser::node(Op op, Span from, std::vector<ExprPtr> parts, std::string text) {
    Expr expr;
    expr.op = op;
    expr.parts = std::move(parts);
    expr.text = std::move(text);
    return checked(std::move(expr), from);
}

ExprPtr Parser::infix(Op op, ExprPtr left, ExprPtr right) {
    const Span from = left->span;
    return node(op, from, {std::move(left), std::move(right)});
}

/// Parses `a U<=3 b`. These operators do not chain. Outside brackets, `R` begins the next property, because semicolons
/// between properties are optional.
ExprPtr Parser::expression() {
    const Depth depth(*this);
    ExprPtr left = temporal();
    if (!at_infix_operator()) return left;
    const Op op = at("U") ? Op::until : at("W") ? Op::weak_until : Op::release;
    take();
    Expr expr;
    expr.op = op;
    expr.steps = steps();
    const Span from = left->span;
    const Within operand(*this, {surroundings_.enclosed, true, false});
    expr.parts = {std::move(left), temporal()};
    return checked(std::move(expr), from);
}

bool Parser::at_infix_operator() const {
    return at("U") || at("W") || (at("R") && surroundings_.enclosed);
}

/// Parses `F a & b` as `F (a & b)`.
ExprPtr Parser::temporal() {
    if (!at_prefix_operator()) return conditional();
    const Depth depth(*this);
    const Token& token = take();
    Expr expr;
    expr.op = token.text == "X" ? Op::next : token.text == "F" ? Op::eventually : Op::globally;
    if (expr.op != Op::next) expr.steps = steps();
    const Within operand(*this, {surroundings_.enclosed, true, false});
    expr.parts = {temporal()};
    return checked(std::move(expr), token.span);
}

/// Accepts `a & F b`, which PRISM accepts only in parentheses. Reports ambiguous text: in `a & F b & c` and in `F a & F
/// b` the end of the operand is unclear.
ExprPtr Parser::temporal_operand() {
    const Depth depth(*this);
    const Token& token = take();
    const auto unclear = [&] { fail(rules::unclear_operand, token.span, {std::string(token.text)}); };
    if (surroundings_.joined) unclear();
    Expr expr;
    expr.op = token.text == "X" ? Op::next : token.text == "F" ? Op::eventually : Op::globally;
    if (expr.op != Op::next) expr.steps = steps();
    expr.parts = {binary(negation_level)};
    for (const std::string_view more : {"&", "|", "<=>", "=>", "?"})
        if (at(more)) unclear();
    if (at_infix_operator()) unclear();
    return checked(std::move(expr), token.span);
}

/// `<=t <t >=t >t =t [a,b]`; t is a literal, a name, or an expression in parentheses.
std::shared_ptr<const StepBound> Parser::steps() {
    if (at("^")) refuse("bounds on rewards (F^{...})", peek().span);
    auto result = std::make_shared<StepBound>();
    if (accept("[")) {
        result->low = expression();
        expect(",");
        result->high = expression();
        expect("]");
        return result;
    }
    for (const std::string_view symbol : {"<=", "<", ">=", ">", "="}) {
        if (!accept(symbol)) continue;
        const ExprPtr bound = prefix();
        if (symbol[0] != '>') result->high = bound;
        if (symbol[0] != '<') result->low = bound;
        result->low_strict = symbol == ">";
        result->high_strict = symbol == "<";
        result->single = symbol == "=";
        return result;
    }
    return nullptr;
}

ExprPtr Parser::conditional() {
    ExprPtr condition = implication();
    if (!accept("?")) return condition;
    join();
    const Depth depth(*this);
    const Span from = condition->span;
    ExprPtr yes = conditional();
    expect(":");
    ExprPtr no = conditional();
    return node(Op::conditional, from, {std::move(condition), std::move(yes), std::move(no)});
}

ExprPtr Parser::implication() {
    ExprPtr left = binary(0);
    if (!accept("=>")) return left;
    join();
    const Depth depth(*this);
    ExprPtr right = implication();
    return infix(Op::implies, std::move(left), std::move(right));
}

ExprPtr Parser::binary(int level) {
    if (level == power_level) return power();
    if (level == negation_level && at("!")) return negation();
    if (level == negation_level && at_prefix_operator()) return temporal_operand();
    ExprPtr left = binary(level + 1);
    for (;;) {
        const Infix* next = nullptr;
        for (const Infix& each : infixes)
            if (each.level == level && at(each.symbol)) next = &each;
        if (next == nullptr) return left;
        take();
        if (level < negation_level) join();
        left = infix(next->op, std::move(left), binary(level + 1));
    }
}

/// `!x=1` is `!(x=1)`.
ExprPtr Parser::negation() {
    const Depth depth(*this);
    const Span from = expect("!");
    ExprPtr operand = binary(negation_level);
    return node(Op::negation, from, {std::move(operand)});
}

/// `2^3^2` is `2^(3^2)`.
ExprPtr Parser::power() {
    ExprPtr base = prefix();
    if (!accept("^")) return base;
    const Depth depth(*this);
    ExprPtr exponent = power();
    return infix(Op::power, std::move(base), std::move(exponent));
}

/// `-2^2` is `(-2)^2`.
ExprPtr Parser::prefix() {
    if (!at("-")) return primary();
    const Depth depth(*this);
    const Span from = take().span;
    ExprPtr operand = prefix();
    return node(Op::minus, from, {std::move(operand)});
}

ExprPtr Parser::primary() {
    const Token& token = peek();
    if (token.kind == Tok::integer) return take(), node(Op::integer, token.span, {}, std::string(token.text));
    if (token.kind == Tok::real) return take(), node(Op::real, token.span, {}, std::string(token.text));
    if (token.kind == Tok::quoted) return take(), node(Op::label, token.span, {}, std::string(token.text));
    if (token.kind == Tok::word) return word();
    if (at("(")) {
        take();
        const Within parentheses(*this, in_brackets);
        ExprPtr inner = expression();
        expect(")");
        return inner;
    }
    if (at("!")) return negation();  // as an operand of arithmetic, which the type checker reports
    if (at("<") && at("<", 1)) refuse("strategies of coalitions (<<...>>)", token.span);
    fail("an expression");
}

ExprPtr Parser::word() {
    const Token& token = peek();
    if (at_query()) return query();
    if (accept("A")) return for_paths(Op::forall_paths);
    if (accept("E")) return for_paths(Op::exists_path);
    if (at("true") || at("false")) return take(), node(Op::boolean, token.span, {}, std::string(token.text));
    if (at("filter")) return take(), filter(token.span);
    if (at("T") && at("=", 1) && at("?", 2)) refuse("expected steps (T=?)", token.span);
    if (at("(", 1) && (is_function(token.text) || at("func"))) {
        take();
        take();
        std::string function(token.text);
        if (token.text == "func") {
            function = std::string(take().text);
            expect(",");
        }
        if (function == "multi") refuse("several objectives (multi)", token.span);
        return call(std::move(function), token.span);
    }
    if (is_reserved(token.text)) fail("an expression");
    take();
    return node(Op::name, token.span, {}, std::string(token.text));
}

/// Parses the arguments of a call after the opening parenthesis.
ExprPtr Parser::call(std::string function, Span from) {
    const Within parentheses(*this, in_brackets);
    std::vector<ExprPtr> arguments;
    do arguments.push_back(expression());
    while (accept(","));
    expect(")");
    return node(Op::call, from, std::move(arguments), std::move(function));
}

ExprPtr Parser::filter(Span from) {
    expect("(");
    const Within parentheses(*this, in_brackets);
    if (peek().kind != Tok::word && !at("+") && !at("&") && !at("|")) fail("the operator of a filter");
    std::string kind(take().text);
    std::vector<ExprPtr> parts;
    while (accept(",")) parts.push_back(expression());
    expect(")");
    if (parts.empty() || parts.size() > 2) fail("filter(operator, expression, states)");
    return node(Op::filter, from, std::move(parts), std::move(kind));
}

}  // namespace robochart::prism
