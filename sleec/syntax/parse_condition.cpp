// SPDX-License-Identifier: Apache-2.0
// Conditions. See parser.hpp.
#include "sleec/syntax/parser.hpp"
#include "sleec/syntax/printer.hpp"
#include "sleec/syntax/rules.hpp"

namespace robochart::sleec {
namespace {

bool is_junction(const ExprPtr& expr) {
    return expr->op == Op::conjunction || expr->op == Op::disjunction;
}

}  // namespace

ExprPtr Parser::node(Op op, Span from, std::vector<ExprPtr> parts) {
    Expr expr;
    expr.op = op;
    expr.span = since(from);
    expr.parts = std::move(parts);
    return std::make_shared<const Expr>(std::move(expr));
}

/// Chains of operators may be long. Their trees are left-deep, so traversals recurse as deep as the chain is long.
ExprPtr Parser::condition() {
    const Depth depth(*this);
    const Span from = peek().span;
    ExprPtr left = term();
    unsigned length = 0;
    bool mixed = false;
    while (at("and") || at("or")) {
        if (++length > max_depth) deeper();
        const Op op = take().text == "and" ? Op::conjunction : Op::disjunction;
        mixed = mixed || (length > 1 && left->op != op);
        left = node(op, from, {left, term()});
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

/// `not` applies to one comparison.
ExprPtr Parser::term() {
    const Depth depth(*this);
    if (!at("not")) return relation();
    const Span from = take().span;
    return node(Op::negation, from, {term()});
}

ExprPtr Parser::relation() {
    const Span from = peek().span;
    ExprPtr left = sum();
    for (const Op op : {Op::less, Op::less_equal, Op::greater, Op::greater_equal, Op::equal, Op::unequal}) {
        if (!accept(symbol_of(op))) continue;
        ExprPtr right = sum();
        return node(op, from, {std::move(left), std::move(right)});
    }
    return left;
}

ExprPtr Parser::sum() {
    const Span from = peek().span;
    ExprPtr left = product();
    unsigned length = 0;
    while (at("+") || at("-")) {
        if (++length > max_depth) deeper();
        const Token& token = take();
        only_in(Dialect::legos, token.span, "arithmetic");
        left = node(token.text == "+" ? Op::add : Op::subtract, from, {left, product()});
    }
    if (length > max_depth) depth_ -= length - max_depth;
    return left;
}

ExprPtr Parser::product() {
    const Span from = peek().span;
    ExprPtr left = primary();
    unsigned length = 0;
    while (at("*")) {
        if (++length > max_depth) deeper();
        only_in(Dialect::legos, take().span, "arithmetic");
        left = node(Op::multiply, from, {left, primary()});
    }
    if (length > max_depth) depth_ -= length - max_depth;
    return left;
}

ExprPtr Parser::primary() {
    const Depth depth(*this);
    const Span from = peek().span;
    if (accept("(")) {
        Expr inner = *condition();
        expect(")");
        inner.bracketed = true;
        inner.span = since(from);
        return std::make_shared<const Expr>(std::move(inner));
    }
    Expr expr;
    if (accept("{")) {
        expr.op = Op::name;
        expr.text = name("the name of a measure").text;
        if (!at("}")) fail("'}' (braces hold the name of one measure)");
        take();
        expr.braced = true;
        expr.span = since(from);
        only_in(Dialect::legos, expr.span, "a measure in braces");
        return std::make_shared<const Expr>(std::move(expr));
    }
    if (peek().kind == Tok::number) {
        expr.op = Op::number;
        expr.text = std::string(take().text);
        expr.span = from;
        return std::make_shared<const Expr>(std::move(expr));
    }
    return word();
}

ExprPtr Parser::word() {
    Expr expr;
    expr.span = peek().span;
    if (at("true") || at("false")) {
        expr.op = Op::truth;
        expr.text = std::string(take().text);
    } else {
        if (at("-")) refuse("negative numbers", peek().span);
        expr.op = Op::name;
        expr.text = name("a condition").text;
        if (measures_.contains(expr.text)) only_in(Dialect::sleec_tk, expr.span, "a measure without braces");
    }
    return std::make_shared<const Expr>(std::move(expr));
}

}  // namespace robochart::sleec
