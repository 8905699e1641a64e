// SPDX-License-Identifier: Apache-2.0
// Formats assertion files, with one assertion per line. CSP blocks and parts for other tools are copied unchanged.
#include "frontend/format/format_assertions.hpp"

namespace robochart::frontend {

Doc AssertionLayout::format_member(Gap gap) {
    if (kept_at_ < kept_.size() && kept_[kept_at_].begin == peek().span.begin) return format_kept_part(gap);
    if (at("import")) return format_import(gap);
    if (at("package")) return format_phrase(gap);
    const std::size_t timed = at_word("timed") || at_word("untimed") ? 1 : 0;
    if (at_word("assertion", timed)) return format_assertion(gap);
    if (at_word("csp", timed)) return csp_block(gap);
    const bool simulates = at_word("simulation") && at_word("of", 2);
    if (simulates) return format_simulation(gap);
    return at_probabilistic_part() ? probabilistic_part(gap) : format_token(gap);
}

/// Formats a part for another tool, which ends with the last token that the parser assigned to the part.
Doc AssertionLayout::format_kept_part(Gap gap) {
    const Doc before = this->format_gap(gap);
    const diagnostics::Span span = kept_[kept_at_++];
    while (!at_end() && peek().span.begin < span.end) static_cast<void>(advance());
    skip_comments(span.end);
    return doc_.cat(before, doc_.plain_text(text().substr(span.begin, span.end - span.begin)));
}

/// Formats `timed csp NAME associated to X, Y csp-begin … csp-end`.
Doc AssertionLayout::csp_block(Gap gap) {
    const std::size_t head = at_word("csp") ? 2 : 3;
    Doc result = format_words(gap, head);
    if (at_word("associated")) {
        result = cat({result, format_words(Gap::blank, 2), format_names(Gap::blank)});
        while (at(",")) result = cat({result, format_token(Gap::none), format_names(Gap::blank)});
    }
    return doc_.cat(result, format_token(Gap::blank));
}

/// Formats `simulation N of M { cycleDef e input context {…} output context {…} }`, with one part per line.
Doc AssertionLayout::format_simulation(Gap gap) {
    const Doc head = cat({format_words(gap, 3), format_names(Gap::blank), format_token(Gap::blank)});
    Doc body = 0;
    for (Gap next = Gap::first; !at("}") && !at_end(); next = Gap::member)
        body = doc_.cat(body, at("cycleDef") ? format_cycle(next) : format_registers(next));
    body = doc_.cat(body, closing_comments());
    const Doc close = body != 0 ? doc_.hard() : 0;
    return cat({head, doc_.nest_indented(body), close, advance()});
}

/// Formats `timed assertion NAME : … in the … model with … .`
Doc AssertionLayout::format_assertion(Gap gap) {
    const Doc before = this->format_gap(gap);
    const std::size_t head = at_word("assertion") ? 3 : 4;
    Doc result = format_words(Gap::done, head);
    result = doc_.cat(result, assertion_body());
    Doc rest = 0;
    if (at("in")) {
        rest = format_words(Gap::line, 2);
        while (!at_word("model") && !at_end()) rest = doc_.cat(rest, format_hyphenated());
        rest = doc_.cat(rest, format_token(Gap::blank));
    }
    if (at_word("with")) rest = doc_.cat(rest, format_parameters());
    result = group(before, doc_.cat(result, doc_.nest_indented(rest)));
    return at(".") ? doc_.cat(result, format_token(Gap::none)) : result;
}

/// Formats a token, or two joined by `-`.
Doc AssertionLayout::format_hyphenated() {
    const Doc word = format_token(Gap::blank);
    return at("-") ? cat({word, format_token(Gap::none), format_token(Gap::none)}) : word;
}

/// Formats `X is …`, `X does not …`, `X terminates`, `X refines Y`, `X equals Y`, `clock C is initialised` or `event E
/// is …`.
Doc AssertionLayout::assertion_body() {
    const Doc subject = at("clock") || at("event") ? format_phrase(Gap::blank) : format_names(Gap::blank);
    if (at_word("refines") || at_word("equals")) return cat({subject, format_phrase(Gap::blank)});
    const bool described = at("is") || at_word("does");
    Doc result = doc_.cat(subject, format_token(Gap::blank));
    if (described && at("not")) result = doc_.cat(result, format_token(Gap::blank));
    return described ? doc_.cat(result, format_property()) : result;
}

/// Formats `deadlock-free`, `reachable in X`, `equal to Y`, `refine Y`, `terminate` or `missed in X for N time units`.
Doc AssertionLayout::format_property() {
    if (at_word("missed")) {
        const Doc missed = cat({format_token(Gap::blank), format_phrase(Gap::blank)});
        return at_word("for") ? cat({missed, format_words(Gap::blank, 4)}) : missed;
    }
    const bool refine = at_word("refine");
    const bool related = at_word("reachable") || at_word("equal");
    const Doc word = format_hyphenated();
    if (refine) return cat({word, format_names(Gap::blank)});
    return related ? cat({word, format_phrase(Gap::blank)}) : word;
}

/// Formats `with P, P and P`.
Doc AssertionLayout::format_parameters() {
    Doc result = cat({format_token(Gap::line), format_parameter(Gap::blank)});
    while (at(",") || at_word("and")) {
        if (at(",")) result = doc_.cat(result, format_token(Gap::none));
        Gap gap = Gap::line;
        if (at_word("and")) {
            result = doc_.cat(result, format_token(gap));
            gap = Gap::blank;
        }
        result = doc_.cat(result, format_parameter(gap));
    }
    return result;
}

/// Formats `constant v of X set to e` or `cycleDef of X set to e`.
Doc AssertionLayout::format_parameter(Gap gap) {
    const Doc set = at("cycleDef") ? format_token(gap) : format_phrase(gap);
    Doc result = cat({set, format_phrase(Gap::blank)});
    const std::size_t count = at_word("assigned") ? 1 : 2;
    result = doc_.cat(result, format_words(Gap::blank, count));
    return doc_.cat(result, format_expression(Gap::blank));
}

}  // namespace robochart::frontend
