// SPDX-License-Identifier: Apache-2.0
// Parses sets of events and conditions on their values. See parser.hpp. `or` joins patterns, so a condition with `or`
// needs parentheses.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "claims/syntax/parser.hpp"
#include "claims/syntax/rules.hpp"

namespace robochart::claims {

namespace {

/// True for words that may follow an event. A word before such a word is the event.
bool continues_claim(std::string_view word) {
    constexpr std::array words{"or", "with", "only", "leads", "at", "unless", "until", "before", "within", "any"};
    return std::ranges::find(words, word) != words.end();
}

}  // namespace

// ---------------------------------------------------------------- events

EventSet Parser::parse_events() {
    EventSet result;
    const Span from = peek().span;
    result.patterns.push_back(parse_pattern());
    while (accept("or")) result.patterns.push_back(parse_pattern());
    result.span = span_since(from);
    return result;
}

/// True for `in E`: the word is followed by the name of an event, and not by a word that continues the claim.
bool Parser::at_direction() const {
    constexpr std::array words{"in", "out", "call", "raised"};
    if (std::ranges::none_of(words, [this](std::string_view word) { return is_at(word); })) return false;
    return is_at("^", 1) || (peek(1).kind == Tok::word && !continues_claim(peek(1).text));
}

Pattern Parser::parse_pattern() {
    Pattern pattern;
    const Span from = peek().span;
    if (is_at("any") && (is_at("call", 1) || is_at("input", 1))) return parse_any(std::move(pattern));
    if ((is_at("enter") || is_at("leave")) && peek(1).kind == Tok::word && !continues_claim(peek(1).text))
        return parse_change(std::move(pattern));
    if (is_at("start") || is_at("terminate")) {
        pattern.kind = is_at("start") ? PatternKind::start : PatternKind::terminate;
        pattern.name = {std::string(peek().text), peek().span};
        pattern.span = take_token().span;
        return pattern;
    }
    if (at_direction()) {
        constexpr std::array rows{std::pair{"in", Direction::input}, std::pair{"out", Direction::output},
                                  std::pair{"call", Direction::call}, std::pair{"raised", Direction::raised}};
        for (const auto& [word, direction] : rows)
            if (is_at(word)) pattern.direction = direction;
        take_token();
    }
    if (at_item()) fail("an event or an operation");
    (void)accept("^");
    pattern.name = simple_name("an event or an operation");
    if (accept("(")) {
        pattern.arguments.emplace();
        if (!is_at(")")) {
            do pattern.arguments->push_back(parse_sum());
            while (accept(","));
        }
        expect(")");
    }
    if (is_at("with") && !at_constants()) {
        take_token();
        pattern.condition = parse_conjunction();
    }
    pattern.span = span_since(from);
    return pattern;
}

/// Parses `enter S` or `leave S`.
Pattern Parser::parse_change(Pattern pattern) {
    const Span from = peek().span;
    pattern.kind = is_at("enter") ? PatternKind::enter : PatternKind::leave;
    take_token();
    pattern.name = qualified_name("a state");
    pattern.span = span_since(from);
    return pattern;
}

/// Parses `any call [but E]` or `any input [but E]`. The exceptions reach to the end of the set.
Pattern Parser::parse_any(Pattern pattern) {
    const Span from = take_token().span;
    pattern.kind = is_at("call") ? PatternKind::any_call : PatternKind::any_input;
    take_token();
    if (accept("but")) {
        const Depth depth(*this);
        pattern.but = parse_events().patterns;
    }
    pattern.span = span_since(from);
    return pattern;
}

// ---------------------------------------------------------------- conditions

ExprPtr Parser::make_node(Op op, Span from, std::string text, std::vector<ExprPtr> parts) const {
    return std::make_shared<const Expr>(Expr{op, std::move(text), std::move(parts), span_since(from)});
}

ExprPtr Parser::parse_disjunction() {
    const Span from = peek().span;
    ExprPtr left = parse_conjunction();
    while (accept("or")) left = make_node(Op::disjunction, from, "or", {left, parse_conjunction()});
    return left;
}

ExprPtr Parser::parse_conjunction() {
    const Span from = peek().span;
    ExprPtr left = parse_relation();
    while (accept("and")) left = make_node(Op::conjunction, from, "and", {left, parse_relation()});
    return left;
}

ExprPtr Parser::parse_relation() {
    const Depth depth(*this);
    const Span from = peek().span;
    if (accept("not")) return make_node(Op::negation, from, "not", {parse_relation()});
    if (is_at("in") && peek(1).kind == Tok::word) {
        take_token();
        Name state = qualified_name("a state");
        return make_node(Op::in_state, from, std::move(state.text), {});
    }
    ExprPtr left = parse_sum();
    constexpr std::array rows{std::pair{"<=", Op::less_equal}, std::pair{">=", Op::greater_equal},
                              std::pair{"==", Op::equal},      std::pair{"!=", Op::unequal},
                              std::pair{"<", Op::less},        std::pair{">", Op::greater}};
    for (const auto& [symbol, op] : rows)
        if (accept(symbol)) return make_node(op, from, symbol, {left, parse_sum()});
    if (is_at("=")) fail("'=='");
    return left;
}

ExprPtr Parser::parse_sum() {
    const Span from = peek().span;
    ExprPtr left = parse_product();
    for (;;) {
        if (accept("+"))
            left = make_node(Op::add, from, "+", {left, parse_product()});
        else if (accept("-"))
            left = make_node(Op::subtract, from, "-", {left, parse_product()});
        else
            return left;
    }
}

ExprPtr Parser::parse_product() {
    const Span from = peek().span;
    ExprPtr left = parse_operand();
    for (;;) {
        if (accept("*"))
            left = make_node(Op::multiply, from, "*", {left, parse_operand()});
        else if (accept("%"))
            left = make_node(Op::modulus, from, "%", {left, parse_operand()});
        else
            return left;
    }
}

ExprPtr Parser::parse_operand() {
    const Depth depth(*this);
    const Span from = peek().span;
    if (accept("(")) {
        ExprPtr inner = parse_disjunction();
        expect(")");
        return inner;
    }
    if (accept("-")) return make_node(Op::negate, from, "-", {parse_operand()});
    if (peek().kind == Tok::number) {
        std::string text(take_token().text);
        return make_node(Op::number, from, std::move(text), {});
    }
    if (is_at("last") && (peek(1).kind == Tok::word || is_at("^", 1))) {
        take_token();
        (void)accept("^");
        Name event = simple_name("an event or an operation");
        return make_node(Op::last, from, std::move(event.text), {});
    }
    if (is_at("true") || is_at("false")) {
        std::string text(take_token().text);
        return make_node(Op::truth, from, std::move(text), {});
    }
    Name name = qualified_name("a value");
    return make_node(Op::name, from, std::move(name.text), {});
}

}  // namespace robochart::claims
