// SPDX-License-Identifier: Apache-2.0
// Formats expressions. A long expression breaks first before its weakest operators, and then inside its operands.

#include "frontend/format/format_expressions.hpp"
#include "frontend/syntax/operators.hpp"

namespace robochart::frontend {

Doc ExpressionLayout::format_expression(Gap gap) {
    return format_operand(gap, 0);
}

/// Returns the level of the operator at the current token, or -1 if there is none. `as` and `is`, whose right sides are
/// types, are operators here.
int ExpressionLayout::operator_level() const {
    if (probabilistic_ && at_word("Until")) return not_level;
    if (at("as") || at("is")) return cast_level;
    const BinaryOperator* found = binary_operator(peek());
    return found == nullptr ? -1 : found->level;
}

Doc ExpressionLayout::format_operand(Gap gap, int level) {
    const Doc before = this->format_gap(gap);
    Doc result = format_prefix(level);
    for (int next = operator_level(); next >= level; next = operator_level()) result = format_chain(result, next);
    return doc_.cat(before, result);
}

/// Formats `a + b - c`. All operators of one level form one group.
Doc ExpressionLayout::format_chain(Doc left, int level) {
    Doc rest = 0;
    while (operator_level() == level) rest = doc_.cat(rest, format_infix(level));
    return doc_.group(doc_.cat(left, doc_.nest_indented(rest)));
}

Doc ExpressionLayout::format_infix(int level) {
    if (peek().escaped) return format_operand(Gap::blank, level + 1);
    const bool typed = at("as") || at("is");
    const bool until = probabilistic_ && at_word("Until");
    Doc op = format_token(Gap::line);
    if (until) op = doc_.cat(op, step_bound());
    return doc_.cat(op, typed ? format_type(Gap::blank) : format_operand(Gap::blank, level + 1));
}

Doc ExpressionLayout::format_prefix(int level) {
    if (at("not")) {
        const Doc word = format_token(Gap::done);
        return doc_.cat(word, format_operand(Gap::blank, probabilistic_ ? not_level : compare_level));
    }
    if (at("if")) return format_conditional(Gap::done, &ExpressionLayout::format_expression);
    if (at("forall") || at("exists") || at("exists1") || at("lambda")) return format_binder(0);
    if (at("the") || at("let")) return format_binder(let_level);
    return level == value_level ? format_postfix() : format_negation();
}

/// Formats `forall v : T | p @ e` or `let x == e @ e`.
Doc ExpressionLayout::format_binder(int level) {
    Doc head = format_token(Gap::done);
    head = doc_.cat(head, format_bindings(Gap::blank));
    if (!at("@")) return head;
    const Doc at_sign = format_token(Gap::blank);
    return doc_.group(cat({head, at_sign, doc_.nest_indented(format_operand(Gap::line, level))}));
}

/// Formats `v : T, w : T | p` or `x == e, y == e`.
Doc ExpressionLayout::format_bindings(Gap gap) {
    Doc result = format_binding(gap);
    while (at(",")) result = cat({result, format_token(Gap::none), format_binding(Gap::blank)});
    return at("|") ? cat({result, format_token(Gap::blank), format_expression(Gap::blank)}) : result;
}

Doc ExpressionLayout::format_binding(Gap gap) {
    const Doc result = format_typed(gap);
    return at("==") ? cat({result, format_token(Gap::blank), format_expression(Gap::blank)}) : result;
}

Doc ExpressionLayout::format_negation() {
    Doc result = 0;
    for (; at("-"); result = doc_.cat(result, format_gap(Gap::none))) result = doc_.cat(result, advance());
    return doc_.cat(result, format_postfix());
}

/// True if arguments, an index or a field follow. In assertion files, `.` ends the assertion unless a field name
/// follows it directly.
bool ExpressionLayout::at_step() const {
    if (at("(")) return !peek().first_on_line;
    return at("[") || (at(".") && (!is_assertions_ || peek(1).span.begin == peek().span.end));
}

Doc ExpressionLayout::format_postfix() {
    Doc result = format_atom();
    while (at_step()) {
        if (at("."))
            result = cat({result, format_token(Gap::none), format_token(Gap::none)});
        else
            result = doc_.cat(result, format_list(Gap::none, &ExpressionLayout::format_expression));
    }
    return result;
}

Doc ExpressionLayout::format_atom() {
    if (at_probabilistic_form()) return probabilistic_form();
    if (at("[|") || at("(|") || at("(") || at("[")) return format_list(Gap::done, &ExpressionLayout::format_expression);
    if (at("<{")) return sequence_with_set();
    if (at("<")) return format_list(Gap::done, &ExpressionLayout::sequence_element);
    if (at("{")) return format_list(Gap::done, &ExpressionLayout::set_element);
    if (at("$")) return format_register();
    const bool function = at("since") || at("sinceEntry") || at("inverse") || at("transpose");
    if (!at_name())
        return cat(
            {format_token(Gap::done), function ? format_list(Gap::none, &ExpressionLayout::format_expression) : 0});
    const Doc name = format_names(Gap::done);
    if (probabilistic_) return behind_name(name);
    return at("(|") ? doc_.cat(name, format_list(Gap::none, &ExpressionLayout::format_field)) : name;
}

/// Formats `$n`, `$e?v` or `$e?$x : p`.
Doc ExpressionLayout::format_register() {
    Doc result = format_token(Gap::done);
    result = doc_.cat(result, format_names(Gap::none));
    if (!at("?")) return result;
    result = doc_.cat(result, format_token(Gap::none));
    if (at("$")) result = doc_.cat(result, format_token(Gap::none));
    result = doc_.cat(result, format_names(Gap::none));
    return at(":") ? cat({result, format_token(Gap::blank), format_operand(Gap::blank, value_level)}) : result;
}

Doc ExpressionLayout::format_cycle(Gap gap) {
    const Doc word = format_token(gap);
    return doc_.cat(word, format_expression(Gap::blank));
}

Doc ExpressionLayout::format_registers(Gap gap) {
    const Doc before = this->format_gap(gap);
    const Doc head = cat({format_words(Gap::done, 2), format_token(Gap::blank)});
    Doc body = 0;
    for (Gap next = Gap::open; !at("}") && !at_end(); next = Gap::line) body = doc_.cat(body, register_member(next));
    body = doc_.cat(body, closing_comments());
    const Doc close = body != 0 ? doc_.line() : 0;
    return doc_.cat(before, doc_.group(cat({head, doc_.nest_indented(body), close, advance()}), body_limit));
}

/// Formats `uses I`, `requires I` or `event e : T`.
Doc ExpressionLayout::register_member(Gap gap) {
    const bool event = at("event");
    const Doc word = format_token(gap);
    return doc_.cat(word, event ? format_typed(Gap::blank) : format_names(Gap::blank));
}

/// Formats an element of `< … >`. Because `>` closes the sequence, an element contains only operators that bind at
/// least as tightly as `+`.
Doc ExpressionLayout::sequence_element(Gap gap) {
    return format_operand(gap, plus_level);
}

/// Formats `<{a}, …>`. The opening brackets of a sequence that begins with a set are one token.
Doc ExpressionLayout::sequence_with_set() {
    const Doc open = advance();
    Doc first = doc_.group(doc_.cat(open, format_elements(Gap::soft, &ExpressionLayout::set_element)));
    while (operator_level() >= plus_level) first = format_chain(first, operator_level());
    const Doc comma = at(",") ? format_token(Gap::none) : 0;
    return doc_.group(cat({first, comma, format_elements(Gap::line, &ExpressionLayout::sequence_element)}));
}

/// Formats an element of a set, or the whole content of `{a to b}` and `{v : T | p @ e}`.
Doc ExpressionLayout::set_element(Gap gap) {
    if (!at_name() || !peek(1).is_word(":")) {
        const Doc element = format_expression(gap);
        if (!at("to")) return element;
        const Doc range = cat({element, format_token(Gap::blank), format_expression(Gap::blank)});
        return at_word("by") ? cat({range, format_words(Gap::blank, 2), format_expression(Gap::blank)}) : range;
    }
    const Doc before = this->format_gap(gap);
    const Doc result = doc_.cat(before, format_bindings(Gap::done));
    return at("@") ? cat({result, format_token(Gap::blank), format_expression(Gap::blank)}) : result;
}

/// Formats `f = e` of a record.
Doc ExpressionLayout::format_field(Gap gap) {
    const Doc head = format_words(gap, 2);
    return doc_.cat(head, format_expression(Gap::blank));
}

// ---------------------------------------------------------------- lists, types

Doc ExpressionLayout::format_conditional(Gap gap, Part branch) {
    const Doc before = this->format_gap(gap);
    Doc result = cat({format_token(Gap::done), format_expression(Gap::blank)});
    while (at("then") || at("else")) {
        const Gap lead = at("then") ? Gap::blank : Gap::line;
        const Doc word = format_token(lead);
        result = cat({result, word, doc_.nest_indented((this->*branch)(Gap::line))});
    }
    return group(before, doc_.cat(result, format_token(Gap::line)));
}

Doc ExpressionLayout::format_list(Gap gap, Part element) {
    const Doc before = this->format_gap(gap);
    const Doc open = advance();
    return group(before, doc_.cat(open, format_elements(Gap::soft, element)));
}

/// Formats the elements of a list and the closing bracket. The caller makes the group.
Doc ExpressionLayout::format_elements(Gap first, Part element) {
    Doc inner = 0;
    for (Gap gap = first; !at_closing(); gap = Gap::line) {
        inner = doc_.cat(inner, (this->*element)(gap));
        if (at(",") || at(";")) inner = doc_.cat(inner, format_token(Gap::none));
    }
    inner = doc_.cat(inner, closing_comments());
    Doc close = 0;
    if (inner != 0) close = may_touch() ? doc_.soft() : doc_.line();
    return cat({doc_.nest_indented(inner), close, advance()});
}

Doc ExpressionLayout::format_typed(Gap gap) {
    const Doc name = format_token(gap);
    return at(":") ? cat({name, format_token(Gap::blank), format_type(Gap::blank)}) : name;
}

/// Formats a type. An operator between types is written with a blank on both sides.
Doc ExpressionLayout::format_type(Gap gap) {
    const Doc before = this->format_gap(gap);
    Doc result = atomic_type(Gap::done);
    while (at("<->") || at("->") || at("*")) result = cat({result, format_token(Gap::blank), atomic_type(Gap::blank)});
    return doc_.cat(before, result);
}

Doc ExpressionLayout::atomic_type(Gap gap) {
    if (at("(") || at("Set(") || at("Seq(")) return format_list(gap, &ExpressionLayout::format_type);
    if (at("?")) return cat({format_token(gap), format_token(Gap::none)});
    if (!at("vector") && !at("matrix")) return format_names(gap);
    const Doc word = format_token(gap);
    return doc_.cat(word, format_list(Gap::none, &ExpressionLayout::type_or_size));
}

/// Formats an argument of `vector` or `matrix`. The first argument is a type, and the others are sizes.
Doc ExpressionLayout::type_or_size(Gap gap) {
    return gap == Gap::soft ? format_type(gap) : format_expression(gap);
}

}  // namespace robochart::frontend
