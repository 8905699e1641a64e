// SPDX-License-Identifier: Apache-2.0
// Parses conditions. See parser.hpp.
#include "claims/sleec/syntax/parser.hpp"
#include "claims/sleec/syntax/printer.hpp"
#include "claims/sleec/syntax/rules.hpp"

namespace robochart::sleec {
namespace {

bool is_junction(const ExprPtr& expr) {
    return expr->op == Op::conjunction || expr->op == Op::disjunction;
}

}  // namespace

ExprPtr Parser::make_node(Op op, Span from, std::vector<ExprPtr> parts) {
    Expr expr;
    expr.op = op;
    expr.span = span_since(from);
    expr.parts = std::move(parts);
    return std::make_shared<const Expr>(std::move(expr));
}

/// Parses a condition. A chain of operators becomes a left-deep tree, whose depth is the length of the chain.
/// Traversals recurse this deep, so the length is limited.
ExprPtr Parser::parse_condition() {
    const Depth depth(*this);
    const Span from = peek().span;
    ExprPtr left = parse_term();
    unsigned length = 0;
    bool mixed = false;
    while (is_at("and") || is_at("or")) {
        if (++length > max_depth) enter_level();
        const Op op = take_token().text == "and" ? Op::conjunction : Op::disjunction;
        mixed = mixed || (length > 1 && left->op != op);
        left = make_node(op, from, {left, parse_term()});
    }
    if (length > max_depth) depth_ -= length - max_depth;
    if (mixed) warn_mixed(left);
    return left;
}

/// Reports the first place where the operator changes, with parentheses that show how it is parsed.
void Parser::warn_mixed(const ExprPtr& whole) {
    const Expr* outer = whole.get();
    const Expr* changed = nullptr;
    while (is_junction(outer->parts[0]) && !outer->parts[0]->bracketed) {
        if (outer->parts[0]->op != outer->op) changed = outer;
        outer = outer->parts[0].get();
    }
    if (changed == nullptr) return;
    const Span inner = changed->parts[0]->span;
    auto& finding = diagnostics_.report(rules::mixed_operators, whole->span, {"'" + print(whole) + "'"});
    finding.fixes.push_back({{inner.source, inner.begin, inner.begin}, "(", "write the parentheses"});
    finding.fixes.push_back({{inner.source, inner.end, inner.end}, ")", "write the parentheses"});
}

/// Parses an operand of `and` and `or`. `not` applies to one comparison.
ExprPtr Parser::parse_term() {
    const Depth depth(*this);
    if (!is_at("not")) return parse_relation();
    const Span from = take_token().span;
    return make_node(Op::negation, from, {parse_term()});
}

ExprPtr Parser::parse_relation() {
    const Span from = peek().span;
    ExprPtr left = parse_sum();
    for (const Op op : {Op::less, Op::less_equal, Op::greater, Op::greater_equal, Op::equal, Op::unequal}) {
        if (!accept(symbol_of(op))) continue;
        ExprPtr right = parse_sum();
        return make_node(op, from, {std::move(left), std::move(right)});
    }
    return left;
}

ExprPtr Parser::parse_sum() {
    const Span from = peek().span;
    ExprPtr left = parse_product();
    unsigned length = 0;
    while (is_at("+") || is_at("-")) {
        if (++length > max_depth) enter_level();
        const Token& token = take_token();
        only_in(Dialect::legos, token.span, "arithmetic");
        left = make_node(token.text == "+" ? Op::add : Op::subtract, from, {left, parse_product()});
    }
    if (length > max_depth) depth_ -= length - max_depth;
    return left;
}

ExprPtr Parser::parse_product() {
    const Span from = peek().span;
    ExprPtr left = parse_primary();
    unsigned length = 0;
    while (is_at("*")) {
        if (++length > max_depth) enter_level();
        only_in(Dialect::legos, take_token().span, "arithmetic");
        left = make_node(Op::multiply, from, {left, parse_primary()});
    }
    if (length > max_depth) depth_ -= length - max_depth;
    return left;
}

ExprPtr Parser::parse_primary() {
    const Depth depth(*this);
    const Span from = peek().span;
    if (accept("(")) {
        Expr inner = *parse_condition();
        expect(")");
        inner.bracketed = true;
        inner.span = span_since(from);
        return std::make_shared<const Expr>(std::move(inner));
    }
    Expr expr;
    if (accept("{")) {
        expr.op = Op::name;
        expr.text = simple_name("the name of a measure").text;
        if (!is_at("}")) fail("'}' (braces hold the name of one measure)");
        take_token();
        expr.braced = true;
        expr.span = span_since(from);
        only_in(Dialect::legos, expr.span, "a measure in braces");
        return std::make_shared<const Expr>(std::move(expr));
    }
    if (peek().kind == Tok::number) {
        expr.op = Op::number;
        expr.text = std::string(take_token().text);
        expr.span = from;
        return std::make_shared<const Expr>(std::move(expr));
    }
    return parse_word();
}

ExprPtr Parser::parse_word() {
    Expr expr;
    expr.span = peek().span;
    if (is_at("true") || is_at("false")) {
        expr.op = Op::truth;
        expr.text = std::string(take_token().text);
    } else if (is_at("in") && at_name(1) && !measures_.contains("in")) {
        take_token();
        expr.op = Op::in_state;
        expr.text = qualified_name("a state").text;
        expr.span = span_since(expr.span);
        report_first_extension(expr.span, "in STATE");
    } else {
        if (is_at("-")) refuse_construct("negative numbers", peek().span);
        expr.op = Op::name;
        expr.text = simple_name("a condition").text;
        if (measures_.contains(expr.text)) only_in(Dialect::sleec_tk, expr.span, "a measure without braces");
    }
    return std::make_shared<const Expr>(std::move(expr));
}

}  // namespace robochart::sleec
