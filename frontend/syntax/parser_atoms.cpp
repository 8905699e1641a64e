// SPDX-License-Identifier: Apache-2.0
// Parses literals, names and forms in brackets (RoboChart.xtext: Atomic).
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "frontend/syntax/parser.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

ExprPtr Parser::parse_atom() {
    if (probabilistic_)
        if (ExprPtr read = probabilistic_atom()) return read;
    switch (peek().kind) {
        case TokenKind::integer:
            return parse_literal(ExprKind::integer);
        case TokenKind::real:
            return parse_literal(ExprKind::real);
        case TokenKind::string:
            return parse_literal(ExprKind::string);
        case TokenKind::identifier:
            return parse_named();
        case TokenKind::keyword:
            return keyword_atom();
        case TokenKind::symbol:
            return parse_bracketed();
        case TokenKind::end:
        case TokenKind::csp_code:
            break;
    }
    return missing_expression();
}

/// Reports that an expression is missing, and returns an error node in its place.
ExprPtr Parser::missing_expression() {
    const Span place = missing_place();
    report_missing("an expression");
    auto result = std::make_unique<Expr>();
    result->span = {source_, place.begin, place.begin};
    return result;
}

ExprPtr Parser::parse_literal(ExprKind kind) {
    ExprPtr result = make_expression(kind);
    result->text = std::string(advance_token().text);
    if (kind == ExprKind::integer || kind == ExprKind::real) pass_suffix();
    return result;
}

/// Skips a suffix of a number, as in `30.5f`.
void Parser::pass_suffix() {
    const Token suffix = peek();
    const bool adjacent = suffix.span.begin == previous_token().span.end && !suffix.escaped;
    constexpr std::string_view letters = "fFlLuU";
    if (suffix.kind != TokenKind::identifier || !adjacent) return;
    if (suffix.text.find_first_not_of(letters) != std::string_view::npos) return;  // `1e5` is not 1 with a suffix
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, suffix.span, {std::string(suffix.text), "a number has no suffix"});
    if (finding != nullptr) finding->fixes.push_back({suffix.span, "", "leave it out"});
    quiet_until_ = 0;
    advance_token();
}

/// Parses `x`, `E::L`, or a record `R(| f = e |)`.
ExprPtr Parser::parse_named() {
    ExprPtr result = make_expression(ExprKind::name);
    QualifiedName read = qualified_name("a name");
    if (at_token("(|")) return parse_record(std::move(read));
    result->span = read.span;
    result->name = std::move(read);
    return probabilistic_ ? behind_name(std::move(result)) : std::move(result);
}

ExprPtr Parser::parse_record(QualifiedName type_name) {
    ExprPtr result = make_expression(ExprKind::record);
    const Span begin = type_name.span;
    result->name = std::move(type_name);
    expect_token("(|");
    do {
        Binding binding;
        binding.variable = std::make_unique<Variable>(DeclKind::field);
        binding.variable->span = peek().span;
        name(*binding.variable);
        expect_token("=");
        binding.value = parse_expression();
        result->bindings.push_back(std::move(binding));
    } while (accept_token(","));
    expect_token("|)");
    return finish_node(std::move(result), begin);
}

ExprPtr Parser::keyword_atom() {
    if (at_token("true") || at_token("false")) return parse_literal(ExprKind::boolean);
    if (at_token("cycle")) return parse_cycle();
    constexpr std::array<std::pair<std::string_view, ExprKind>, 7> kinds = {{{"result", ExprKind::result},
                                                                             {"to", ExprKind::to},
                                                                             {"from", ExprKind::from},
                                                                             {"inverse", ExprKind::inverse},
                                                                             {"transpose", ExprKind::transpose},
                                                                             {"since", ExprKind::since},
                                                                             {"sinceEntry", ExprKind::since_entry}}};
    const auto* const found = std::ranges::find_if(kinds, [&](const auto& entry) { return at_token(entry.first); });
    if (found == kinds.end()) return missing_expression();
    const ExprKind kind = found->second;
    ExprPtr result = make_expression(kind);
    const Span begin = advance_token().span;
    if (kind == ExprKind::result || kind == ExprKind::to || kind == ExprKind::from) return result;
    expect_token("(");
    if (kind == ExprKind::since)
        result->name = plain_name("the name of a clock");
    else if (kind == ExprKind::since_entry)
        result->name = qualified_name("the name of a state");
    else
        result->args.push_back(parse_expression());
    expect_token(")");
    return finish_node(std::move(result), begin);
}

ExprPtr Parser::parse_bracketed() {
    if (at_token("$")) return parse_register();
    if (at_token("(")) return parenthesised_or_range();
    if (at_token("[")) return closed_range();
    if (at_token("(|")) return parse_tuple();
    if (at_token("[|")) return parse_matrix();
    if (at_token("{")) return parse_set();
    if (at_token("<") || at_token("<{")) return parse_sequence();
    return missing_expression();
}

/// Parses the rest of a range after its comma: `b]` or `b)`.
void Parser::range_end(Expr& range) {
    range.args.push_back(parse_expression());
    range.upper_closed = at_token("]");
    if (!accept_token("]") && !accept_token(")")) fail_expecting("`]` or `)`");
}

/// Parses `(e)`, `(a, b]` or `(a, b)`.
ExprPtr Parser::parenthesised_or_range() {
    ExprPtr result = make_expression(ExprKind::parenthesised);
    const Span begin = expect_token("(");
    result->args.push_back(parse_expression());
    if (accept_token(",")) {
        result->kind = ExprKind::range;
        result->lower_closed = false;
        range_end(*result);
    } else {
        expect_token(")");
    }
    return finish_node(std::move(result), begin);
}

/// Parses `[a, b]` or `[a, b)`.
ExprPtr Parser::closed_range() {
    ExprPtr result = make_expression(ExprKind::range);
    const Span begin = expect_token("[");
    result->args.push_back(parse_expression());
    expect_token(",");
    range_end(*result);
    return finish_node(std::move(result), begin);
}

/// Parses `(| a, b |)`.
ExprPtr Parser::parse_tuple() {
    ExprPtr result = make_expression(ExprKind::tuple);
    const Span begin = expect_token("(|");
    expression_list(result->args, "|)");
    return finish_node(std::move(result), begin);
}

/// Parses `< a, b >`. Elements contain only operators that bind at least as tightly as `+`, so that `>` closes the
/// sequence. If a sequence begins with a set, the lexer has read the token `<{` of deadlines, which this function
/// splits.
ExprPtr Parser::parse_sequence() {
    const Nesting nesting(*this);
    ExprPtr result = make_expression(ExprKind::sequence);
    const Span begin = peek().span;
    if (at_token("<{")) {
        tokens_.drop_first_character(at_);
    } else {
        expect_token("<");
    }
    if (!at_token(">")) {
        do result->args.push_back(sequence_element());
        while (accept_token(",") || missing_comma());
    }
    expect_token(">");
    return finish_node(std::move(result), begin);
}

/// Parses an element of a sequence. An operator that binds less tightly than `+` is reported and read as intended.
ExprPtr Parser::sequence_element() {
    constexpr int plus_level = 10;
    ExprPtr element = parse_operand(plus_level);
    bool weaker = false;
    while (!at_token(">") && (operator_here() || at_token("as") || at_token("is"))) {
        weaker = true;
        if (const auto next = operator_here())
            element = parse_infix(std::move(element), next->first, plus_level - 1);
        else
            element = parse_cast(std::move(element));
    }
    if (weaker) needs_parentheses("an operator weaker than `+` in a sequence", element->span);
    return element;
}

/// Parses `{a, b}`, `{a to b}` or `{v:T | p @ e}`.
ExprPtr Parser::parse_set() {
    ExprPtr result = make_expression(ExprKind::set);
    const Span begin = expect_token("{");
    if (peek().kind == TokenKind::identifier && peek(1).is_word(":")) return parse_comprehension(begin);
    if (accept_token("}")) return finish_node(std::move(result), begin);
    result->args.push_back(parse_expression());
    if (accept_token("to")) {
        result->kind = ExprKind::set_range;
        result->args.push_back(parse_expression());
        if (probabilistic_ && accept_word("by")) {
            expect_word("step");
            result->args.push_back(parse_expression());
        }
    } else {
        while (accept_token(",")) result->args.push_back(parse_expression());
    }
    expect_token("}");
    return finish_node(std::move(result), begin);
}

ExprPtr Parser::parse_comprehension(Span begin) {
    ExprPtr result = make_expression(ExprKind::set_comprehension);
    parse_bindings(*result);
    such_that(*result);
    result->args.push_back(accept_token("@") ? parse_expression() : nullptr);
    expect_token("}");
    return finish_node(std::move(result), begin);
}

/// Parses a matrix `[| a, b; c, d |]`. Without `;`, the form is a vector.
ExprPtr Parser::parse_matrix() {
    ExprPtr result = make_expression(ExprKind::matrix);
    const Span begin = expect_token("[|");
    bool ragged = false;
    do {
        const Span row = peek().span;
        const std::size_t before = result->args.size();
        do result->args.push_back(parse_expression());
        while (accept_token(","));
        const std::size_t entries = result->args.size() - before;
        if (before == 0) result->columns = entries;
        if (entries == result->columns) continue;
        ragged = true;
        report(syntax::ragged_matrix, span_since(row), {std::to_string(entries), std::to_string(result->columns)});
    } while (accept_token(";"));
    expect_token("|]");
    if (ragged) result->columns = 0;  // the matrix has no type
    return finish_node(std::move(result), begin);
}

}  // namespace robochart::frontend
