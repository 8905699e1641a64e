// SPDX-License-Identifier: Apache-2.0
// Parses operators by their precedence (RoboChart.xtext: Expression to CallExp). Binary operators are left-associative.
#include <fmt/format.h>

#include <algorithm>

#include "frontend/syntax/operators.hpp"
#include "frontend/syntax/parser.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

namespace {

/// Returns the level of the form at the root of a tree. An operator that binds more tightly cannot follow this form.
int own_level(const Expr& expr) {
    if (expr.kind == ExprKind::if_then_else) return if_level;
    return expr.kind == ExprKind::cast || expr.kind == ExprKind::is_type ? cast_level : concat_level;
}

std::string_view describe_form(const Expr& expr) {
    return expr.kind == ExprKind::if_then_else ? "an `if` before an operator" : "a cast before another operator";
}

std::uint32_t height(const ExprPtr& expr) {
    return expr ? expr->height : 0;
}

}  // namespace

ExprPtr Parser::make_expression(ExprKind kind) {
    auto expr = std::make_unique<Expr>();
    expr->kind = kind;
    expr->span = peek().span;
    return expr;
}

/// Completes a node: sets its span and its height. The height is limited, because every later traversal is recursive.
ExprPtr Parser::finish_node(ExprPtr expr, Span begin) {
    expr->span = span_since(begin);
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
    return at_token("forall") || at_token("exists") || at_token("exists1") || at_token("lambda");
}

ExprPtr Parser::parse_expression() {
    const Nesting nesting(*this);
    return at_quantifier() ? parse_quantified() : parse_operand(0);
}

/// Parses `forall v:T, … | p @ e`, and the same form with exists, exists1 and lambda.
ExprPtr Parser::parse_quantified() {
    ExprPtr result = make_expression(ExprKind::lambda);
    if (at_token("forall")) result->kind = ExprKind::forall;
    if (at_token("exists")) result->kind = ExprKind::exists;
    if (at_token("exists1")) result->kind = ExprKind::exists_unique;
    advance_token();
    parse_bindings(*result);
    such_that(*result);
    expect_token("@");
    result->args.push_back(parse_expression());
    const Span begin = result->span;
    return finish_node(std::move(result), begin);
}

void Parser::parse_bindings(Expr& expr) {
    do {
        std::vector<VariablePtr> read;
        parse_variable(read, DeclKind::bound_variable);
        expr.bindings.push_back({std::move(read.front()), nullptr});
    } while (accept_token(","));
}

void Parser::such_that(Expr& expr) {
    expr.args.push_back(accept_token("|") ? parse_expression() : nullptr);
}

/// Reads an expression whose operators bind at least as tightly as `level`.
ExprPtr Parser::parse_operand(int level) {
    ExprPtr left = parse_prefix(level);
    for (;;) {
        if (probabilistic_ && at_word("Until") && level <= not_level) {
            left = parse_until(std::move(left));
            continue;
        }
        const bool casts = (at_token("as") || at_token("is")) && level <= cast_level;
        if (!casts && (repair_equality(level) || foreign_operator() || parse_percentage(*left))) continue;
        const auto next = operator_here();
        if (!casts && (!next || next->second < level)) return left;
        const int binding = casts ? cast_level + 1 : next->second;
        if (binding > own_level(*left) && own_level(*left) < concat_level)
            needs_parentheses(describe_form(*left), left->span);
        left = casts ? parse_cast(std::move(left)) : parse_infix(std::move(left), next->first, next->second);
    }
}

/// Reports `=` between expressions and reads it as `==`.
bool Parser::repair_equality(int level) {
    if (!at_token("=") || level > compare_level) return false;
    const Span span = peek().span;
    if (diagnostics::Diagnostic* finding = report(syntax::single_equal, span);
        finding != nullptr && !peek(1).is_word("?"))
        finding->fixes.push_back({span, "==", "write"});
    tokens_.correct_token(at_, TokenKind::symbol, "==");
    quiet_until_ = 0;
    return true;
}

ExprPtr Parser::parse_infix(ExprPtr left, BinaryOp op, int level) {
    if (at_token("&&") || at_token("||")) report_c_operator(at_token("&&") ? "/\\" : "\\/");
    if (peek().escaped)
        tokens_.drop_first_character(at_);
    else
        advance_token();
    ExprPtr result = make_expression(ExprKind::binary);
    const Span begin = left->span;
    result->binary = op;
    result->args.push_back(std::move(left));
    result->args.push_back(parse_operand(level + 1));
    return finish_node(std::move(result), begin);
}

ExprPtr Parser::parse_cast(ExprPtr left) {
    ExprPtr result = make_expression(at_token("as") ? ExprKind::cast : ExprKind::is_type);
    const Span begin = left->span;
    advance_token();
    result->args.push_back(std::move(left));
    result->type_expr = parse_type();
    return finish_node(std::move(result), begin);
}

ExprPtr Parser::parse_prefix(int level) {
    if (at_token("not")) return logical_not(level);
    if (at_token("the")) return parse_description(level);
    if (at_token("let")) return parse_let(level);
    if (at_token("if")) return parse_conditional(level);
    if (probabilistic_ && at_path_prefix()) return path_prefix();
    if (at_token("!") && peek(1).kind != TokenKind::end) {
        report_c_operator("not ");
        tokens_.correct_token(at_, TokenKind::keyword, "not");
        return logical_not(level);
    }
    if (!at_quantifier()) return parse_negation();
    const Token word = peek();
    ExprPtr result = parse_expression();
    check_weak_prefix(word, *result, 1, 0);
    return result;
}

/// Reports an operand that begins with a prefix operator, if the operator around it binds more tightly, so that
/// parentheses are needed. The operand is read as intended.
void Parser::check_weak_prefix(const Token& word, const Expr& read, int level, int own_level) {
    if (level <= own_level) return;
    diagnostics::Diagnostic* finding = report(syntax::bare_quantifier, word.span, {std::string(word.text)});
    if (finding == nullptr) return;
    const std::string text(sources_.source_text(source_).substr(read.span.begin, read.span.end - read.span.begin));
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
    ExprPtr result = make_expression(ExprKind::unary);
    const Token word = peek();
    const Span begin = expect_token("not");
    result->unary = UnaryOp::logical_not;
    const bool again = at_token("not") || at_token("!");
    const int operand_level = probabilistic_ ? not_level : compare_level;
    result->args.push_back(again ? parse_prefix(not_level) : parse_operand(operand_level));
    result = finish_node(std::move(result), begin);
    check_weak_prefix(word, *result, level, not_level);
    return result;
}

/// Parses `the v:T | p @ e`.
ExprPtr Parser::parse_description(int level) {
    const Nesting nesting(*this);
    ExprPtr result = make_expression(ExprKind::the);
    const Token word = peek();
    const Span begin = expect_token("the");
    parse_bindings(*result);
    such_that(*result);
    expect_token("@");
    result->args.push_back(parse_operand(the_level));
    result = finish_node(std::move(result), begin);
    check_weak_prefix(word, *result, level, the_level);
    return result;
}

/// Parses `let x == e, … @ e`.
ExprPtr Parser::parse_let(int level) {
    const Nesting nesting(*this);
    ExprPtr result = make_expression(ExprKind::let);
    const Token word = peek();
    const Span begin = expect_token("let");
    do {
        Binding binding;
        binding.variable = std::make_unique<Variable>(DeclKind::bound_variable);
        binding.variable->span = peek().span;
        name(*binding.variable);
        if (!repair_equality(0))
            expect_token("==");
        else
            advance_token();
        binding.value = parse_expression();
        binding.variable->span = span_since(binding.variable->span);
        result->bindings.push_back(std::move(binding));
    } while (accept_token(","));
    expect_token("@");
    result->args.push_back(parse_operand(let_level));
    result = finish_node(std::move(result), begin);
    check_weak_prefix(word, *result, level, let_level);
    return result;
}

/// Parses `if c then a else b end`.
ExprPtr Parser::parse_conditional(int level) {
    ExprPtr result = make_expression(ExprKind::if_then_else);
    const Token word = peek();
    const Span begin = expect_token("if");
    result->args.push_back(parse_expression());
    expect_token("then");
    result->args.push_back(parse_expression());
    expect_token("else");
    result->args.push_back(parse_expression());
    expect_token("end");
    result = finish_node(std::move(result), begin);
    check_weak_prefix(word, *result, level, if_level);
    return result;
}

ExprPtr Parser::parse_negation() {
    if (!at_token("-")) return parse_postfix();
    const Nesting nesting(*this);
    ExprPtr result = make_expression(ExprKind::unary);
    const Span begin = expect_token("-");
    result->unary = UnaryOp::negate;
    result->args.push_back(parse_negation());
    return finish_node(std::move(result), begin);
}

/// True if the name of a member follows. In assertion files `.` may also end the assertion, so the name must follow `.`
/// directly.
bool Parser::at_member_step() const {
    const Token next = peek(1);
    const bool field = next.kind == TokenKind::identifier && next.span.begin == peek().span.end;
    return at_token(".") && (!is_assertions_ || field);
}

ExprPtr Parser::parse_postfix() {
    return parse_steps(parse_call(), false);
}

/// Parses members and indices after an expression: `e.f`, `e[i, j]`. In expressions, at most one index is allowed,
/// before the members.
ExprPtr Parser::parse_steps(ExprPtr left, bool assigned) {
    while (at_member_step() || at_token("[")) {
        const bool stepped = left->kind == ExprKind::member || left->kind == ExprKind::index;
        if (at_token("[") && stepped && !assigned)
            needs_parentheses("what is indexed after a field or another index", left->span);
        ExprPtr step = make_expression(at_token(".") ? ExprKind::member : ExprKind::index);
        const Span begin = left->span;
        step->args.push_back(std::move(left));
        if (accept_token(".")) {
            step->name = simple_name("the name of a field");
            step->text = step->name.parts.front();
        } else {
            expect_token("[");
            do step->args.push_back(parse_expression());
            while (accept_token(","));
            expect_token("]");
        }
        left = finish_node(std::move(step), begin);
    }
    return left;
}

/// Parses `f(a, …)`. The function is a name or any other atom.
ExprPtr Parser::parse_call() {
    ExprPtr function = parse_atom();
    while (at_token("(")) {
        if (function->kind == ExprKind::call) needs_parentheses("a call that is called again", function->span);
        ExprPtr result = make_expression(ExprKind::call);
        const Span begin = function->span;
        advance_token();
        if (function->kind == ExprKind::name)
            result->name = std::move(function->name);
        else
            result->callee = std::move(function);
        expression_list(result->args, ")");
        function = finish_node(std::move(result), begin);
    }
    return function;
}

/// Parses `e, …` up to and including the closing token. The list may be empty.
void Parser::expression_list(std::vector<ExprPtr>& list, std::string_view close) {
    if (!at_token(close)) {
        do list.push_back(parse_expression());
        while (accept_token(",") || missing_comma());
    }
    expect_token(close);
}

/// True if two items are adjacent, so that the comma between them is missing.
bool Parser::missing_comma() {
    const TokenKind kind = peek().kind;
    const bool item = kind == TokenKind::identifier || kind == TokenKind::integer || kind == TokenKind::real;
    if (!item || peek().first_on_line || peek().escaped || at_ < quiet_until_) return false;
    if (peek().span.begin == previous_token().span.end) return false;  // `1e5` is not a list
    const Span place{source_, previous_token().span.end, previous_token().span.end};
    diagnostics::Diagnostic* finding = report(syntax::unexpected, peek().span, {"`,`", describe_token()});
    if (finding != nullptr) finding->fixes.push_back({place, ",", "insert"});
    inserted_ = finding;
    return true;
}

}  // namespace robochart::frontend
