// SPDX-License-Identifier: Apache-2.0
// Expressions. One that is too long breaks before its weakest operators first, then inside its operands.

#include "frontend/format/format_expressions.hpp"
#include "frontend/syntax/operators.hpp"

namespace robochart::frontend {

Doc ExpressionLayout::expression(Gap gap) {
    return operand(gap, 0);
}

/// The level of the operator here, including `as` and `is`, whose right side is a type; -1 if there is no operator.
int ExpressionLayout::operator_level() const {
    if (probabilistic_ && at_word("Until")) return not_level;
    if (at("as") || at("is")) return cast_level;
    const BinaryOperator* found = binary_operator(peek());
    return found == nullptr ? -1 : found->level;
}

Doc ExpressionLayout::operand(Gap gap, int level) {
    const Doc before = this->gap(gap);
    Doc result = prefix(level);
    for (int next = operator_level(); next >= level; next = operator_level()) result = chain(result, next);
    return doc_.cat(before, result);
}

/// `a + b - c`: all operators of one level form one group.
Doc ExpressionLayout::chain(Doc left, int level) {
    Doc rest = 0;
    while (operator_level() == level) rest = doc_.cat(rest, infix(level));
    return doc_.group(doc_.cat(left, doc_.nest(rest)));
}

Doc ExpressionLayout::infix(int level) {
    if (peek().escaped) return operand(Gap::blank, level + 1);
    const bool typed = at("as") || at("is");
    const bool until = probabilistic_ && at_word("Until");
    Doc op = token(Gap::line);
    if (until) op = doc_.cat(op, step_bound());
    return doc_.cat(op, typed ? type(Gap::blank) : operand(Gap::blank, level + 1));
}

Doc ExpressionLayout::prefix(int level) {
    if (at("not")) {
        const Doc word = token(Gap::done);
        return doc_.cat(word, operand(Gap::blank, probabilistic_ ? not_level : compare_level));
    }
    if (at("if")) return conditional(Gap::done, &ExpressionLayout::expression);
    if (at("forall") || at("exists") || at("exists1") || at("lambda")) return binder(0);
    if (at("the") || at("let")) return binder(let_level);
    return level == value_level ? postfix() : negation();
}

/// `forall v : T | p @ e`, `let x == e @ e`
Doc ExpressionLayout::binder(int level) {
    Doc head = token(Gap::done);
    head = doc_.cat(head, bindings(Gap::blank));
    if (!at("@")) return head;
    const Doc at_sign = token(Gap::blank);
    return doc_.group(cat({head, at_sign, doc_.nest(operand(Gap::line, level))}));
}

/// `v : T, w : T | p`, `x == e, y == e`
Doc ExpressionLayout::bindings(Gap gap) {
    Doc result = binding(gap);
    while (at(",")) result = cat({result, token(Gap::none), binding(Gap::blank)});
    return at("|") ? cat({result, token(Gap::blank), expression(Gap::blank)}) : result;
}

Doc ExpressionLayout::binding(Gap gap) {
    const Doc result = typed(gap);
    return at("==") ? cat({result, token(Gap::blank), expression(Gap::blank)}) : result;
}

Doc ExpressionLayout::negation() {
    Doc result = 0;
    for (; at("-"); result = doc_.cat(result, gap(Gap::none))) result = doc_.cat(result, advance());
    return doc_.cat(result, postfix());
}

/// In assertion files, `.` ends the assertion unless a field name follows it directly.
bool ExpressionLayout::at_step() const {
    if (at("(")) return !peek().first_on_line;
    return at("[") || (at(".") && (!is_assertions_ || peek(1).span.begin == peek().span.end));
}

Doc ExpressionLayout::postfix() {
    Doc result = atom();
    while (at_step()) {
        if (at("."))
            result = cat({result, token(Gap::none), token(Gap::none)});
        else
            result = doc_.cat(result, list(Gap::none, &ExpressionLayout::expression));
    }
    return result;
}

Doc ExpressionLayout::atom() {
    if (at_probabilistic_form()) return probabilistic_form();
    if (at("[|") || at("(|") || at("(") || at("[")) return list(Gap::done, &ExpressionLayout::expression);
    if (at("<{")) return sequence_with_set();
    if (at("<")) return list(Gap::done, &ExpressionLayout::sequence_element);
    if (at("{")) return list(Gap::done, &ExpressionLayout::set_element);
    const bool function = at("since") || at("sinceEntry") || at("inverse") || at("transpose");
    if (!at_name()) return cat({token(Gap::done), function ? list(Gap::none, &ExpressionLayout::expression) : 0});
    const Doc name = names(Gap::done);
    if (probabilistic_) return behind_name(name);
    return at("(|") ? doc_.cat(name, list(Gap::none, &ExpressionLayout::field)) : name;
}

/// `>` closes the sequence `< … >`, so only operators from the level of `+` on are read in its elements.
Doc ExpressionLayout::sequence_element(Gap gap) {
    return operand(gap, plus_level);
}

/// `<{a}, …>`: the opening brackets of a sequence that begins with a set are one token.
Doc ExpressionLayout::sequence_with_set() {
    const Doc open = advance();
    Doc first = doc_.group(doc_.cat(open, elements(Gap::soft, &ExpressionLayout::set_element)));
    while (operator_level() >= plus_level) first = chain(first, operator_level());
    const Doc comma = at(",") ? token(Gap::none) : 0;
    return doc_.group(cat({first, comma, elements(Gap::line, &ExpressionLayout::sequence_element)}));
}

/// An element of a set, or the whole content of `{a to b}` and `{v : T | p @ e}`.
Doc ExpressionLayout::set_element(Gap gap) {
    if (!at_name() || !peek(1).is(":")) {
        const Doc element = expression(gap);
        if (!at("to")) return element;
        const Doc range = cat({element, token(Gap::blank), expression(Gap::blank)});
        return at_word("by") ? cat({range, words(Gap::blank, 2), expression(Gap::blank)}) : range;
    }
    const Doc before = this->gap(gap);
    const Doc result = doc_.cat(before, bindings(Gap::done));
    return at("@") ? cat({result, token(Gap::blank), expression(Gap::blank)}) : result;
}

/// `f = e` of a record.
Doc ExpressionLayout::field(Gap gap) {
    const Doc head = words(gap, 2);
    return doc_.cat(head, expression(Gap::blank));
}

// ---------------------------------------------------------------- lists, types

Doc ExpressionLayout::conditional(Gap gap, Part branch) {
    const Doc before = this->gap(gap);
    Doc result = cat({token(Gap::done), expression(Gap::blank)});
    while (at("then") || at("else")) {
        const Gap lead = at("then") ? Gap::blank : Gap::line;
        const Doc word = token(lead);
        result = cat({result, word, doc_.nest((this->*branch)(Gap::line))});
    }
    return group(before, doc_.cat(result, token(Gap::line)));
}

Doc ExpressionLayout::list(Gap gap, Part element) {
    const Doc before = this->gap(gap);
    const Doc open = advance();
    return group(before, doc_.cat(open, elements(Gap::soft, element)));
}

/// The elements of a list and the closing bracket. The caller makes the group.
Doc ExpressionLayout::elements(Gap first, Part element) {
    Doc inner = 0;
    for (Gap gap = first; !at_closing(); gap = Gap::line) {
        inner = doc_.cat(inner, (this->*element)(gap));
        if (at(",") || at(";")) inner = doc_.cat(inner, token(Gap::none));
    }
    inner = doc_.cat(inner, closing_comments());
    const Doc close = inner == 0 ? 0 : may_touch() ? doc_.soft() : doc_.line();
    return cat({doc_.nest(inner), close, advance()});
}

Doc ExpressionLayout::typed(Gap gap) {
    const Doc name = token(gap);
    return at(":") ? cat({name, token(Gap::blank), type(Gap::blank)}) : name;
}

/// An operator between types is written with a blank on both sides.
Doc ExpressionLayout::type(Gap gap) {
    const Doc before = this->gap(gap);
    Doc result = atomic_type(Gap::done);
    while (at("<->") || at("->") || at("*")) result = cat({result, token(Gap::blank), atomic_type(Gap::blank)});
    return doc_.cat(before, result);
}

Doc ExpressionLayout::atomic_type(Gap gap) {
    if (at("(") || at("Set(") || at("Seq(")) return list(gap, &ExpressionLayout::type);
    if (at("?")) return cat({token(gap), token(Gap::none)});
    if (!at("vector") && !at("matrix")) return names(gap);
    const Doc word = token(gap);
    return doc_.cat(word, list(Gap::none, &ExpressionLayout::type_or_size));
}

/// An argument of `vector` or `matrix`: the first is a type, the others are sizes.
Doc ExpressionLayout::type_or_size(Gap gap) {
    return gap == Gap::soft ? type(gap) : expression(gap);
}

}  // namespace robochart::frontend
