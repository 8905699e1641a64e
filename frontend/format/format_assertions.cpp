// SPDX-License-Identifier: Apache-2.0
// Assertion files: one assertion a line. CSP blocks and parts of other tools are kept unchanged.
#include "frontend/format/format_assertions.hpp"

namespace robochart::frontend {

Doc AssertionLayout::member(Gap gap) {
    if (kept_at_ < kept_.size() && kept_[kept_at_].begin == peek().span.begin) return kept(gap);
    if (at("import")) return import(gap);
    if (at("package")) return phrase(gap);
    const std::size_t timed = at_word("timed") || at_word("untimed") ? 1 : 0;
    if (at_word("assertion", timed)) return assertion(gap);
    if (at_word("csp", timed)) return csp_block(gap);
    return at_probabilistic_part() ? probabilistic_part(gap) : token(gap);
}

/// A part of another tool, up to the last token that the parser assigned to it.
Doc AssertionLayout::kept(Gap gap) {
    const Doc before = this->gap(gap);
    const diagnostics::Span span = kept_[kept_at_++];
    while (!at_end() && peek().span.begin < span.end) static_cast<void>(advance());
    skip_comments(span.end);
    return doc_.cat(before, doc_.text(text().substr(span.begin, span.end - span.begin)));
}

/// `timed csp NAME associated to X, Y csp-begin … csp-end`
Doc AssertionLayout::csp_block(Gap gap) {
    const std::size_t head = at_word("csp") ? 2 : 3;
    Doc result = words(gap, head);
    if (at_word("associated")) {
        result = cat({result, words(Gap::blank, 2), names(Gap::blank)});
        while (at(",")) result = cat({result, token(Gap::none), names(Gap::blank)});
    }
    return doc_.cat(result, token(Gap::blank));
}

/// `timed assertion NAME : … in the … model with … .`
Doc AssertionLayout::assertion(Gap gap) {
    const Doc before = this->gap(gap);
    const std::size_t head = at_word("assertion") ? 3 : 4;
    Doc result = words(Gap::done, head);
    result = doc_.cat(result, assertion_body());
    Doc rest = 0;
    if (at("in")) {
        rest = words(Gap::line, 2);
        while (!at_word("model") && !at_end()) rest = doc_.cat(rest, hyphenated());
        rest = doc_.cat(rest, token(Gap::blank));
    }
    if (at_word("with")) rest = doc_.cat(rest, parameters());
    result = group(before, doc_.cat(result, doc_.nest(rest)));
    return at(".") ? doc_.cat(result, token(Gap::none)) : result;
}

/// A token, or two joined by `-`.
Doc AssertionLayout::hyphenated() {
    const Doc word = token(Gap::blank);
    return at("-") ? cat({word, token(Gap::none), token(Gap::none)}) : word;
}

/// `X is …`, `X does not …`, `X terminates`, `X refines Y`, `X equals Y`, `clock C is initialised`, `event E is …`
Doc AssertionLayout::assertion_body() {
    const Doc subject = at("clock") || at("event") ? phrase(Gap::blank) : names(Gap::blank);
    if (at_word("refines") || at_word("equals")) return cat({subject, phrase(Gap::blank)});
    const bool described = at("is") || at_word("does");
    Doc result = doc_.cat(subject, token(Gap::blank));
    if (described && at("not")) result = doc_.cat(result, token(Gap::blank));
    return described ? doc_.cat(result, property()) : result;
}

/// `deadlock-free`, `reachable in X`, `equal to Y`, `refine Y`, `terminate`, `missed in X for N time units`
Doc AssertionLayout::property() {
    if (at_word("missed")) {
        const Doc missed = cat({token(Gap::blank), phrase(Gap::blank)});
        return at_word("for") ? cat({missed, words(Gap::blank, 4)}) : missed;
    }
    const bool refine = at_word("refine");
    const bool related = at_word("reachable") || at_word("equal");
    const Doc word = hyphenated();
    if (refine) return cat({word, names(Gap::blank)});
    return related ? cat({word, phrase(Gap::blank)}) : word;
}

/// `with P, P and P`
Doc AssertionLayout::parameters() {
    Doc result = cat({token(Gap::line), parameter(Gap::blank)});
    while (at(",") || at_word("and")) {
        if (at(",")) result = doc_.cat(result, token(Gap::none));
        Gap gap = Gap::line;
        if (at_word("and")) {
            result = doc_.cat(result, token(gap));
            gap = Gap::blank;
        }
        result = doc_.cat(result, parameter(gap));
    }
    return result;
}

/// `constant v of X set to e`
Doc AssertionLayout::parameter(Gap gap) {
    Doc result = cat({phrase(gap), phrase(Gap::blank)});
    const std::size_t count = at_word("assigned") ? 1 : 2;
    result = doc_.cat(result, words(Gap::blank, count));
    return doc_.cat(result, expression(Gap::blank));
}

}  // namespace robochart::frontend
