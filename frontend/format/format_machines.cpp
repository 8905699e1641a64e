// SPDX-License-Identifier: Apache-2.0
// States, actions, transitions. A short body is written on the line of its head; a longer body has one part on each
// line.
#include "frontend/format/format_model.hpp"

namespace robochart::frontend {

/// `state S { entry e }`; a state with several parts has one a line.
Doc ModelLayout::state(Gap gap) {
    const Doc before = this->gap(gap);
    const Doc head = words(Gap::done, 2);
    if (!at("{")) return doc_.cat(before, head);
    const Doc body = braces(&ModelLayout::member, Gap::open, Gap::member);
    return doc_.cat(before, doc_.group(doc_.cat(head, body), body_limit));
}

Doc ModelLayout::action(Gap gap) {
    const Doc word = token(gap);
    return doc_.cat(word, action_body());
}

/// A statement, on the line of its keyword or indented below it.
Doc ModelLayout::action_body() {
    return doc_.group(doc_.nest(sequence(Gap::line)));
}

Doc ModelLayout::transition(Gap gap) {
    const Doc before = this->gap(gap);
    const Doc head = words(Gap::done, 2);
    const Doc body = braces(&ModelLayout::clauses, Gap::open, Gap::line);
    return doc_.cat(before, doc_.group(doc_.cat(head, body), body_limit));
}

/// The whole transition: `from A to B`, then one clause a line. Resets and a deadline stay on the line of the clause
/// before them.
Doc ModelLayout::clauses(Gap gap) {
    Doc result = phrase(gap);
    if (at("to")) result = doc_.cat(result, phrase(Gap::blank));
    bool awaits = false;
    while (!at("}") && !at_end()) {
        const bool trigger = at("trigger") || at("#");
        result = doc_.cat(result, clause(Gap::line, awaits));
        awaits = trigger;
    }
    return result;
}

Doc ModelLayout::clause(Gap gap, bool trigger_before) {
    const Gap near = trigger_before ? Gap::blank : gap;
    if (at("#")) return cat({token(near), token(Gap::none)});
    if (at("<{")) return deadline(near);
    const bool trigger = at("trigger");
    const bool action = at("action");
    const Doc word = token(gap);
    if (action) return doc_.cat(word, action_body());
    if (!trigger) return doc_.cat(word, at("else") ? token(Gap::blank) : expression(Gap::blank));
    return at_name() ? doc_.cat(word, communication(Gap::blank)) : word;
}

/// `<{ e }`
Doc ModelLayout::deadline(Gap gap) {
    const Doc open = token(gap);
    const Doc limit = expression(Gap::blank);
    return cat({open, limit, token(Gap::blank)});
}

}  // namespace robochart::frontend
