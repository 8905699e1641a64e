// SPDX-License-Identifier: Apache-2.0
// Literals, names and bracketed forms (RoboChart.xtext: Atomic).
#include <fmt/format.h>

#include "frontend/syntax/parser.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

ExprPtr Parser::atom() {
    if (probabilistic_)
        if (ExprPtr read = probabilistic_atom()) return read;
    switch (peek().kind) {
        case TokenKind::integer:
            return literal(ExprKind::integer);
        case TokenKind::real:
            return literal(ExprKind::real);
        case TokenKind::string:
            return literal(ExprKind::string);
        case TokenKind::identifier:
            return named();
        case TokenKind::keyword:
            return keyword_atom();
        case TokenKind::symbol:
            return bracketed();
        default:
            return missing_expression();
    }
}

/// No expression begins here; an error node takes its place.
ExprPtr Parser::missing_expression() {
    const Span place = missing_place();
    missing("an expression");
    auto result = std::make_unique<Expr>();
    result->span = {source_, place.begin, place.begin};
    return result;
}

ExprPtr Parser::literal(ExprKind kind) {
    ExprPtr result = make(kind);
    result->text = std::string(advance().text);
    if (kind == ExprKind::integer || kind == ExprKind::real) pass_suffix();
    return result;
}

/// Skips a suffix of a number, as in `30.5f`.
void Parser::pass_suffix() {
    const Token suffix = peek();
    const bool adjacent = suffix.span.begin == previous().span.end && !suffix.escaped;
    constexpr std::string_view letters = "fFlLuU";
    if (suffix.kind != TokenKind::identifier || !adjacent) return;
    if (suffix.text.find_first_not_of(letters) != std::string_view::npos) return;  // `1e5` is not 1 with a suffix
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, suffix.span, {std::string(suffix.text), "a number has no suffix"});
    if (finding != nullptr) finding->fixes.push_back({suffix.span, "", "leave it out"});
    quiet_until_ = 0;
    advance();
}

/// `x`, `E::L`, or a record `R(| f = e |)`.
ExprPtr Parser::named() {
    ExprPtr result = make(ExprKind::name);
    QualifiedName read = qualified_name("a name");
    if (at("(|")) return record(std::move(read));
    result->span = read.span;
    result->name = std::move(read);
    return probabilistic_ ? behind_name(std::move(result)) : std::move(result);
}

ExprPtr Parser::record(QualifiedName type_name) {
    ExprPtr result = make(ExprKind::record);
    const Span begin = type_name.span;
    result->name = std::move(type_name);
    expect("(|");
    do {
        Binding binding;
        binding.variable = std::make_unique<Variable>(DeclKind::field);
        binding.variable->span = peek().span;
        name(*binding.variable);
        expect("=");
        binding.value = expression();
        result->bindings.push_back(std::move(binding));
    } while (accept(","));
    expect("|)");
    return finish(std::move(result), begin);
}

ExprPtr Parser::keyword_atom() {
    if (at("true") || at("false")) return literal(ExprKind::boolean);
    const ExprKind kind = at("result")       ? ExprKind::result
                          : at("to")         ? ExprKind::to
                          : at("from")       ? ExprKind::from
                          : at("inverse")    ? ExprKind::inverse
                          : at("transpose")  ? ExprKind::transpose
                          : at("since")      ? ExprKind::since
                          : at("sinceEntry") ? ExprKind::since_entry
                                             : ExprKind::error;
    if (kind == ExprKind::error) return missing_expression();
    ExprPtr result = make(kind);
    const Span begin = advance().span;
    if (kind == ExprKind::result || kind == ExprKind::to || kind == ExprKind::from) return result;
    expect("(");
    if (kind == ExprKind::since)
        result->name = plain_name("the name of a clock");
    else if (kind == ExprKind::since_entry)
        result->name = qualified_name("the name of a state");
    else
        result->args.push_back(expression());
    expect(")");
    return finish(std::move(result), begin);
}

ExprPtr Parser::bracketed() {
    if (at("(")) return parenthesised_or_range();
    if (at("[")) return closed_range();
    if (at("(|")) return tuple();
    if (at("[|")) return matrix();
    if (at("{")) return set();
    if (at("<") || at("<{")) return sequence();
    return missing_expression();
}

/// Parses the rest of a range after its comma: `b]` or `b)`.
void Parser::range_end(Expr& range) {
    range.args.push_back(expression());
    range.upper_closed = at("]");
    if (!accept("]") && !accept(")")) expected("`]` or `)`");
}

/// `(e)`, `(a, b]`, `(a, b)`
ExprPtr Parser::parenthesised_or_range() {
    ExprPtr result = make(ExprKind::parenthesised);
    const Span begin = expect("(");
    result->args.push_back(expression());
    if (accept(",")) {
        result->kind = ExprKind::range;
        result->lower_closed = false;
        range_end(*result);
    } else {
        expect(")");
    }
    return finish(std::move(result), begin);
}

/// `[a, b]`, `[a, b)`
ExprPtr Parser::closed_range() {
    ExprPtr result = make(ExprKind::range);
    const Span begin = expect("[");
    result->args.push_back(expression());
    expect(",");
    range_end(*result);
    return finish(std::move(result), begin);
}

/// `(| a, b |)`
ExprPtr Parser::tuple() {
    ExprPtr result = make(ExprKind::tuple);
    const Span begin = expect("(|");
    expression_list(result->args, "|)");
    return finish(std::move(result), begin);
}

/// `< a, b >`. Elements are parsed from the level of `+`, so that `>` closes the sequence. A sequence that begins with
/// a set arrives as the token `<{` of deadlines, which is split here.
ExprPtr Parser::sequence() {
    const Nesting nesting(*this);
    ExprPtr result = make(ExprKind::sequence);
    const Span begin = peek().span;
    if (at("<{")) {
        tokens_.drop_first_character(at_);
    } else {
        expect("<");
    }
    if (!at(">")) {
        do result->args.push_back(sequence_element());
        while (accept(",") || missing_comma());
    }
    expect(">");
    return finish(std::move(result), begin);
}

/// A weaker operator is reported and read as intended.
ExprPtr Parser::sequence_element() {
    constexpr int plus_level = 10;
    ExprPtr element = operand(plus_level);
    bool weaker = false;
    while (!at(">") && (operator_here() || at("as") || at("is"))) {
        weaker = true;
        if (const auto next = operator_here())
            element = infix(std::move(element), next->first, plus_level - 1);
        else
            element = cast(std::move(element));
    }
    if (weaker) needs_parentheses("an operator weaker than `+` in a sequence", element->span);
    return element;
}

/// `{a, b}`, `{a to b}`, `{v:T | p @ e}`
ExprPtr Parser::set() {
    ExprPtr result = make(ExprKind::set);
    const Span begin = expect("{");
    if (peek().kind == TokenKind::identifier && peek(1).is(":")) return comprehension(begin);
    if (accept("}")) return finish(std::move(result), begin);
    result->args.push_back(expression());
    if (accept("to")) {
        result->kind = ExprKind::set_range;
        result->args.push_back(expression());
        if (probabilistic_ && accept_word("by")) {
            expect_word("step");
            result->args.push_back(expression());
        }
    } else {
        while (accept(",")) result->args.push_back(expression());
    }
    expect("}");
    return finish(std::move(result), begin);
}

ExprPtr Parser::comprehension(Span begin) {
    ExprPtr result = make(ExprKind::set_comprehension);
    bindings(*result);
    such_that(*result);
    result->args.push_back(accept("@") ? expression() : nullptr);
    expect("}");
    return finish(std::move(result), begin);
}

/// `[| a, b; c, d |]`; without `;` it is a vector.
ExprPtr Parser::matrix() {
    ExprPtr result = make(ExprKind::matrix);
    const Span begin = expect("[|");
    bool ragged = false;
    do {
        const Span row = peek().span;
        const std::size_t before = result->args.size();
        do result->args.push_back(expression());
        while (accept(","));
        const std::size_t entries = result->args.size() - before;
        if (before == 0) result->columns = entries;
        if (entries == result->columns) continue;
        ragged = true;
        report(syntax::ragged_matrix, since(row), {std::to_string(entries), std::to_string(result->columns)});
    } while (accept(";"));
    expect("|]");
    if (ragged) result->columns = 0;  // the matrix has no type
    return finish(std::move(result), begin);
}

}  // namespace robochart::frontend
