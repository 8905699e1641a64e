// SPDX-License-Identifier: Apache-2.0
// Probabilistic assertions: each property, constant, reward, function and command is written on one line, or on several
// indented lines if it is too long.
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
    const Doc result = at_word("prob") ? probabilistic_assertion(gap) : definition(gap);
    probabilistic_ = false;
    return result;
}

/// `prob property P : e with …`
Doc AssertionLayout::probabilistic_assertion(Gap gap) {
    const Doc before = this->gap(gap);
    const bool path = at_word("generate", 1);
    const Doc head = words(Gap::done, path ? 5 : 4);
    const Doc asked = path ? generation() : expression(Gap::line);
    return group(before, doc_.cat(head, doc_.nest(doc_.cat(asked, clauses()))));
}

/// `using simulation for n steps up to m steps`
Doc AssertionLayout::generation() {
    Doc result = words(Gap::line, 3);
    const auto counted = [&] {
        const Doc count = expression(Gap::blank);
        return doc_.cat(count, token(Gap::blank));
    };
    const bool deadlock = at_word("deadlock");
    result = doc_.cat(result, deadlock ? token(Gap::blank) : counted());
    const bool repeats = deadlock && at_word("with") && !at_word("constant", 1) && !at_word("constants", 1) &&
                         !at_word("definitions", 1) && !at_word("modules", 1) && !at_word("cmdoptions", 1);
    if (repeats) result = cat({result, token(Gap::blank), counted()});
    return at_word("up") ? cat({result, words(Gap::blank, 2), counted()}) : result;
}

/// `with constants C`, `with cmdoptions "…"`
Doc AssertionLayout::clauses() {
    Doc result = 0;
    while (at_word("with")) result = cat({result, words(Gap::line, 2), written_clause()});
    return result;
}

Doc AssertionLayout::written_clause() {
    if (at_word("pfunction") || at_word("poperation")) return functions();
    if (at_word("pmodule")) return modules();
    std::size_t behind = 1;
    while (peek(behind).is("::")) behind += 2;
    return at_word("set", behind) || at_word("from", behind) ? doc_.nest(constants(Gap::blank)) : names(Gap::blank);
}

Doc AssertionLayout::definition(Gap gap) {
    const Doc before = this->gap(gap);
    const bool constant = at_word("const");
    const bool list = at_word("constants");
    const bool value = at_word("label") || at_word("formula");
    const bool reward = at_word("rewards");
    const bool function = at_word("defs");
    const Doc head = words(Gap::done, 3);
    if (constant) return cat({before, head, type(Gap::blank)});
    if (value) return group(before, doc_.cat(head, doc_.nest(expression(Gap::line))));
    if (list) return group(before, doc_.cat(head, doc_.nest(constants(Gap::line))));
    return cat({before, head, reward ? rewards() : function ? functions() : modules()});
}

// ---------------------------------------------------------------- definitions

/// `q set to e, …, and t from set {…}`: all on one line, or one a line.
Doc AssertionLayout::constants(Gap first) {
    Doc result = constant_values(first);
    while (at(",") || at_word("and")) {
        if (at(",")) result = doc_.cat(result, token(Gap::none));
        if (at_word("and")) result = doc_.cat(result, token(Gap::blank));
        result = doc_.cat(result, constant_values(Gap::line));
    }
    return result;
}

Doc AssertionLayout::constant_values(Gap gap) {
    const Doc name = names(gap);
    const Doc how = words(Gap::blank, 2);
    return cat({name, how, expression(Gap::blank)});
}

Doc AssertionLayout::rewards() {
    Doc items = 0;
    while (!at_end() && !at_word("endrewards")) items = doc_.cat(items, reward_item(Gap::member));
    items = doc_.nest(items);
    return doc_.cat(items, token(Gap::first));
}

/// `[event] g : v;`
Doc AssertionLayout::reward_item(Gap gap) {
    const Doc before = this->gap(gap);
    const bool labelled = at("[");
    Doc result = labelled ? list(Gap::done, &AssertionLayout::expression) : 0;
    result = doc_.cat(result, expression(labelled ? Gap::blank : Gap::done));
    result = cat({result, token(Gap::blank), expression(Gap::blank), token(Gap::none)});
    return doc_.cat(before, result);
}

Doc AssertionLayout::functions() {
    Doc result = 0;
    while (at_word("pfunction") || at_word("poperation")) result = doc_.cat(result, function(Gap::member));
    return doc_.nest(result);
}

/// `pfunction f(x) = { return e }`
Doc AssertionLayout::function(Gap gap) {
    const Doc before = this->gap(gap);
    const bool returns = at_word("pfunction");
    Doc head = words(Gap::done, 2);
    head = cat({head, list(Gap::none, &AssertionLayout::expression), words(Gap::blank, 2)});
    Doc body = returns ? cat({token(Gap::line), expression(Gap::blank)}) : updates(Gap::line);
    body = doc_.nest(doc_.cat(body, closing_comments()));
    return group(before, cat({head, body, doc_.line(), advance()}));
}

Doc AssertionLayout::modules() {
    Doc result = 0;
    while (at_word("pmodule")) result = doc_.cat(result, module(Gap::member));
    return doc_.nest(result);
}

/// `pmodule N { … }`: one member a line.
Doc AssertionLayout::module(Gap gap) {
    const Doc head = words(gap, 3);
    Doc members = 0;
    for (Gap lead = Gap::first; !at("}") && !at_end(); lead = Gap::member)
        members = doc_.cat(members, module_member(lead));
    members = doc_.nest(doc_.cat(members, closing_comments()));
    return cat({head, members, doc_.hard(), advance()});
}

/// `x : [a to b] init e;`, `[event] g -> u & v;`
Doc AssertionLayout::module_member(Gap gap) {
    const Doc before = this->gap(gap);
    Doc result = 0;
    if (at("[")) {
        result = list(Gap::done, &AssertionLayout::expression);
        result = doc_.cat(result, expression(Gap::blank));
        result = doc_.cat(result, token(Gap::blank));
        const Doc effect = at("skip") ? token(Gap::line) : updates(Gap::line);
        result = doc_.cat(result, doc_.nest(effect));
    } else {
        result = words(Gap::done, 2);
        if (at("["))
            result = cat({result, token(Gap::blank), expression(Gap::none), token(Gap::blank), expression(Gap::blank),
                          token(Gap::none)});
        else
            result = doc_.cat(result, token(Gap::blank));
        if (at_word("init")) result = cat({result, token(Gap::blank), expression(Gap::blank)});
    }
    return group(before, doc_.cat(result, token(Gap::none)));
}

Doc AssertionLayout::updates(Gap gap) {
    const Doc before = this->gap(gap);
    Doc result = list(Gap::done, &AssertionLayout::update);
    while (at("&")) result = cat({result, token(Gap::line), list(Gap::blank, &AssertionLayout::update)});
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
        Doc sign = token(Gap::done);
        if (at("$")) sign = doc_.cat(sign, token(Gap::none));
        return doc_.cat(sign, names(Gap::none));
    }
    if (at_word("Prob") || at_word("Reward")) return quantitative();
    if (!at_word("Forall") && !at_word("Exists")) return path_prefix();
    const Doc word = token(Gap::done);
    return doc_.cat(word, list(Gap::blank, &ExpressionLayout::expression));
}

/// `Finally <=10 φ`
Doc ExpressionLayout::path_prefix() {
    Doc word = words(Gap::done, at_word("Weak") ? 2 : 1);
    word = doc_.cat(word, step_bound());
    return doc_.cat(word, expression(Gap::blank));
}

Doc ExpressionLayout::step_bound() {
    if (at("[")) return list(Gap::blank, &ExpressionLayout::expression);
    const bool bounded = at("<=") || at("<") || at(">=") || at(">");
    if (!bounded) return 0;
    const Doc relation = token(Gap::blank);
    const Doc before = gap(Gap::none);
    return cat({relation, before, atom()});
}

/// `Prob=? of [φ] using sim …`, `Reward {r} >= 1 of [ρ]`
Doc ExpressionLayout::quantitative() {
    const bool reward = at_word("Reward");
    Doc result = token(Gap::done);
    if (at("{")) result = cat({result, token(Gap::blank), token(Gap::none), token(Gap::none)});
    const bool named = last() && last()->is("}");
    if (at_word("min") || at_word("max")) {
        result = cat({result, token(Gap::blank), token(Gap::none), token(Gap::none)});
    } else if (at("=")) {
        result = cat({result, token(named ? Gap::blank : Gap::none), token(Gap::none)});
    } else {
        result = doc_.cat(result, token(named ? Gap::blank : Gap::none));
        result = doc_.cat(result, operand(Gap::none, plus_level));
    }
    result = doc_.cat(result, token(Gap::blank));
    result =
        doc_.cat(result, list(Gap::blank, reward ? &ExpressionLayout::reward_path : &ExpressionLayout::expression));
    return at_word("using") ? doc_.cat(result, simulation()) : result;
}

Doc ExpressionLayout::reward_path(Gap gap) {
    const bool total = at_word("Total");
    const Doc word = token(gap);
    return total ? word : doc_.cat(word, expression(Gap::blank));
}

/// `using sim with CI at alpha=0.05, n=1000, and pathlen=1000`
Doc ExpressionLayout::simulation() {
    Doc result = words(Gap::line, 5);
    result = doc_.cat(result, assigned(Gap::blank));
    while (at_word("and") || (at(",") && (at_word("and", 1) || peek(2).is("=")))) {
        if (at(",")) result = doc_.cat(result, token(Gap::none));
        if (at_word("and")) result = doc_.cat(result, token(Gap::blank));
        result = doc_.cat(result, assigned(Gap::blank));
    }
    return result;
}

/// `n=1000` of a simulation.
Doc ExpressionLayout::assigned(Gap gap) {
    const Doc name = token(gap);
    const Doc equals = token(Gap::none);
    return cat({name, equals, operand(Gap::none, plus_level)});
}

Doc ExpressionLayout::update(Gap gap) {
    const Doc before = this->gap(gap);
    std::size_t behind = at("@") ? 2 : 1;
    while (peek(behind).is("::")) behind += 2;
    Doc result = 0;
    if (!peek(behind).is("=")) {
        result = expression(Gap::done);
        result = cat({result, token(Gap::blank), operand(Gap::blank, value_level)});
    } else {
        result = operand(Gap::done, value_level);
    }
    result = doc_.cat(result, token(Gap::blank));
    return cat({before, result, expression(Gap::blank)});
}

/// `M is in S`, `a::e.in.val`
Doc ExpressionLayout::behind_name(Doc name) {
    if (at("is") && peek(1).is("in")) {
        const Doc relation = words(Gap::blank, 2);
        return cat({name, relation, names(Gap::blank)});
    }
    while (at(".")) name = cat({name, token(Gap::none), token(Gap::none)});
    return at("(|") ? doc_.cat(name, list(Gap::none, &ExpressionLayout::field)) : name;
}

}  // namespace robochart::frontend
