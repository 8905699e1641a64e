// SPDX-License-Identifier: Apache-2.0
// Operator precedence parser (RoboChart.xtext: Expression to CallExp). Binary operators are left-associative.
#include <fmt/format.h>

#include <algorithm>

#include "frontend/syntax/operators.hpp"
#include "frontend/syntax/parser.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

namespace {

/// The level of the form at the root of a tree; an operator that binds more tightly cannot follow it.
int own_level(const Expr& expr) {
    if (expr.kind == ExprKind::if_then_else) return if_level;
    return expr.kind == ExprKind::cast || expr.kind == ExprKind::is_type ? cast_level : concat_level;
}

std::string_view described(const Expr& expr) {
    return expr.kind == ExprKind::if_then_else ? "an `if` before an operator" : "a cast before another operator";
}

std::uint32_t height(const ExprPtr& expr) {
    return expr ? expr->height : 0;
}

}  // namespace

ExprPtr Parser::make(ExprKind kind) {
    auto expr = std::make_unique<Expr>();
    expr->kind = kind;
    expr->span = peek().span;
    return expr;
}

/// Completes a node: its span and the height of the tree, which bounds every later traversal.
ExprPtr Parser::finish(ExprPtr expr, Span begin) {
    expr->span = since(begin);
    std::uint32_t below = height(expr->callee);
    for (const ExprPtr& arg : expr->args) below = std::max(below, height(arg));
    for (const Binding& binding : expr->bindings) below = std::max(below, height(binding.value));
    expr->height = below + 1;
    if (expr->height > max_height) too_deep(max_height);
    return expr;
}

std::optional<std::pair<BinaryOp, int>> Parser::operator_here() const {
    const BinaryOperator* found = binary_operator(peek());
    if (found == nullptr) return std::nullopt;
    return std::pair(found->op, found->level);
}

bool Parser::at_quantifier() const {
    return at("forall") || at("exists") || at("exists1") || at("lambda");
}

ExprPtr Parser::expression() {
    const Nesting nesting(*this);
    return at_quantifier() ? quantified() : operand(0);
}

/// `forall v:T, … | p @ e`, and the same form with exists, exists1 and lambda.
ExprPtr Parser::quantified() {
    ExprPtr result = make(at("forall")    ? ExprKind::forall
                          : at("exists")  ? ExprKind::exists
                          : at("exists1") ? ExprKind::exists_unique
                                          : ExprKind::lambda);
    advance();
    bindings(*result);
    such_that(*result);
    expect("@");
    result->args.push_back(expression());
    const Span begin = result->span;
    return finish(std::move(result), begin);
}

void Parser::bindings(Expr& expr) {
    do {
        std::vector<VariablePtr> read;
        variable(read, DeclKind::bound_variable);
        expr.bindings.push_back({std::move(read.front()), nullptr});
    } while (accept(","));
}

void Parser::such_that(Expr& expr) {
    expr.args.push_back(accept("|") ? expression() : nullptr);
}

/// An expression whose operators bind at least as tightly as `level`.
ExprPtr Parser::operand(int level) {
    ExprPtr left = prefix(level);
    for (;;) {
        if (probabilistic_ && at_word("Until") && level <= not_level) {
            left = until(std::move(left));
            continue;
        }
        const bool casts = (at("as") || at("is")) && level <= cast_level;
        if (!casts && (repair_equality(level) || foreign_operator() || percentage(*left))) continue;
        const auto next = operator_here();
        if (!casts && (!next || next->second < level)) return left;
        const int binding = casts ? cast_level + 1 : next->second;
        if (binding > own_level(*left) && own_level(*left) < concat_level)
            needs_parentheses(described(*left), left->span);
        left = casts ? cast(std::move(left)) : infix(std::move(left), next->first, next->second);
    }
}

/// `=` between expressions is read as `==`.
bool Parser::repair_equality(int level) {
    if (!at("=") || level > compare_level) return false;
    const Span span = peek().span;
    if (diagnostics::Diagnostic* finding = report(syntax::single_equal, span); finding != nullptr && !peek(1).is("?"))
        finding->fixes.push_back({span, "==", "write"});
    tokens_.correct(at_, TokenKind::symbol, "==");
    quiet_until_ = 0;
    return true;
}

ExprPtr Parser::infix(ExprPtr left, BinaryOp op, int level) {
    if (at("&&") || at("||")) report_c_operator(at("&&") ? "/\\" : "\\/");
    if (peek().escaped)
        tokens_.drop_first_character(at_);
    else
        advance();
    ExprPtr result = make(ExprKind::binary);
    const Span begin = left->span;
    result->binary = op;
    result->args.push_back(std::move(left));
    result->args.push_back(operand(level + 1));
    return finish(std::move(result), begin);
}

ExprPtr Parser::cast(ExprPtr left) {
    ExprPtr result = make(at("as") ? ExprKind::cast : ExprKind::is_type);
    const Span begin = left->span;
    advance();
    result->args.push_back(std::move(left));
    result->type_expr = type();
    return finish(std::move(result), begin);
}

ExprPtr Parser::prefix(int level) {
    if (at("not")) return logical_not(level);
    if (at("the")) return description(level);
    if (at("let")) return let(level);
    if (at("if")) return conditional(level);
    if (probabilistic_ && at_path_prefix()) return path_prefix();
    if (at("!") && peek(1).kind != TokenKind::end) {
        report_c_operator("not ");
        tokens_.correct(at_, TokenKind::keyword, "not");
        return logical_not(level);
    }
    if (!at_quantifier()) return negation();
    const Token word = peek();
    ExprPtr result = expression();
    check_weak_prefix(word, *result, 1, 0);
    return result;
}

/// A prefix operator as operand of an operator that binds more tightly needs parentheses; it is read as intended.
void Parser::check_weak_prefix(const Token& word, const Expr& read, int level, int own_level) {
    if (level <= own_level) return;
    diagnostics::Diagnostic* finding = report(syntax::bare_quantifier, word.span, {std::string(word.text)});
    if (finding == nullptr) return;
    const std::string text(sources_.text(source_).substr(read.span.begin, read.span.end - read.span.begin));
    finding->fixes.push_back({read.span, "(" + text + ")", "write"});
}

void Parser::report_c_operator(std::string_view meant) {
    const Token token = peek();
    const std::string name(meant.substr(0, meant.find(' ')));
    if (diagnostics::Diagnostic* finding = report(syntax::c_operator, token.span, {std::string(token.text), name}))
        finding->fixes.push_back({token.span, std::string(meant), "write"});
    quiet_until_ = 0;
}

ExprPtr Parser::logical_not(int level) {
    const Nesting nesting(*this);
    ExprPtr result = make(ExprKind::unary);
    const Token word = peek();
    const Span begin = expect("not");
    result->unary = UnaryOp::logical_not;
    const bool again = at("not") || at("!");
    result->args.push_back(again ? prefix(not_level) : operand(probabilistic_ ? not_level : compare_level));
    result = finish(std::move(result), begin);
    check_weak_prefix(word, *result, level, not_level);
    return result;
}

/// `the v:T | p @ e`
ExprPtr Parser::description(int level) {
    const Nesting nesting(*this);
    ExprPtr result = make(ExprKind::the);
    const Token word = peek();
    const Span begin = expect("the");
    bindings(*result);
    such_that(*result);
    expect("@");
    result->args.push_back(operand(the_level));
    result = finish(std::move(result), begin);
    check_weak_prefix(word, *result, level, the_level);
    return result;
}

/// `let x == e, … @ e`
ExprPtr Parser::let(int level) {
    const Nesting nesting(*this);
    ExprPtr result = make(ExprKind::let);
    const Token word = peek();
    const Span begin = expect("let");
    do {
        Binding binding;
        binding.variable = std::make_unique<Variable>(DeclKind::bound_variable);
        binding.variable->span = peek().span;
        name(*binding.variable);
        if (!repair_equality(0))
            expect("==");
        else
            advance();
        binding.value = expression();
        binding.variable->span = since(binding.variable->span);
        result->bindings.push_back(std::move(binding));
    } while (accept(","));
    expect("@");
    result->args.push_back(operand(let_level));
    result = finish(std::move(result), begin);
    check_weak_prefix(word, *result, level, let_level);
    return result;
}

/// `if c then a else b end`
ExprPtr Parser::conditional(int level) {
    ExprPtr result = make(ExprKind::if_then_else);
    const Token word = peek();
    const Span begin = expect("if");
    result->args.push_back(expression());
    expect("then");
    result->args.push_back(expression());
    expect("else");
    result->args.push_back(expression());
    expect("end");
    result = finish(std::move(result), begin);
    check_weak_prefix(word, *result, level, if_level);
    return result;
}

ExprPtr Parser::negation() {
    if (!at("-")) return postfix();
    const Nesting nesting(*this);
    ExprPtr result = make(ExprKind::unary);
    const Span begin = expect("-");
    result->unary = UnaryOp::negate;
    result->args.push_back(negation());
    return finish(std::move(result), begin);
}

/// In assertion files `.` may also end the assertion; there, a field must follow `.` directly.
bool Parser::at_member_step() const {
    const Token next = peek(1);
    const bool field = next.kind == TokenKind::identifier && next.span.begin == peek().span.end;
    return at(".") && (!is_assertions_ || field);
}

ExprPtr Parser::postfix() {
    return steps(call(), false);
}

/// Member and index steps: `e.f`, `e[i, j]`. In expressions, at most one index is allowed, before the members.
ExprPtr Parser::steps(ExprPtr left, bool assigned) {
    while (at_member_step() || at("[")) {
        const bool stepped = left->kind == ExprKind::member || left->kind == ExprKind::index;
        if (at("[") && stepped && !assigned)
            needs_parentheses("what is indexed after a field or another index", left->span);
        ExprPtr step = make(at(".") ? ExprKind::member : ExprKind::index);
        const Span begin = left->span;
        step->args.push_back(std::move(left));
        if (accept(".")) {
            step->name = simple_name("the name of a field");
            step->text = step->name.parts.front();
        } else {
            expect("[");
            do step->args.push_back(expression());
            while (accept(","));
            expect("]");
        }
        left = finish(std::move(step), begin);
    }
    return left;
}

/// `f(a, …)`; the function is a name or any other atom.
ExprPtr Parser::call() {
    ExprPtr function = atom();
    while (at("(")) {
        if (function->kind == ExprKind::call) needs_parentheses("a call that is called again", function->span);
        ExprPtr result = make(ExprKind::call);
        const Span begin = function->span;
        advance();
        if (function->kind == ExprKind::name)
            result->name = std::move(function->name);
        else
            result->callee = std::move(function);
        expression_list(result->args, ")");
        function = finish(std::move(result), begin);
    }
    return function;
}

/// `e, …` up to and including the closing token; may be empty.
void Parser::expression_list(std::vector<ExprPtr>& list, std::string_view close) {
    if (!at(close)) {
        do list.push_back(expression());
        while (accept(",") || missing_comma());
    }
    expect(close);
}

/// True if two items are adjacent, so that the comma between them is missing.
bool Parser::missing_comma() {
    const TokenKind kind = peek().kind;
    const bool item = kind == TokenKind::identifier || kind == TokenKind::integer || kind == TokenKind::real;
    if (!item || peek().first_on_line || peek().escaped || at_ < quiet_until_) return false;
    if (peek().span.begin == previous().span.end) return false;  // `1e5` is not a list
    const Span place{source_, previous().span.end, previous().span.end};
    diagnostics::Diagnostic* finding = report(syntax::unexpected, peek().span, {"`,`", found()});
    if (finding != nullptr) finding->fixes.push_back({place, ",", "insert"});
    inserted_ = finding;
    return true;
}

}  // namespace robochart::frontend
