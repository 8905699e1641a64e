// SPDX-License-Identifier: Apache-2.0
// Formats states, actions and transitions. A short body is written on the line of its head. A longer body has one part
// per line.
#include "frontend/format/format_model.hpp"

namespace robochart::frontend {

/// Formats `state S { entry e }`. A state with several parts is written with one part per line.
Doc ModelLayout::format_state(Gap gap) {
    const Doc before = this->format_gap(gap);
    const Doc head = format_words(Gap::done, 2);
    if (!at("{")) return doc_.cat(before, head);
    const Doc body = format_braces(&ModelLayout::format_member, Gap::open, Gap::member);
    return doc_.cat(before, doc_.group(doc_.cat(head, body), body_limit));
}

Doc ModelLayout::format_action(Gap gap) {
    const Doc word = format_token(gap);
    return doc_.cat(word, action_body());
}

/// Formats a statement, on the line of its keyword or indented below it.
Doc ModelLayout::action_body() {
    return doc_.group(doc_.nest_indented(format_sequence(Gap::line)));
}

Doc ModelLayout::format_transition(Gap gap) {
    const Doc before = this->format_gap(gap);
    const Doc head = format_words(Gap::done, 2);
    const Doc body = format_braces(&ModelLayout::format_clauses, Gap::open, Gap::line);
    return doc_.cat(before, doc_.group(doc_.cat(head, body), body_limit));
}

/// Formats a transition: `from A to B`, and then one clause per line. Resets and a deadline are on the line of the
/// clause before them.
Doc ModelLayout::format_clauses(Gap gap) {
    Doc result = format_phrase(gap);
    if (at("to")) result = doc_.cat(result, format_phrase(Gap::blank));
    bool awaits = false;
    while (!at("}") && !at_end()) {
        const bool trigger = at("trigger") || at("exec") || at("#");
        result = doc_.cat(result, format_clause(Gap::line, awaits));
        awaits = trigger;
    }
    return result;
}

Doc ModelLayout::format_clause(Gap gap, bool trigger_before) {
    const Gap near = trigger_before ? Gap::blank : gap;
    if (at("#")) return cat({format_token(near), format_token(Gap::none)});
    if (at("<{")) return format_deadline(near);
    if (at("exec")) return format_token(gap);
    const bool trigger = at("trigger");
    const bool action = at("action");
    const Doc word = format_token(gap);
    if (action) return doc_.cat(word, action_body());
    if (!trigger) return doc_.cat(word, at("else") ? format_token(Gap::blank) : format_expression(Gap::blank));
    return at_name() ? doc_.cat(word, format_communication(Gap::blank)) : word;
}

/// Formats `<{ e }`.
Doc ModelLayout::format_deadline(Gap gap) {
    const Doc open = format_token(gap);
    const Doc limit = format_expression(Gap::blank);
    return cat({open, limit, format_token(Gap::blank)});
}

}  // namespace robochart::frontend
