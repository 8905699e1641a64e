// SPDX-License-Identifier: Apache-2.0
// Formats files, declarations, components and types, with one declaration per line. Bodies in braces are indented by
// one tab.
#include <algorithm>
#include <array>

#include "frontend/format/format_model.hpp"

namespace robochart::frontend {

// ---------------------------------------------------------------- bodies and lists

Doc ModelLayout::format_members(ModelPart part, Gap inside, Gap between) {
    Doc result = 0;
    after_block_ = false;
    for (Gap gap = inside; !at("}") && !at_end(); gap = between) result = doc_.cat(result, (this->*part)(gap));
    return doc_.cat(result, closing_comments());
}

/// Formats `{ … }`. `inside` is the gap after the opening brace, and `between` is the gap between members.
Doc ModelLayout::format_braces(ModelPart part, Gap inside, Gap between) {
    const Doc open = format_token(Gap::blank);
    const Doc body = format_members(part, inside, between);
    Doc close = 0;
    if (body != 0) close = inside == Gap::first ? doc_.hard() : doc_.line();
    after_block_ = body != 0 && inside == Gap::first;
    return cat({open, doc_.nest_indented(body), close, advance()});
}

// ---------------------------------------------------------------- members

/// True if a component with a body in braces begins here. The formatter writes empty lines around such components.
bool ModelLayout::opens_block() const {
    constexpr std::array<std::string_view, 9> words = {"interface", "robotic",  "controller", "stm",     "operation",
                                                       "module",    "datatype", "record",     "function"};
    if (std::ranges::none_of(words, [&](std::string_view word) { return at(word); })) return false;
    std::size_t ahead = 0;
    while (!peek(ahead).is_word("{") && peek(ahead).kind != TokenKind::end) ++ahead;
    return !peek(ahead + 1).is_word("}");
}

Doc ModelLayout::format_member(Gap gap) {
    const bool apart = gap == Gap::member && (after_block_ || opens_block());
    after_block_ = false;
    return format_declaration(apart ? Gap::block : gap);
}

Doc ModelLayout::format_declaration(Gap gap) {
    struct Row {
        std::string_view word;
        ModelPart part;
    };
    static constexpr std::array<Row, 41> rows = {{{"import", &ModelLayout::format_import},
                                                  {"interface", &ModelLayout::format_block},
                                                  {"robotic", &ModelLayout::format_block},
                                                  {"controller", &ModelLayout::format_block},
                                                  {"stm", &ModelLayout::format_block},
                                                  {"module", &ModelLayout::format_block},
                                                  {"operation", &ModelLayout::format_operation},
                                                  {"function", &ModelLayout::format_operation},
                                                  {"datatype", &ModelLayout::format_record},
                                                  {"record", &ModelLayout::format_record},
                                                  {"enumeration", &ModelLayout::format_enumeration},
                                                  {"package", &ModelLayout::format_phrase},
                                                  {"diagram", &ModelLayout::format_phrase},
                                                  {"type", &ModelLayout::format_phrase},
                                                  {"clock", &ModelLayout::format_phrase},
                                                  {"initial", &ModelLayout::format_phrase},
                                                  {"junction", &ModelLayout::format_phrase},
                                                  {"probabilistic", &ModelLayout::format_phrase},
                                                  {"uses", &ModelLayout::format_interfaces},
                                                  {"requires", &ModelLayout::format_interfaces},
                                                  {"provides", &ModelLayout::format_interfaces},
                                                  {"var", &ModelLayout::format_variables},
                                                  {"const", &ModelLayout::format_variables},
                                                  {"event", &ModelLayout::format_event},
                                                  {"_broadcast", &ModelLayout::format_event},
                                                  {"opref", &ModelLayout::format_reference},
                                                  {"sref", &ModelLayout::format_reference},
                                                  {"cref", &ModelLayout::format_reference},
                                                  {"rref", &ModelLayout::format_reference},
                                                  {"connection", &ModelLayout::format_connection},
                                                  {"precondition", &ModelLayout::format_contract},
                                                  {"postcondition", &ModelLayout::format_contract},
                                                  {"cycleDef", &ModelLayout::format_cycle},
                                                  {"input", &ModelLayout::format_registers},
                                                  {"output", &ModelLayout::format_registers},
                                                  {"entry", &ModelLayout::format_action},
                                                  {"during", &ModelLayout::format_action},
                                                  {"exit", &ModelLayout::format_action},
                                                  {"state", &ModelLayout::format_state},
                                                  {"final", &ModelLayout::format_state},
                                                  {"transition", &ModelLayout::format_transition}}};
    for (const auto& [word, part] : rows)
        if (at(word)) return (this->*part)(gap);
    return at_name() ? format_signature(gap) : format_token(gap);
}

/// Formats `stm S { … }` or `robotic platform R { … }`.
Doc ModelLayout::format_block(Gap gap) {
    Doc head = format_token(gap);
    while (!at("{") && !at_end()) head = doc_.cat(head, format_token(Gap::blank));
    return doc_.cat(head, format_braces(&ModelLayout::format_member, Gap::first, Gap::member));
}

/// Formats `operation O(…) { … }` or `function f(…) : T { … }`.
Doc ModelLayout::format_operation(Gap gap) {
    Doc head =
        cat({format_token(gap), format_token(Gap::blank), format_list(Gap::none, &ModelLayout::format_variable)});
    if (at(":")) head = cat({head, format_token(Gap::blank), format_type(Gap::blank)});
    return doc_.cat(head, format_braces(&ModelLayout::format_member, Gap::first, Gap::member));
}

Doc ModelLayout::format_record(Gap gap) {
    const Doc head = format_words(gap, 2);
    return doc_.cat(head, format_braces(&ModelLayout::format_variable, Gap::first, Gap::member));
}

Doc ModelLayout::format_enumeration(Gap gap) {
    const Doc before = this->format_gap(gap);
    const Doc head = format_words(Gap::done, 2);
    const Doc body = format_braces(&ModelLayout::format_literal, Gap::open, Gap::line);
    return doc_.cat(before, doc_.group(doc_.cat(head, body), body_limit));
}

Doc ModelLayout::format_literal(Gap gap) {
    const Doc name = format_token(gap);
    return at("(") ? doc_.cat(name, format_list(Gap::none, &ModelLayout::format_type)) : name;
}

/// Formats `uses I, J`.
Doc ModelLayout::format_interfaces(Gap gap) {
    const Doc before = this->format_gap(gap);
    const Doc word = format_token(Gap::done);
    const Doc first = format_names(Gap::blank);
    Doc rest = 0;
    while (at(",")) rest = cat({rest, format_token(Gap::none), format_names(Gap::line)});
    return group(before, cat({word, first, doc_.nest_indented(rest)}));
}

/// Formats `var a : T = e, b : T`.
Doc ModelLayout::format_variables(Gap gap) {
    const Doc before = this->format_gap(gap);
    const Doc word = format_token(Gap::done);
    const Doc first = format_variable(Gap::blank);
    Doc rest = 0;
    while (at(",")) rest = cat({rest, format_token(Gap::none), format_variable(Gap::line)});
    return group(before, cat({word, first, doc_.nest_indented(rest)}));
}

/// Formats `a : T = e`: a variable, constant, parameter or field.
Doc ModelLayout::format_variable(Gap gap) {
    const Doc result = format_typed(gap);
    return at("=") ? cat({result, format_token(Gap::blank), format_expression(Gap::blank)}) : result;
}

Doc ModelLayout::format_event(Gap gap) {
    const Doc word = format_words(gap, at("_broadcast") ? 2 : 1);
    return doc_.cat(word, format_typed(Gap::blank));
}

/// Formats `op(p : T) [terminates]`.
Doc ModelLayout::format_signature(Gap gap) {
    const Doc name = format_token(gap);
    const Doc result = doc_.cat(name, format_list(Gap::none, &ModelLayout::format_variable));
    return at("[") ? cat({result, format_token(Gap::blank), format_token(Gap::none), format_token(Gap::none)}) : result;
}

Doc ModelLayout::format_reference(Gap gap) {
    const Doc head = format_words(gap, 3);
    return doc_.cat(head, format_names(Gap::blank));
}

/// Formats `connection A on e to B on f (_async) [mult]`.
Doc ModelLayout::format_connection(Gap gap) {
    Doc result = format_phrase(gap);
    while (at("on") || at("to")) result = doc_.cat(result, format_phrase(Gap::blank));
    while (at("(") || at("["))
        result = cat({result, format_token(Gap::blank), format_token(Gap::none), format_token(Gap::none)});
    return result;
}

Doc ModelLayout::format_contract(Gap gap) {
    const Doc word = format_token(gap);
    return doc_.cat(word, format_expression(Gap::blank));
}

}  // namespace robochart::frontend
