// Files, declarations, components and types: one declaration a line, bodies in braces indented by one tab.
#include <algorithm>
#include <array>

#include "frontend/format/format_layout.hpp"

namespace robochart::frontend {

// ---------------------------------------------------------------- bodies and lists

Doc Layout::members(Part part, Gap inside, Gap between) {
    Doc result = 0;
    after_block_ = false;
    for (Gap gap = inside; !at("}") && !at_end(); gap = between) result = doc_.cat(result, (this->*part)(gap));
    return doc_.cat(result, closing_comments());
}

/// `{ … }`; `inside` is what follows the brace, `between` what separates members.
Doc Layout::braces(Part part, Gap inside, Gap between) {
    const Doc open = token(Gap::blank);
    const Doc body = members(part, inside, between);
    const Doc close = body == 0 ? 0 : inside == Gap::first ? doc_.hard() : doc_.line();
    after_block_ = body != 0 && inside == Gap::first;
    return cat({open, doc_.nest(body), close, advance()});
}

/// A bracketed list with `,` or `;`: on one line, or one element a line.
Doc Layout::list(Gap gap, Part element) {
    const Doc before = this->gap(gap);
    const Doc open = advance();
    return group(before, doc_.cat(open, elements(Gap::soft, element)));
}

/// The elements of a list and the closing bracket (the group is the caller's).
Doc Layout::elements(Gap first, Part element) {
    Doc inner = 0;
    for (Gap gap = first; !at_closing(); gap = Gap::line) {
        inner = doc_.cat(inner, (this->*element)(gap));
        if (at(",") || at(";")) inner = doc_.cat(inner, token(Gap::none));
    }
    inner = doc_.cat(inner, closing_comments());
    const Doc close = inner == 0 ? 0 : may_touch() ? doc_.soft() : doc_.line();
    return cat({doc_.nest(inner), close, advance()});
}

// ---------------------------------------------------------------- members

/// Does a component with a body of its own begin here? Such are set off by empty lines.
bool Layout::opens_block() const {
    constexpr std::array<std::string_view, 9> words = {"interface", "robotic",  "controller", "stm",     "operation",
                                                       "module",    "datatype", "record",     "function"};
    if (std::none_of(words.begin(), words.end(), [&](std::string_view word) { return at(word); })) return false;
    std::size_t ahead = 0;
    while (!peek(ahead).is("{") && peek(ahead).kind != TokenKind::end) ++ahead;
    return !peek(ahead + 1).is("}");
}

Doc Layout::member(Gap gap) {
    const bool apart = gap == Gap::member && (after_block_ || opens_block());
    after_block_ = false;
    return declaration(apart ? Gap::block : gap);
}

Doc Layout::declaration(Gap gap) {
    struct Row {
        std::string_view word;
        Part part;
    };
    static constexpr std::array<Row, 38> rows = {{{"import", &Layout::import},
                                                  {"interface", &Layout::block},
                                                  {"robotic", &Layout::block},
                                                  {"controller", &Layout::block},
                                                  {"stm", &Layout::block},
                                                  {"module", &Layout::block},
                                                  {"operation", &Layout::operation},
                                                  {"function", &Layout::operation},
                                                  {"datatype", &Layout::record},
                                                  {"record", &Layout::record},
                                                  {"enumeration", &Layout::enumeration},
                                                  {"package", &Layout::phrase},
                                                  {"diagram", &Layout::phrase},
                                                  {"type", &Layout::phrase},
                                                  {"clock", &Layout::phrase},
                                                  {"initial", &Layout::phrase},
                                                  {"junction", &Layout::phrase},
                                                  {"probabilistic", &Layout::phrase},
                                                  {"uses", &Layout::interfaces},
                                                  {"requires", &Layout::interfaces},
                                                  {"provides", &Layout::interfaces},
                                                  {"var", &Layout::variables},
                                                  {"const", &Layout::variables},
                                                  {"event", &Layout::event},
                                                  {"_broadcast", &Layout::event},
                                                  {"opref", &Layout::reference},
                                                  {"sref", &Layout::reference},
                                                  {"cref", &Layout::reference},
                                                  {"rref", &Layout::reference},
                                                  {"connection", &Layout::connection},
                                                  {"precondition", &Layout::contract},
                                                  {"postcondition", &Layout::contract},
                                                  {"entry", &Layout::action},
                                                  {"during", &Layout::action},
                                                  {"exit", &Layout::action},
                                                  {"state", &Layout::state},
                                                  {"final", &Layout::state},
                                                  {"transition", &Layout::transition}}};
    for (const auto& [word, part] : rows)
        if (at(word)) return (this->*part)(gap);
    return at_name() ? signature(gap) : token(gap);
}

/// A word and a name.
Doc Layout::phrase(Gap gap) {
    const Doc word = token(gap);
    return doc_.cat(word, names(Gap::blank));
}

Doc Layout::import(Gap gap) {
    const Doc result = phrase(gap);
    return at("::") ? cat({result, token(Gap::none), token(Gap::none)}) : result;
}

/// `stm S { … }`, `robotic platform R { … }`
Doc Layout::block(Gap gap) {
    Doc head = token(gap);
    while (!at("{") && !at_end()) head = doc_.cat(head, token(Gap::blank));
    return doc_.cat(head, braces(&Layout::member, Gap::first, Gap::member));
}

/// `operation O(…) { … }`, `function f(…) : T { … }`
Doc Layout::operation(Gap gap) {
    Doc head = cat({token(gap), token(Gap::blank), list(Gap::none, &Layout::variable)});
    if (at(":")) head = cat({head, token(Gap::blank), type(Gap::blank)});
    return doc_.cat(head, braces(&Layout::member, Gap::first, Gap::member));
}

Doc Layout::record(Gap gap) {
    const Doc head = words(gap, 2);
    return doc_.cat(head, braces(&Layout::variable, Gap::first, Gap::member));
}

Doc Layout::enumeration(Gap gap) {
    const Doc before = this->gap(gap);
    const Doc head = words(Gap::done, 2);
    const Doc body = braces(&Layout::literal, Gap::open, Gap::line);
    return doc_.cat(before, doc_.group(doc_.cat(head, body), body_limit));
}

Doc Layout::literal(Gap gap) {
    const Doc name = token(gap);
    return at("(") ? doc_.cat(name, list(Gap::none, &Layout::type)) : name;
}

/// `uses I, J`
Doc Layout::interfaces(Gap gap) {
    const Doc before = this->gap(gap);
    const Doc word = token(Gap::done);
    const Doc first = names(Gap::blank);
    Doc rest = 0;
    while (at(",")) rest = cat({rest, token(Gap::none), names(Gap::line)});
    return group(before, cat({word, first, doc_.nest(rest)}));
}

/// `var a : T = e, b : T`
Doc Layout::variables(Gap gap) {
    const Doc before = this->gap(gap);
    const Doc word = token(Gap::done);
    const Doc first = variable(Gap::blank);
    Doc rest = 0;
    while (at(",")) rest = cat({rest, token(Gap::none), variable(Gap::line)});
    return group(before, cat({word, first, doc_.nest(rest)}));
}

/// `a : T = e`: variables, constants, parameters, fields.
Doc Layout::variable(Gap gap) {
    const Doc result = typed(gap);
    return at("=") ? cat({result, token(Gap::blank), expression(Gap::blank)}) : result;
}

Doc Layout::typed(Gap gap) {
    const Doc name = token(gap);
    return at(":") ? cat({name, token(Gap::blank), type(Gap::blank)}) : name;
}

Doc Layout::event(Gap gap) {
    const Doc word = words(gap, at("_broadcast") ? 2 : 1);
    return doc_.cat(word, typed(Gap::blank));
}

/// `op(p : T) [terminates]`
Doc Layout::signature(Gap gap) {
    const Doc name = token(gap);
    const Doc result = doc_.cat(name, list(Gap::none, &Layout::variable));
    return at("[") ? cat({result, token(Gap::blank), token(Gap::none), token(Gap::none)}) : result;
}

Doc Layout::reference(Gap gap) {
    const Doc head = words(gap, 3);
    return doc_.cat(head, names(Gap::blank));
}

/// `connection A on e to B on f (_async) [mult]`
Doc Layout::connection(Gap gap) {
    Doc result = phrase(gap);
    while (at("on") || at("to")) result = doc_.cat(result, phrase(Gap::blank));
    while (at("(") || at("[")) result = cat({result, token(Gap::blank), token(Gap::none), token(Gap::none)});
    return result;
}

Doc Layout::contract(Gap gap) {
    const Doc word = token(gap);
    return doc_.cat(word, expression(Gap::blank));
}

// ---------------------------------------------------------------- types

/// Operators between types have a blank on either side.
Doc Layout::type(Gap gap) {
    const Doc before = this->gap(gap);
    Doc result = atomic_type(Gap::done);
    while (at("<->") || at("->") || at("*")) result = cat({result, token(Gap::blank), atomic_type(Gap::blank)});
    return doc_.cat(before, result);
}

Doc Layout::atomic_type(Gap gap) {
    if (at("(") || at("Set(") || at("Seq(")) return list(gap, &Layout::type);
    if (at("?")) return cat({token(gap), token(Gap::none)});
    if (!at("vector") && !at("matrix")) return names(gap);
    const Doc word = token(gap);
    return doc_.cat(word, list(Gap::none, &Layout::type_or_size));
}

/// An argument of `vector` and `matrix`: a type first, then sizes.
Doc Layout::type_or_size(Gap gap) {
    return gap == Gap::soft ? type(gap) : expression(gap);
}

}  // namespace robochart::frontend
