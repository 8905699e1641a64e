// SPDX-License-Identifier: Apache-2.0
// Formats statements and communications.
#include "frontend/format/format_model.hpp"

namespace robochart::frontend {

Doc ModelLayout::format_statement(Gap gap) {
    const Doc before = this->format_gap(gap);
    return group(before, format_sequence(Gap::done));
}

/// Formats `S; S`, on one line or with one statement per line. The caller makes the group.
Doc ModelLayout::format_sequence(Gap gap) {
    Doc result = timed_statement(gap);
    while (at(";")) result = cat({result, format_token(Gap::none), timed_statement(Gap::line)});
    return result;
}

Doc ModelLayout::timed_statement(Gap gap) {
    const Doc inner = basic_statement(gap);
    return at("<{") ? doc_.cat(inner, format_deadline(Gap::blank)) : inner;
}

Doc ModelLayout::basic_statement(Gap gap) {
    if (at("if")) return format_conditional(gap, &ModelLayout::format_statement);
    if (at("(")) return format_list(gap, &ModelLayout::format_statement);
    if (at("skip") || at("exec")) return format_token(gap);
    if (at("$")) {
        const Doc sign = format_token(gap);
        return doc_.cat(sign, format_communication(Gap::none));
    }
    if (at("#")) return cat({format_token(gap), format_token(Gap::none)});
    if (at("wait")) return cat({format_token(gap), format_list(Gap::none, &ModelLayout::format_expression)});
    if (at("send")) return cat({format_token(gap), format_communication(Gap::blank)});
    return format_communication(gap);
}

/// Formats a name and its suffix in a statement or trigger: `e?x`, `e!v`, `e.v`, `e[| p |]?x`, `op(a)`, `v[i] = e`.
Doc ModelLayout::format_communication(Gap gap) {
    Doc result = format_names(gap);
    for (;;) {
        if (at("(") || at("["))
            result = doc_.cat(result, format_list(Gap::none, &ModelLayout::format_expression));
        else if (at("[|"))
            result = doc_.cat(result, format_predicate());
        else if (at("!") || at("."))
            result = cat({result, format_token(Gap::none), format_operand(Gap::none, value_level)});
        else if (at("?"))
            result = cat({result, format_token(Gap::none), format_names(Gap::none)});
        else
            break;
    }
    return at("=") ? cat({result, format_token(Gap::blank), format_expression(Gap::blank)}) : result;
}

/// Formats `[| x = from | p |]`.
Doc ModelLayout::format_predicate() {
    Doc result = format_token(Gap::none);
    Gap gap = Gap::none;
    if (at_name() && peek(1).is_word("=")) {
        result = doc_.cat(result, format_words(gap, 3));
        if (at("|")) result = doc_.cat(result, format_token(Gap::blank));
        gap = Gap::blank;
    }
    if (!at("|]")) result = doc_.cat(result, format_expression(gap));
    return doc_.cat(result, format_token(Gap::none));
}

}  // namespace robochart::frontend
