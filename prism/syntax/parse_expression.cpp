// SPDX-License-Identifier: Apache-2.0
// Parses expressions. See parser.hpp.
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

/// The left-associative operators by level, lowest precedence first. `!` is between levels 2 and 3.
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

/// Returns the operator of X, F or G.
Op temporal_operator(std::string_view word) {
    if (word == "X") return Op::next;
    return word == "F" ? Op::eventually : Op::globally;
}

}  // namespace

ExprPtr Parser::make_checked_node(Expr expr, Span from) {
    expr.span = span_since(from);
    ExprPtr result = make_expr(std::move(expr));
    if (result->height > max_height) fail(rules::too_deep, result->span, {fmt::format("{}", max_height)});
    return result;
}

ExprPtr Parser::make_node(Op op, Span from, std::vector<ExprPtr> parts, std::string text) {
    Expr expr;
    expr.op = op;
    expr.parts = std::move(parts);
    expr.text = std::move(text);
    return make_checked_node(std::move(expr), from);
}

ExprPtr Parser::make_infix(Op op, ExprPtr left, ExprPtr right) {
    const Span from = left->span;
    return make_node(op, from, {std::move(left), std::move(right)});
}

/// Parses an expression with path operators, such as `a U<=3 b`. Operators such as U are not associative. Outside
/// brackets, `R` begins the next property, because semicolons between properties are optional.
ExprPtr Parser::parse_expression() {
    const Depth depth(*this);
    ExprPtr left = parse_temporal();
    if (!at_infix_operator()) return left;
    Op op = Op::release;
    if (at_text("U")) op = Op::until;
    if (at_text("W")) op = Op::weak_until;
    take_token();
    Expr expr;
    expr.op = op;
    expr.steps = parse_steps();
    const Span from = left->span;
    const Within operand(*this, {surroundings_.enclosed, true, false});
    expr.parts = {std::move(left), parse_temporal()};
    return make_checked_node(std::move(expr), from);
}

bool Parser::at_infix_operator() const {
    return at_text("U") || at_text("W") || (at_text("R") && surroundings_.enclosed);
}

/// Parses `F a & b` as `F (a & b)`.
ExprPtr Parser::parse_temporal() {
    if (!at_prefix_operator()) return parse_conditional();
    const Depth depth(*this);
    const Token& token = take_token();
    Expr expr;
    expr.op = temporal_operator(token.text);
    if (expr.op != Op::next) expr.steps = parse_steps();
    const Within operand(*this, {surroundings_.enclosed, true, false});
    expr.parts = {parse_temporal()};
    return make_checked_node(std::move(expr), token.span);
}

/// Parses the operand of a path operator. Accepts `a & F b`, which PRISM accepts only in parentheses. Reports ambiguous
/// text: in `a & F b & c` and in `F a & F b` the end of the operand is unclear.
ExprPtr Parser::parse_temporal_operand() {
    const Depth depth(*this);
    const Token& token = take_token();
    const auto unclear = [&] { fail(rules::unclear_operand, token.span, {std::string(token.text)}); };
    if (surroundings_.joined) unclear();
    Expr expr;
    expr.op = temporal_operator(token.text);
    if (expr.op != Op::next) expr.steps = parse_steps();
    expr.parts = {parse_binary(negation_level)};
    for (const std::string_view more : {"&", "|", "<=>", "=>", "?"})
        if (at_text(more)) unclear();
    if (at_infix_operator()) unclear();
    return make_checked_node(std::move(expr), token.span);
}

/// Parses a bound `<=t <t >=t >t =t [a,b]`; t is a literal, a name, or an expression in parentheses.
std::shared_ptr<const StepBound> Parser::parse_steps() {
    if (at_text("^")) fail_unsupported("bounds on rewards (F^{...})", peek().span);
    auto result = std::make_shared<StepBound>();
    if (accept("[")) {
        result->low = parse_expression();
        expect(",");
        result->high = parse_expression();
        expect("]");
        return result;
    }
    for (const std::string_view symbol : {"<=", "<", ">=", ">", "="}) {
        if (!accept(symbol)) continue;
        const ExprPtr bound = parse_prefix();
        if (symbol[0] != '>') result->high = bound;
        if (symbol[0] != '<') result->low = bound;
        result->low_strict = symbol == ">";
        result->high_strict = symbol == "<";
        result->single = symbol == "=";
        return result;
    }
    return nullptr;
}

ExprPtr Parser::parse_conditional() {
    ExprPtr condition = parse_implication();
    if (!accept("?")) return condition;
    record_connective();
    const Depth depth(*this);
    const Span from = condition->span;
    ExprPtr yes = parse_conditional();
    expect(":");
    ExprPtr no = parse_conditional();
    return make_node(Op::conditional, from, {std::move(condition), std::move(yes), std::move(no)});
}

ExprPtr Parser::parse_implication() {
    ExprPtr left = parse_binary(0);
    if (!accept("=>")) return left;
    record_connective();
    const Depth depth(*this);
    ExprPtr right = parse_implication();
    return make_infix(Op::implies, std::move(left), std::move(right));
}

ExprPtr Parser::parse_binary(int level) {
    if (level == power_level) return parse_power();
    if (level == negation_level && at_text("!")) return parse_negation();
    if (level == negation_level && at_prefix_operator()) return parse_temporal_operand();
    ExprPtr left = parse_binary(level + 1);
    for (;;) {
        const Infix* next = nullptr;
        for (const Infix& infix : infixes)
            if (infix.level == level && at_text(infix.symbol)) next = &infix;
        if (next == nullptr) return left;
        take_token();
        if (level < negation_level) record_connective();
        left = make_infix(next->op, std::move(left), parse_binary(level + 1));
    }
}

/// Parses a negation: `!x=1` is `!(x=1)`.
ExprPtr Parser::parse_negation() {
    const Depth depth(*this);
    const Span from = expect("!");
    ExprPtr operand = parse_binary(negation_level);
    return make_node(Op::negation, from, {std::move(operand)});
}

/// Parses a power: `2^3^2` is `2^(3^2)`.
ExprPtr Parser::parse_power() {
    ExprPtr base = parse_prefix();
    if (!accept("^")) return base;
    const Depth depth(*this);
    ExprPtr exponent = parse_power();
    return make_infix(Op::power, std::move(base), std::move(exponent));
}

/// Parses a minus sign: `-2^2` is `(-2)^2`.
ExprPtr Parser::parse_prefix() {
    if (!at_text("-")) return parse_primary();
    const Depth depth(*this);
    const Span from = take_token().span;
    ExprPtr operand = parse_prefix();
    return make_node(Op::minus, from, {std::move(operand)});
}

/// Makes a node of the next token.
ExprPtr Parser::take_literal(Op op) {
    const Token& token = take_token();
    return make_node(op, token.span, {}, std::string(token.text));
}

ExprPtr Parser::parse_primary() {
    const Token& token = peek();
    if (token.kind == Tok::integer) return take_literal(Op::integer);
    if (token.kind == Tok::real) return take_literal(Op::real);
    if (token.kind == Tok::quoted) return take_literal(Op::label);
    if (token.kind == Tok::word) return parse_word();
    if (at_text("(")) {
        take_token();
        const Within parentheses(*this, in_brackets);
        ExprPtr inner = parse_expression();
        expect(")");
        return inner;
    }
    if (at_text("!")) return parse_negation();  // as an operand of arithmetic, which the type checker reports
    if (at_text("<") && at_text("<", 1)) fail_unsupported("strategies of coalitions (<<...>>)", token.span);
    fail("an expression");
}

ExprPtr Parser::parse_word() {
    const Token& token = peek();
    if (at_query()) return parse_query();
    if (accept("A")) return parse_for_paths(Op::forall_paths);
    if (accept("E")) return parse_for_paths(Op::exists_path);
    if (at_text("true") || at_text("false")) return take_literal(Op::boolean);
    if (accept("filter")) return parse_filter(token.span);
    if (at_text("T") && at_text("=", 1) && at_text("?", 2)) fail_unsupported("expected steps (T=?)", token.span);
    if (at_text("(", 1) && (is_function(token.text) || at_text("func"))) {
        take_token();
        take_token();
        std::string function(token.text);
        if (token.text == "func") {
            function = std::string(take_token().text);
            expect(",");
        }
        if (function == "multi") fail_unsupported("several objectives (multi)", token.span);
        return parse_call(std::move(function), token.span);
    }
    if (is_reserved(token.text)) fail("an expression");
    take_token();
    return make_node(Op::name, token.span, {}, std::string(token.text));
}

/// Parses the arguments of a call after the opening parenthesis.
ExprPtr Parser::parse_call(std::string function, Span from) {
    const Within parentheses(*this, in_brackets);
    std::vector<ExprPtr> arguments;
    do arguments.push_back(parse_expression());
    while (accept(","));
    expect(")");
    return make_node(Op::call, from, std::move(arguments), std::move(function));
}

ExprPtr Parser::parse_filter(Span from) {
    expect("(");
    const Within parentheses(*this, in_brackets);
    if (peek().kind != Tok::word && !at_text("+") && !at_text("&") && !at_text("|")) fail("the operator of a filter");
    std::string kind(take_token().text);
    std::vector<ExprPtr> parts;
    while (accept(",")) parts.push_back(parse_expression());
    expect(")");
    if (parts.empty() || parts.size() > 2) fail("filter(operator, expression, states)");
    return make_node(Op::filter, from, std::move(parts), std::move(kind));
}

}  // namespace robochart::prism
