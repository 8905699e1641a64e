// SPDX-License-Identifier: Apache-2.0
// Files, declarations, components and types: one declaration a line; bodies in braces are indented by one tab.
#include <algorithm>
#include <array>

#include "frontend/format/format_model.hpp"

namespace robochart::frontend {

// ---------------------------------------------------------------- bodies and lists

Doc ModelLayout::members(ModelPart part, Gap inside, Gap between) {
    Doc result = 0;
    after_block_ = false;
    for (Gap gap = inside; !at("}") && !at_end(); gap = between) result = doc_.cat(result, (this->*part)(gap));
    return doc_.cat(result, closing_comments());
}

/// `{ … }`; `inside` is what follows the brace, `between` what separates members.
Doc ModelLayout::braces(ModelPart part, Gap inside, Gap between) {
    const Doc open = token(Gap::blank);
    const Doc body = members(part, inside, between);
    const Doc close = body == 0 ? 0 : inside == Gap::first ? doc_.hard() : doc_.line();
    after_block_ = body != 0 && inside == Gap::first;
    return cat({open, doc_.nest(body), close, advance()});
}

// ---------------------------------------------------------------- members

/// True if a component with a body in braces begins here. The formatter writes empty lines around such components.
bool ModelLayout::opens_block() const {
    constexpr std::array<std::string_view, 9> words = {"interface", "robotic",  "controller", "stm",     "operation",
                                                       "module",    "datatype", "record",     "function"};
    if (std::ranges::none_of(words, [&](std::string_view word) { return at(word); })) return false;
    std::size_t ahead = 0;
    while (!peek(ahead).is("{") && peek(ahead).kind != TokenKind::end) ++ahead;
    return !peek(ahead + 1).is("}");
}

Doc ModelLayout::member(Gap gap) {
    const bool apart = gap == Gap::member && (after_block_ || opens_block());
    after_block_ = false;
    return declaration(apart ? Gap::block : gap);
}

Doc ModelLayout::declaration(Gap gap) {
    struct Row {
        std::string_view word;
        ModelPart part;
    };
    static constexpr std::array<Row, 38> rows = {{{"import", &ModelLayout::import},
                                                  {"interface", &ModelLayout::block},
                                                  {"robotic", &ModelLayout::block},
                                                  {"controller", &ModelLayout::block},
                                                  {"stm", &ModelLayout::block},
                                                  {"module", &ModelLayout::block},
                                                  {"operation", &ModelLayout::operation},
                                                  {"function", &ModelLayout::operation},
                                                  {"datatype", &ModelLayout::record},
                                                  {"record", &ModelLayout::record},
                                                  {"enumeration", &ModelLayout::enumeration},
                                                  {"package", &ModelLayout::phrase},
                                                  {"diagram", &ModelLayout::phrase},
                                                  {"type", &ModelLayout::phrase},
                                                  {"clock", &ModelLayout::phrase},
                                                  {"initial", &ModelLayout::phrase},
                                                  {"junction", &ModelLayout::phrase},
                                                  {"probabilistic", &ModelLayout::phrase},
                                                  {"uses", &ModelLayout::interfaces},
                                                  {"requires", &ModelLayout::interfaces},
                                                  {"provides", &ModelLayout::interfaces},
                                                  {"var", &ModelLayout::variables},
                                                  {"const", &ModelLayout::variables},
                                                  {"event", &ModelLayout::event},
                                                  {"_broadcast", &ModelLayout::event},
                                                  {"opref", &ModelLayout::reference},
                                                  {"sref", &ModelLayout::reference},
                                                  {"cref", &ModelLayout::reference},
                                                  {"rref", &ModelLayout::reference},
                                                  {"connection", &ModelLayout::connection},
                                                  {"precondition", &ModelLayout::contract},
                                                  {"postcondition", &ModelLayout::contract},
                                                  {"entry", &ModelLayout::action},
                                                  {"during", &ModelLayout::action},
                                                  {"exit", &ModelLayout::action},
                                                  {"state", &ModelLayout::state},
                                                  {"final", &ModelLayout::state},
                                                  {"transition", &ModelLayout::transition}}};
    for (const auto& [word, part] : rows)
        if (at(word)) return (this->*part)(gap);
    return at_name() ? signature(gap) : token(gap);
}

/// `stm S { … }`, `robotic platform R { … }`
Doc ModelLayout::block(Gap gap) {
    Doc head = token(gap);
    while (!at("{") && !at_end()) head = doc_.cat(head, token(Gap::blank));
    return doc_.cat(head, braces(&ModelLayout::member, Gap::first, Gap::member));
}

/// `operation O(…) { … }`, `function f(…) : T { … }`
Doc ModelLayout::operation(Gap gap) {
    Doc head = cat({token(gap), token(Gap::blank), list(Gap::none, &ModelLayout::variable)});
    if (at(":")) head = cat({head, token(Gap::blank), type(Gap::blank)});
    return doc_.cat(head, braces(&ModelLayout::member, Gap::first, Gap::member));
}

Doc ModelLayout::record(Gap gap) {
    const Doc head = words(gap, 2);
    return doc_.cat(head, braces(&ModelLayout::variable, Gap::first, Gap::member));
}

Doc ModelLayout::enumeration(Gap gap) {
    const Doc before = this->gap(gap);
    const Doc head = words(Gap::done, 2);
    const Doc body = braces(&ModelLayout::literal, Gap::open, Gap::line);
    return doc_.cat(before, doc_.group(doc_.cat(head, body), body_limit));
}

Doc ModelLayout::literal(Gap gap) {
    const Doc name = token(gap);
    return at("(") ? doc_.cat(name, list(Gap::none, &ModelLayout::type)) : name;
}

/// `uses I, J`
Doc ModelLayout::interfaces(Gap gap) {
    const Doc before = this->gap(gap);
    const Doc word = token(Gap::done);
    const Doc first = names(Gap::blank);
    Doc rest = 0;
    while (at(",")) rest = cat({rest, token(Gap::none), names(Gap::line)});
    return group(before, cat({word, first, doc_.nest(rest)}));
}

/// `var a : T = e, b : T`
Doc ModelLayout::variables(Gap gap) {
    const Doc before = this->gap(gap);
    const Doc word = token(Gap::done);
    const Doc first = variable(Gap::blank);
    Doc rest = 0;
    while (at(",")) rest = cat({rest, token(Gap::none), variable(Gap::line)});
    return group(before, cat({word, first, doc_.nest(rest)}));
}

/// `a : T = e`: variables, constants, parameters, fields.
Doc ModelLayout::variable(Gap gap) {
    const Doc result = typed(gap);
    return at("=") ? cat({result, token(Gap::blank), expression(Gap::blank)}) : result;
}

Doc ModelLayout::event(Gap gap) {
    const Doc word = words(gap, at("_broadcast") ? 2 : 1);
    return doc_.cat(word, typed(Gap::blank));
}

/// `op(p : T) [terminates]`
Doc ModelLayout::signature(Gap gap) {
    const Doc name = token(gap);
    const Doc result = doc_.cat(name, list(Gap::none, &ModelLayout::variable));
    return at("[") ? cat({result, token(Gap::blank), token(Gap::none), token(Gap::none)}) : result;
}

Doc ModelLayout::reference(Gap gap) {
    const Doc head = words(gap, 3);
    return doc_.cat(head, names(Gap::blank));
}

/// `connection A on e to B on f (_async) [mult]`
Doc ModelLayout::connection(Gap gap) {
    Doc result = phrase(gap);
    while (at("on") || at("to")) result = doc_.cat(result, phrase(Gap::blank));
    while (at("(") || at("[")) result = cat({result, token(Gap::blank), token(Gap::none), token(Gap::none)});
    return result;
}

Doc ModelLayout::contract(Gap gap) {
    const Doc word = token(gap);
    return doc_.cat(word, expression(Gap::blank));
}

}  // namespace robochart::frontend
