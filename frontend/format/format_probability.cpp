// SPDX-License-Identifier: Apache-2.0
// Formats probabilistic assertions. Each property, constant, reward, function and command is written on one line, or on
// several indented lines if it is too long.
#include <algorithm>
#include <array>

#include "frontend/format/format_assertions.hpp"

namespace robochart::frontend {

namespace {

constexpr std::array<std::string_view, 7> definition_words = {"const",   "constants", "label",   "formula",
                                                              "rewards", "defs",      "pmodules"};

}  // namespace

// ---------------------------------------------------------------- members

bool AssertionLayout::at_probabilistic_part() const {
    return at_word("prob") ||
           std::ranges::any_of(definition_words, [&](std::string_view word) { return at_word(word); });
}

Doc AssertionLayout::probabilistic_part(Gap gap) {
    probabilistic_ = true;
    const Doc result = at_word("prob") ? probabilistic_assertion(gap) : format_definition(gap);
    probabilistic_ = false;
    return result;
}

/// Formats `prob property P : e with …`.
Doc AssertionLayout::probabilistic_assertion(Gap gap) {
    const Doc before = this->format_gap(gap);
    const bool path = at_word("generate", 1);
    const Doc head = format_words(Gap::done, path ? 5 : 4);
    const Doc body = path ? format_generation() : format_expression(Gap::line);
    return group(before, doc_.cat(head, doc_.nest_indented(doc_.cat(body, format_clauses()))));
}

/// Formats `using simulation for n steps up to m steps`.
Doc AssertionLayout::format_generation() {
    Doc result = format_words(Gap::line, 3);
    const auto counted = [&] {
        const Doc count = format_expression(Gap::blank);
        return doc_.cat(count, format_token(Gap::blank));
    };
    const bool deadlock = at_word("deadlock");
    result = doc_.cat(result, deadlock ? format_token(Gap::blank) : counted());
    const bool repeats = deadlock && at_word("with") && !at_word("constant", 1) && !at_word("constants", 1) &&
                         !at_word("definitions", 1) && !at_word("modules", 1) && !at_word("cmdoptions", 1);
    if (repeats) result = cat({result, format_token(Gap::blank), counted()});
    return at_word("up") ? cat({result, format_words(Gap::blank, 2), counted()}) : result;
}

/// Formats `with constants C` or `with cmdoptions "…"`.
Doc AssertionLayout::format_clauses() {
    Doc result = 0;
    while (at_word("with")) result = cat({result, format_words(Gap::line, 2), written_clause()});
    return result;
}

Doc AssertionLayout::written_clause() {
    if (at_word("pfunction") || at_word("poperation")) return format_functions();
    if (at_word("pmodule")) return format_modules();
    std::size_t behind = 1;
    while (peek(behind).is_word("::")) behind += 2;
    return at_word("set", behind) || at_word("from", behind) ? doc_.nest_indented(format_constants(Gap::blank))
                                                             : format_names(Gap::blank);
}

Doc AssertionLayout::format_definition(Gap gap) {
    const Doc before = this->format_gap(gap);
    const bool constant = at_word("const");
    const bool list = at_word("constants");
    const bool value = at_word("label") || at_word("formula");
    const bool reward = at_word("rewards");
    const bool function = at_word("defs");
    const Doc head = format_words(Gap::done, 3);
    if (constant) return cat({before, head, format_type(Gap::blank)});
    if (value) return group(before, doc_.cat(head, doc_.nest_indented(format_expression(Gap::line))));
    if (list) return group(before, doc_.cat(head, doc_.nest_indented(format_constants(Gap::line))));
    if (reward) return cat({before, head, format_rewards()});
    return cat({before, head, function ? format_functions() : format_modules()});
}

// ---------------------------------------------------------------- definitions

/// Formats `q set to e, …, and t from set {…}`, with all constants on one line, or one per line.
Doc AssertionLayout::format_constants(Gap first) {
    Doc result = constant_values(first);
    while (at(",") || at_word("and")) {
        if (at(",")) result = doc_.cat(result, format_token(Gap::none));
        if (at_word("and")) result = doc_.cat(result, format_token(Gap::blank));
        result = doc_.cat(result, constant_values(Gap::line));
    }
    return result;
}

Doc AssertionLayout::constant_values(Gap gap) {
    const Doc name = format_names(gap);
    const Doc how = format_words(Gap::blank, 2);
    return cat({name, how, format_expression(Gap::blank)});
}

Doc AssertionLayout::format_rewards() {
    Doc items = 0;
    while (!at_end() && !at_word("endrewards")) items = doc_.cat(items, reward_item(Gap::member));
    items = doc_.nest_indented(items);
    return doc_.cat(items, format_token(Gap::first));
}

/// Formats `[event] g : v;`.
Doc AssertionLayout::reward_item(Gap gap) {
    const Doc before = this->format_gap(gap);
    const bool labelled = at("[");
    Doc result = labelled ? format_list(Gap::done, &AssertionLayout::format_expression) : 0;
    result = doc_.cat(result, format_expression(labelled ? Gap::blank : Gap::done));
    result = cat({result, format_token(Gap::blank), format_expression(Gap::blank), format_token(Gap::none)});
    return doc_.cat(before, result);
}

Doc AssertionLayout::format_functions() {
    Doc result = 0;
    while (at_word("pfunction") || at_word("poperation")) result = doc_.cat(result, format_function(Gap::member));
    return doc_.nest_indented(result);
}

/// Formats `pfunction f(x) = { return e }`.
Doc AssertionLayout::format_function(Gap gap) {
    const Doc before = this->format_gap(gap);
    const bool returns = at_word("pfunction");
    Doc head = format_words(Gap::done, 2);
    head = cat({head, format_list(Gap::none, &AssertionLayout::format_expression), format_words(Gap::blank, 2)});
    Doc body = returns ? cat({format_token(Gap::line), format_expression(Gap::blank)}) : format_updates(Gap::line);
    body = doc_.nest_indented(doc_.cat(body, closing_comments()));
    return group(before, cat({head, body, doc_.line(), advance()}));
}

Doc AssertionLayout::format_modules() {
    Doc result = 0;
    while (at_word("pmodule")) result = doc_.cat(result, format_module(Gap::member));
    return doc_.nest_indented(result);
}

/// Formats `pmodule N { … }`, with one member per line.
Doc AssertionLayout::format_module(Gap gap) {
    const Doc head = format_words(gap, 3);
    Doc members = 0;
    for (Gap lead = Gap::first; !at("}") && !at_end(); lead = Gap::member)
        members = doc_.cat(members, module_member(lead));
    members = doc_.nest_indented(doc_.cat(members, closing_comments()));
    return cat({head, members, doc_.hard(), advance()});
}

/// Formats `x : [a to b] init e;` or `[event] g -> u & v;`.
Doc AssertionLayout::module_member(Gap gap) {
    const Doc before = this->format_gap(gap);
    Doc result = 0;
    if (at("[")) {
        result = format_list(Gap::done, &AssertionLayout::format_expression);
        result = doc_.cat(result, format_expression(Gap::blank));
        result = doc_.cat(result, format_token(Gap::blank));
        const Doc effect = at("skip") ? format_token(Gap::line) : format_updates(Gap::line);
        result = doc_.cat(result, doc_.nest_indented(effect));
    } else {
        result = format_words(Gap::done, 2);
        if (at("["))
            result = cat({result, format_token(Gap::blank), format_expression(Gap::none), format_token(Gap::blank),
                          format_expression(Gap::blank), format_token(Gap::none)});
        else
            result = doc_.cat(result, format_token(Gap::blank));
        if (at_word("init")) result = cat({result, format_token(Gap::blank), format_expression(Gap::blank)});
    }
    return group(before, doc_.cat(result, format_token(Gap::none)));
}

Doc AssertionLayout::format_updates(Gap gap) {
    const Doc before = this->format_gap(gap);
    Doc result = format_list(Gap::done, &AssertionLayout::format_update);
    while (at("&"))
        result = cat({result, format_token(Gap::line), format_list(Gap::blank, &AssertionLayout::format_update)});
    return group(before, result);
}

// ---------------------------------------------------------------- expressions

bool ExpressionLayout::at_probabilistic_form() const {
    constexpr std::array<std::string_view, 9> words = {"Prob",     "Reward", "Forall",  "Exists", "Finally",
                                                       "Globally", "Next",   "Release", "Weak"};
    const bool sign = at("$") || at("#") || at("@") || at("&");
    return probabilistic_ && (sign || std::ranges::any_of(words, [&](std::string_view word) { return at_word(word); }));
}

Doc ExpressionLayout::probabilistic_form() {
    if (at("$") || at("#") || at("@") || at("&")) {
        Doc sign = format_token(Gap::done);
        if (at("$")) sign = doc_.cat(sign, format_token(Gap::none));
        return doc_.cat(sign, format_names(Gap::none));
    }
    if (at_word("Prob") || at_word("Reward")) return format_quantitative();
    if (!at_word("Forall") && !at_word("Exists")) return path_prefix();
    const Doc word = format_token(Gap::done);
    return doc_.cat(word, format_list(Gap::blank, &ExpressionLayout::format_expression));
}

/// Formats `Finally <=10 φ`.
Doc ExpressionLayout::path_prefix() {
    Doc word = format_words(Gap::done, at_word("Weak") ? 2 : 1);
    word = doc_.cat(word, step_bound());
    return doc_.cat(word, format_expression(Gap::blank));
}

Doc ExpressionLayout::step_bound() {
    if (at("[")) return format_list(Gap::blank, &ExpressionLayout::format_expression);
    const bool bounded = at("<=") || at("<") || at(">=") || at(">");
    if (!bounded) return 0;
    const Doc relation = format_token(Gap::blank);
    const Doc before = format_gap(Gap::none);
    return cat({relation, before, format_atom()});
}

/// Formats `Prob=? of [φ] using sim …` or `Reward {r} >= 1 of [ρ]`.
Doc ExpressionLayout::format_quantitative() {
    const bool reward = at_word("Reward");
    Doc result = format_token(Gap::done);
    if (at("{")) result = cat({result, format_token(Gap::blank), format_token(Gap::none), format_token(Gap::none)});
    const bool named = last_token() && last_token()->is_word("}");
    if (at_word("min") || at_word("max")) {
        result = cat({result, format_token(Gap::blank), format_token(Gap::none), format_token(Gap::none)});
    } else if (at("=")) {
        result = cat({result, format_token(named ? Gap::blank : Gap::none), format_token(Gap::none)});
    } else {
        result = doc_.cat(result, format_token(named ? Gap::blank : Gap::none));
        result = doc_.cat(result, format_operand(Gap::none, plus_level));
    }
    result = doc_.cat(result, format_token(Gap::blank));
    result = doc_.cat(result, format_list(Gap::blank, reward ? &ExpressionLayout::reward_path
                                                             : &ExpressionLayout::format_expression));
    return at_word("using") ? doc_.cat(result, format_simulation()) : result;
}

Doc ExpressionLayout::reward_path(Gap gap) {
    const bool total = at_word("Total");
    const Doc word = format_token(gap);
    return total ? word : doc_.cat(word, format_expression(Gap::blank));
}

/// Formats `using sim with CI at alpha=0.05, n=1000, and pathlen=1000`.
Doc ExpressionLayout::format_simulation() {
    Doc result = format_words(Gap::line, 5);
    result = doc_.cat(result, format_assigned(Gap::blank));
    while (at_word("and") || (at(",") && (at_word("and", 1) || peek(2).is_word("=")))) {
        if (at(",")) result = doc_.cat(result, format_token(Gap::none));
        if (at_word("and")) result = doc_.cat(result, format_token(Gap::blank));
        result = doc_.cat(result, format_assigned(Gap::blank));
    }
    return result;
}

/// Formats `n=1000` of a simulation.
Doc ExpressionLayout::format_assigned(Gap gap) {
    const Doc name = format_token(gap);
    const Doc equals = format_token(Gap::none);
    return cat({name, equals, format_operand(Gap::none, plus_level)});
}

Doc ExpressionLayout::format_update(Gap gap) {
    const Doc before = this->format_gap(gap);
    std::size_t behind = at("@") ? 2 : 1;
    while (peek(behind).is_word("::")) behind += 2;
    Doc result = 0;
    if (!peek(behind).is_word("=")) {
        result = format_expression(Gap::done);
        result = cat({result, format_token(Gap::blank), format_operand(Gap::blank, value_level)});
    } else {
        result = format_operand(Gap::done, value_level);
    }
    result = doc_.cat(result, format_token(Gap::blank));
    return cat({before, result, format_expression(Gap::blank)});
}

/// Formats `M is in S` or `a::e.in.val`.
Doc ExpressionLayout::behind_name(Doc name) {
    if (at("is") && peek(1).is_word("in")) {
        const Doc relation = format_words(Gap::blank, 2);
        return cat({name, relation, format_names(Gap::blank)});
    }
    while (at(".")) name = cat({name, format_token(Gap::none), format_token(Gap::none)});
    return at("(|") ? doc_.cat(name, format_list(Gap::none, &ExpressionLayout::format_field)) : name;
}

}  // namespace robochart::frontend
