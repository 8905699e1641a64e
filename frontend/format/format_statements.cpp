// SPDX-License-Identifier: Apache-2.0
// Statements and communications.
#include "frontend/format/format_model.hpp"

namespace robochart::frontend {

Doc ModelLayout::statement(Gap gap) {
    const Doc before = this->gap(gap);
    return group(before, sequence(Gap::done));
}

/// `S; S`: on one line, or one statement a line. The caller makes the group.
Doc ModelLayout::sequence(Gap gap) {
    Doc result = timed_statement(gap);
    while (at(";")) result = cat({result, token(Gap::none), timed_statement(Gap::line)});
    return result;
}

Doc ModelLayout::timed_statement(Gap gap) {
    const Doc inner = basic_statement(gap);
    return at("<{") ? doc_.cat(inner, deadline(Gap::blank)) : inner;
}

Doc ModelLayout::basic_statement(Gap gap) {
    if (at("if")) return conditional(gap, &ModelLayout::statement);
    if (at("(")) return list(gap, &ModelLayout::statement);
    if (at("skip")) return token(gap);
    if (at("#")) return cat({token(gap), token(Gap::none)});
    if (at("wait")) return cat({token(gap), list(Gap::none, &ModelLayout::expression)});
    if (at("send")) return cat({token(gap), communication(Gap::blank)});
    return communication(gap);
}

/// A name with everything that may follow it in a statement or trigger: `e?x`, `e!v`, `e.v`, `e[| p |]?x`, `op(a)`,
/// `v[i] = e`.
Doc ModelLayout::communication(Gap gap) {
    Doc result = names(gap);
    for (;;) {
        if (at("(") || at("["))
            result = doc_.cat(result, list(Gap::none, &ModelLayout::expression));
        else if (at("[|"))
            result = doc_.cat(result, predicate());
        else if (at("!") || at("."))
            result = cat({result, token(Gap::none), operand(Gap::none, value_level)});
        else if (at("?"))
            result = cat({result, token(Gap::none), names(Gap::none)});
        else
            break;
    }
    return at("=") ? cat({result, token(Gap::blank), expression(Gap::blank)}) : result;
}

/// `[| x = from | p |]`
Doc ModelLayout::predicate() {
    Doc result = token(Gap::none);
    Gap gap = Gap::none;
    if (at_name() && peek(1).is("=")) {
        result = doc_.cat(result, words(gap, 3));
        if (at("|")) result = doc_.cat(result, token(Gap::blank));
        gap = Gap::blank;
    }
    if (!at("|]")) result = doc_.cat(result, expression(gap));
    return doc_.cat(result, token(Gap::none));
}

}  // namespace robochart::frontend
