// SPDX-License-Identifier: Apache-2.0
// Parses tokens, blocks and definitions. See parser.hpp.
#include "claims/sleec/syntax/parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "claims/sleec/syntax/rules.hpp"

namespace robochart::sleec {
namespace {

using diagnostics::Advice;

constexpr std::string_view rule_form =
    "a rule has the form `R1 when EVENT and CONDITION then RESPONSE within 5 seconds unless CONDITION then RESPONSE`";
constexpr std::string_view limit_form = "a limit of time is `within 5 seconds`, with the unit in full";
constexpr std::string_view exception_form = "an exception is `unless CONDITION then RESPONSE`";
constexpr std::string_view comment_form = "a comment begins with `//`";
constexpr std::string_view constant_form = "`constant NAME = 5` defines a constant";
constexpr std::string_view value_form = "a value of an event is an argument: `goTo(3)`";
constexpr std::string_view numeric_form = "numbers are `numeric`";
constexpr std::string_view rule_name = "the name of a rule or 'rule_end'";
constexpr std::string_view definition = "a definition or 'def_end'";

constexpr std::array advice{
    Advice{"'when'", "NAME @ :", "`when` directly follows the name of a rule"},
    Advice{"'when'", "rule @", "a rule begins with its name, without a keyword"},
    Advice{"'when'", "in @ NUMBER", limit_form},
    Advice{"'when'", "after @ NUMBER", limit_form},
    Advice{"'when'", "until @", limit_form},
    Advice{"'when'", "except @", exception_form},
    Advice{"'when'", "never NAME @", "`not EVENT within 5 seconds` forbids a response"},
    Advice{"'when'", "shall @", "a response is an event: `then EVENT within 5 seconds`"},
    Advice{"'when'", "must @", "a response is an event: `then EVENT within 5 seconds`"},
    Advice{"'when'", "should @", "a response is an event: `then EVENT within 5 seconds`"},
    Advice{"'when'", "@", rule_form},
    Advice{rule_name, "@ when", "a rule begins with a name: `R1 when ...`"},
    Advice{rule_name, "if @", exception_form},
    Advice{rule_name, "unless NAME @ (", "`unless NAME(...)` names an event: declare it with `event NAME`"},
    Advice{rule_name, "@ and", "a rule requires one event: write another rule for another event"},
    Advice{rule_name, "@ or", "a rule requires one event: write another rule for another event"},
    Advice{"'then'", "@ or",
           "a rule begins with one event: write another rule for another event; join conditions with `and` and `or` "
           "after it"},
    Advice{"'then'", "when NAME @ >", value_form},
    Advice{"'then'", "when NAME @ <", value_form},
    Advice{"'then'", "when NAME @ =", value_form},
    Advice{"'then'", "@", rule_form},
    Advice{"", "within NUMBER @", limit_form},
    Advice{"", "measure NAME : @ bool", "truth values are `boolean`"},
    Advice{"", "measure NAME : @ int", numeric_form},
    Advice{"", "measure NAME : @ integer", numeric_form},
    Advice{"", "measure NAME : @ real", numeric_form},
    Advice{"", "measure NAME : @ float", numeric_form},
    Advice{"", "measure NAME : @ {", "a measure of named levels is `scale(low, high)`"},
    Advice{"')'", "NAME @ NAME", "separate levels with commas: `scale(low, high)`"},
    Advice{"'='", "constant NAME @", constant_form},
    Advice{definition, "@ const", constant_form},
    Advice{definition, "event NAME @ (", "an event is declared by its name; rules give its arguments: `goTo(1)`"},
    Advice{definition, "event NAME @ ,", "define each event separately: `event NAME`"},
    Advice{definition, "@ - -", comment_form},
    Advice{definition, "NAME @ -", "names consist of letters, digits and `_`"},
    Advice{"", "= @ =", "`=` compares values"},
    Advice{"'def_start'", "@",
           "a file begins with definitions, `def_start ... def_end`; `rule_start ... rule_end` "
           "follows"},
};

}  // namespace

Parser::Parser(std::vector<Token> tokens, diagnostics::Diagnostics& diagnostics)
    : Cursor(std::move(tokens), diagnostics, rules::findings, advice, max_depth) {}

std::span<const diagnostics::Advice> syntax_advice() {
    return advice;
}

words::WordUse Parser::use_of(std::string_view word) const {
    return is_reserved(word) ? words::WordUse::reserved : words::WordUse::name;
}

void Parser::refuse_construct(std::string_view what, Span span) {
    diagnostics_.report(rules::not_supported, span, {std::string(what)});
    throw SyntaxError{};
}

void Parser::report_extension(Span span, std::string_view what) {
    diagnostics_.report(rules::extension, span, {std::string(what)});
}

/// Reports only the first use of an extension, because many rules of a file may name values and states.
void Parser::report_first_extension(Span span, const std::string& what) {
    if (reported_.insert(what).second) report_extension(span, what);
}

/// True at the beginning of a definition or rule, or at the end of a block.
bool Parser::at_item() const {
    for (const std::string_view word : {"event", "measure", "constant", "def_end", "rule_start", "rule_end",
                                        "concern_start", "concern_end", "purpose_start", "purpose_end"})
        if (is_at(word)) return true;
    return at_name() && (is_at("when", 1) || is_at("exists", 1));
}

template <class Piece>
bool Parser::parse_guarded(const Piece& piece) {
    const std::size_t before = at_;
    try {
        piece();
        return true;
    } catch (const SyntaxError&) {
        depth_ = 0;
        if (at_ == before && !at_end()) take_token();
        while (!at_end() && !at_item()) take_token();
        return false;
    }
}

template <class Item>
void Parser::parse_block(std::string_view end, const Item& item) {
    while (!at_end() && !is_at(end)) {
        diagnostics_.poll();
        for (const std::string_view other : {"rule_start", "concern_start", "purpose_start"})
            if (is_at(other)) fail(fmt::format("'{}'", end));
        (void)parse_guarded(item);
    }
    expect(end);
}

RuleFile Parser::parse_file() {
    RuleFile file;
    const bool defined = parse_guarded([&] {
        expect("def_start");
        parse_block("def_end", [&] { parse_definition(file); });
    });
    if (defined || !at_end())
        (void)parse_guarded([&] {
            expect("rule_start");
            parse_block("rule_end", [&] { file.rules.push_back(parse_rule()); });
        });
    while (!at_end())
        (void)parse_guarded([&] {
            if (is_at("concern_start")) {
                only_in(Dialect::legos, take_token().span, "a block of concerns");
                parse_block("concern_end", [&] { file.concerns.push_back(parse_property(true)); });
            } else if (is_at("purpose_start")) {
                only_in(Dialect::legos, take_token().span, "a block of purposes");
                parse_block("purpose_end", [&] { file.purposes.push_back(parse_property(false)); });
            } else if (is_at("relation_start")) {
                const Span span = take_token().span;
                while (!at_end() && !accept("relation_end")) take_token();
                refuse_construct("relations (relation_start ... relation_end)", span);
            } else {
                fail("the end of the text", {"concern_start", "purpose_start"});
            }
        });
    decide_dialect(file);
    return file;
}

void Parser::parse_definition(RuleFile& file) {
    if (accept("event")) {
        file.events.push_back({simple_name("the name of an event")});
        events_.insert(file.events.back().name.text);
        return;
    }
    if (is_at("measure")) {
        file.measures.push_back(parse_measure());
        measures_.insert(file.measures.back().name.text);
        return;
    }
    if (is_at("constant")) return file.constants.push_back(parse_constant());
    if (is_at("map") && at_name(1) && is_at("to", 2)) return file.mappings.push_back(parse_mapping());
    fail("a definition or 'def_end'", {"event", "measure", "constant", "map", "def_end"});
}

/// Parses `measure m : boolean | numeric | scale(a, b, ...)`.
Measure Parser::parse_measure() {
    Measure result;
    expect("measure");
    result.name = simple_name("the name of a measure");
    expect(":");
    if (accept("boolean")) return result;
    if (accept("numeric")) {
        result.type = MeasureType::numeric;
        return result;
    }
    if (!accept("scale")) fail("'boolean', 'numeric' or 'scale'", {"boolean", "numeric", "scale"});
    result.type = MeasureType::scale;
    expect("(");
    do result.literals.push_back(simple_name("a value of the scale"));
    while (accept(","));
    expect(")");
    return result;
}

/// Parses `constant C = 5`; the value may also be another constant.
Constant Parser::parse_constant() {
    Constant result;
    expect("constant");
    result.name = simple_name("the name of a constant");
    expect("=");
    result.value = parse_time();
    return result;
}

/// Parses `map EVENT to Module::event`.
Mapping Parser::parse_mapping() {
    Mapping result;
    const Span from = expect("map");
    result.name = simple_name("the name of an event or a measure");
    expect("to");
    result.element = qualified_name("an element of the model");
    report_extension(span_since(from), "map");
    return result;
}

/// Sets the dialect. It is LEGOS if a construct belongs only to LEGOS. Constructs that belong only to the other dialect
/// are then reported, once each.
void Parser::decide_dialect(RuleFile& file) {
    for (const Feature& feature : features_)
        if (feature.dialect == Dialect::legos) {
            file.dialect = Dialect::legos;
            file.decided_by = feature.span;
            break;
        }
    std::set<std::string> named;
    for (const Feature& feature : features_) {
        if (feature.dialect == file.dialect) {
            if (!file.decided_by.is_known()) file.decided_by = feature.span;
            continue;
        }
        if (!named.insert(feature.what).second) continue;
        auto& finding =
            diagnostics_.report(rules::other_dialect, feature.span, {feature.what, dialect_name(file.dialect)});
        finding.notes.push_back({file.decided_by, fmt::format("only {} reads this", dialect_name(file.dialect))});
    }
}

}  // namespace robochart::sleec
