// SPDX-License-Identifier: Apache-2.0
// Rules, their triggers and responses. See parser.hpp.
#include <utility>

#include "sleec/syntax/parser.hpp"

namespace robochart::sleec {

Rule Parser::rule() {
    Rule rule;
    rule.span = peek().span;
    if (at("assume") && at_name(1)) {
        extension(take().span, "assume");
        rule.assumed = true;
    }
    rule.name = name("the name of a rule or 'rule_end'");
    if (at("when")) return when_rule(std::move(rule));
    if (at("after")) return after_rule(std::move(rule));
    if (at_name() && at("at", 1) && at("least", 2)) return at_least_rule(std::move(rule));
    fail("'when'", {"when", "after"});
}

Rule Parser::when_rule(Rule rule) {
    expect("when");
    rule.trigger = trigger();
    expect("then");
    rule.response = response();
    rule.span = since(rule.span);
    return rule;
}

Rule Parser::after_rule(Rule rule) {
    extension(expect("after"), "after E, F");
    rule.form = RuleForm::after;
    rule.trigger = trigger();
    expect(",");
    rule.response = response();
    rule.span = since(rule.span);
    return rule;
}

Rule Parser::at_least_rule(Rule rule) {
    rule.form = RuleForm::at_least;
    Response response;
    response.negated = true;
    const Span from = peek().span;
    response.event = name("the name of an event");
    extension(expect("at"), "at least");
    expect("least");
    response.limit = std::make_shared<const Limit>(duration(from));
    response.span = since(from);
    rule.response = std::make_shared<const Response>(std::move(response));
    expect("after");
    rule.trigger = trigger();
    rule.span = since(rule.span);
    return rule;
}

/// `NAME when E and c then R`, `NAME exists E and c [while F and d]` or `NAME exists E and c while R`.
Property Parser::property(bool concern) {
    Property result;
    result.span = peek().span;
    result.name = name(concern ? "the name of a concern or 'concern_end'" : "the name of a purpose or 'purpose_end'");
    if (accept("exists")) {
        result.exists = true;
        result.trigger = trigger();
        if (accept("while")) {
            const bool timed = at("not") || (at_name() && (at("eventually", 1) || at("within", 1)));
            if (timed)
                result.response = std::make_shared<const Response>(action());
            else
                result.during = std::make_shared<const Trigger>(trigger());
        }
    } else {
        if (!at("when")) fail("'when' or 'exists'", {"when", "exists"});
        take();
        result.trigger = trigger();
        expect("then");
        result.response = response();
    }
    if (at("meanwhile") || at("until")) refuse("'meanwhile' and 'until'", peek().span);
    result.span = since(result.span);
    return result;
}

Trigger Parser::trigger() {
    Trigger result;
    result.event = name("the name of an event");
    if (accept("and")) result.condition = condition();
    return result;
}

/// `action [otherwise inner] {unless condition [then inner]}`.
ResponsePtr Parser::response() {
    const Depth depth(*this);
    Response result = action();
    alternative(result);
    while (at("unless")) {
        Defeater defeater;
        const Span from = take().span;
        defeater.condition = condition();
        if (accept("then")) defeater.response = inner();
        defeater.span = since(from);
        result.defeaters.push_back(std::move(defeater));
    }
    result.span = since(result.span);
    return std::make_shared<const Response>(std::move(result));
}

ResponsePtr Parser::inner() {
    const Depth depth(*this);
    if (at("{")) {
        const Span from = take().span;
        Response result = *response();
        expect("}");
        result.braced = true;
        result.span = since(from);
        return std::make_shared<const Response>(std::move(result));
    }
    Response result = action();
    alternative(result);
    return std::make_shared<const Response>(std::move(result));
}

/// `[not] EVENT [eventually | within ...]`.
Response Parser::action() {
    Response result;
    result.span = peek().span;
    result.negated = accept("not");
    result.event = name("the name of an event");
    if (at("eventually")) {
        only_in(Dialect::legos, take().span, "'eventually'");
        result.eventually = true;
    }
    if (at("within")) result.limit = std::make_shared<const Limit>(limit());
    result.span = since(result.span);
    if (result.negated && !result.limit) only_in(Dialect::legos, result.span, "'not' without 'within'");
    return result;
}

void Parser::alternative(Response& response) {
    if (!at("otherwise") && !at("else")) return;
    response.written_else = at("else");
    const Span span = take().span;
    if (response.written_else) only_in(Dialect::legos, span, "'else'");
    if (!response.limit || response.negated)
        only_in(Dialect::legos, span, "'otherwise' behind a response without a positive 'within'");
    response.otherwise = inner();
    response.span = since(response.span);
}

Limit Parser::limit() {
    return duration(expect("within"));
}

/// `N unit`, `[A, B] unit` or `[A unit, B unit]`.
Limit Parser::duration(Span from) {
    Limit result;
    if (at("[")) {
        const Span interval = take().span;
        result.from = time();
        result.each_unit = !at(",");
        if (result.each_unit) result.from_unit = unit();
        expect(",");
        result.to = time();
        if (result.each_unit) result.unit = unit();
        expect("]");
        only_in(Dialect::legos, since(interval), "an interval of time");
    } else {
        result.to = time();
    }
    if (!result.each_unit) result.from_unit = result.unit = unit();
    result.span = since(from);
    return result;
}

Unit Parser::unit() {
    for (const Unit unit : {Unit::seconds, Unit::minutes, Unit::hours, Unit::days})
        if (accept(unit_name(unit))) return unit;
    fail("a unit of time ('seconds', 'minutes', 'hours' or 'days')", {"seconds", "minutes", "hours", "days"});
}

/// A number, the name of a constant, or, in parentheses, an expression of these and measures.
ExprPtr Parser::time() {
    if (at("(")) {
        const ExprPtr computed = primary();
        only_in(Dialect::legos, computed->span, "a limit in parentheses");
        return computed;
    }
    Expr expr;
    expr.span = peek().span;
    if (peek().kind == Tok::number) {
        expr.op = Op::number;
        expr.text = std::string(take().text);
    } else {
        if (at("-")) refuse("negative numbers", peek().span);
        expr.op = Op::name;
        expr.text = name("a number or a constant").text;
    }
    return std::make_shared<const Expr>(std::move(expr));
}

}  // namespace robochart::sleec
