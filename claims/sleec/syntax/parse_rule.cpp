// SPDX-License-Identifier: Apache-2.0
// Parses rules, their triggers and responses. See parser.hpp.
#include <utility>

#include "claims/sleec/syntax/parser.hpp"

namespace robochart::sleec {

Rule Parser::parse_rule() {
    Rule rule;
    rule.span = peek().span;
    if (is_at("assume") && at_name(1)) {
        report_extension(take_token().span, "assume");
        rule.assumed = true;
    }
    rule.name = simple_name("the name of a rule or 'rule_end'");
    if (is_at("when")) return when_rule(std::move(rule));
    if (is_at("after")) return after_rule(std::move(rule));
    if (at_name() && (is_at("(", 1) || (is_at("at", 1) && is_at("least", 2)))) return at_least_rule(std::move(rule));
    fail("'when'", {"when", "after"});
}

Rule Parser::when_rule(Rule rule) {
    expect("when");
    rule.trigger = parse_trigger();
    expect("then");
    rule.response = parse_response();
    rule.span = span_since(rule.span);
    return rule;
}

Rule Parser::after_rule(Rule rule) {
    report_extension(expect("after"), "after E, F");
    rule.form = RuleForm::after;
    rule.trigger = parse_trigger();
    expect(",");
    rule.response = parse_response();
    rule.span = span_since(rule.span);
    return rule;
}

Rule Parser::at_least_rule(Rule rule) {
    rule.form = RuleForm::at_least;
    Response response;
    response.negated = true;
    const Span from = peek().span;
    response.event = parse_event();
    report_extension(expect("at"), "at least");
    expect("least");
    response.limit = std::make_shared<const Limit>(parse_duration(from));
    response.span = span_since(from);
    rule.response = std::make_shared<const Response>(std::move(response));
    expect("after");
    rule.trigger = parse_trigger();
    rule.span = span_since(rule.span);
    return rule;
}

/// Parses `NAME when E and c then R`, `NAME exists E and c [while F and d]` or `NAME exists E and c while R`.
Property Parser::parse_property(bool concern) {
    Property result;
    result.span = peek().span;
    result.name =
        simple_name(concern ? "the name of a concern or 'concern_end'" : "the name of a purpose or 'purpose_end'");
    if (accept("exists")) {
        result.exists = true;
        result.trigger = parse_trigger();
        if (accept("while")) {
            const bool timed = is_at("not") || (at_name() && (is_at("eventually", 1) || is_at("within", 1)));
            if (timed)
                result.response = std::make_shared<const Response>(parse_action());
            else
                result.during = std::make_shared<const Trigger>(parse_trigger());
        }
    } else {
        if (!is_at("when")) fail("'when' or 'exists'", {"when", "exists"});
        take_token();
        result.trigger = parse_trigger();
        expect("then");
        result.response = parse_response();
    }
    if (is_at("meanwhile") || is_at("until")) refuse_construct("'meanwhile' and 'until'", peek().span);
    result.span = span_since(result.span);
    return result;
}

Trigger Parser::parse_trigger() {
    Trigger result;
    result.event = parse_event();
    if (accept("and")) result.condition = parse_condition();
    return result;
}

/// Parses `EVENT [(value, ...)]`.
EventName Parser::parse_event() {
    EventName result{simple_name("the name of an event"), std::nullopt};
    const Span from = peek().span;
    if (!accept("(")) return result;
    result.arguments.emplace();
    do result.arguments->push_back(parse_argument());
    while (accept(","));
    expect(")");
    report_first_extension(span_since(from), "arguments of an event");
    return result;
}

/// Parses a number, `true`, `false`, a constant, a literal of the model, or `_`.
ExprPtr Parser::parse_argument() {
    Expr expr;
    const Span from = peek().span;
    const bool negative = accept("-");
    if (negative || peek().kind == Tok::number) {
        if (peek().kind != Tok::number) fail("a number");
        expr.op = Op::number;
        expr.text = (negative ? "-" : "") + std::string(take_token().text);
    } else if (is_at("true") || is_at("false")) {
        expr.op = Op::truth;
        expr.text = std::string(take_token().text);
    } else {
        expr.op = Op::name;
        expr.text = qualified_name("a value").text;
    }
    expr.span = span_since(from);
    return std::make_shared<const Expr>(std::move(expr));
}

/// Parses `action [otherwise inner] {unless condition [then inner]}`.
ResponsePtr Parser::parse_response() {
    const Depth depth(*this);
    Response result = parse_action();
    parse_alternative(result);
    while (is_at("unless")) {
        Defeater defeater;
        const Span from = take_token().span;
        if (at_name() && is_at("(", 1) && events_.contains(peek().text))
            defeater.event = parse_event();
        else
            defeater.condition = parse_condition();
        if (accept("then")) defeater.response = parse_inner_response();
        defeater.span = span_since(from);
        result.defeaters.push_back(std::move(defeater));
    }
    result.span = span_since(result.span);
    return std::make_shared<const Response>(std::move(result));
}

ResponsePtr Parser::parse_inner_response() {
    const Depth depth(*this);
    if (is_at("{")) {
        const Span from = take_token().span;
        Response result = *parse_response();
        expect("}");
        result.braced = true;
        result.span = span_since(from);
        return std::make_shared<const Response>(std::move(result));
    }
    Response result = parse_action();
    parse_alternative(result);
    return std::make_shared<const Response>(std::move(result));
}

/// Parses `[not] EVENT [eventually | within ...]`.
Response Parser::parse_action() {
    Response result;
    result.span = peek().span;
    result.negated = accept("not");
    result.event = parse_event();
    if (is_at("eventually")) {
        only_in(Dialect::legos, take_token().span, "'eventually'");
        result.eventually = true;
    }
    if (is_at("within")) result.limit = std::make_shared<const Limit>(parse_limit());
    result.span = span_since(result.span);
    if (result.negated && !result.limit) only_in(Dialect::legos, result.span, "'not' without 'within'");
    return result;
}

void Parser::parse_alternative(Response& response) {
    if (!is_at("otherwise") && !is_at("else")) return;
    response.written_else = is_at("else");
    const Span span = take_token().span;
    if (response.written_else) only_in(Dialect::legos, span, "'else'");
    if (!response.limit || response.negated)
        only_in(Dialect::legos, span, "'otherwise' behind a response without a positive 'within'");
    response.otherwise = parse_inner_response();
    response.span = span_since(response.span);
}

Limit Parser::parse_limit() {
    return parse_duration(expect("within"));
}

/// Parses `N unit`, `[A, B] unit` or `[A unit, B unit]`.
Limit Parser::parse_duration(Span from) {
    Limit result;
    if (is_at("[")) {
        const Span interval = take_token().span;
        result.from = parse_time();
        result.each_unit = !is_at(",");
        if (result.each_unit) result.from_unit = parse_unit();
        expect(",");
        result.to = parse_time();
        if (result.each_unit) result.unit = parse_unit();
        expect("]");
        only_in(Dialect::legos, span_since(interval), "an interval of time");
    } else {
        result.to = parse_time();
    }
    if (!result.each_unit) result.from_unit = result.unit = parse_unit();
    result.span = span_since(from);
    return result;
}

Unit Parser::parse_unit() {
    for (const Unit unit : {Unit::seconds, Unit::minutes, Unit::hours, Unit::days})
        if (accept(unit_name(unit))) return unit;
    fail("a unit of time ('seconds', 'minutes', 'hours' or 'days')", {"seconds", "minutes", "hours", "days"});
}

/// Parses a number, the name of a constant, or a parenthesised expression with numbers, constants and measures.
ExprPtr Parser::parse_time() {
    if (is_at("(")) {
        const ExprPtr computed = parse_primary();
        only_in(Dialect::legos, computed->span, "a limit in parentheses");
        return computed;
    }
    Expr expr;
    expr.span = peek().span;
    if (peek().kind == Tok::number) {
        expr.op = Op::number;
        expr.text = std::string(take_token().text);
    } else {
        if (is_at("-")) refuse_construct("negative numbers", peek().span);
        expr.op = Op::name;
        expr.text = simple_name("a number or a constant").text;
    }
    return std::make_shared<const Expr>(std::move(expr));
}

}  // namespace robochart::sleec
