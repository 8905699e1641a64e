// SPDX-License-Identifier: Apache-2.0
// Parses tokens, items, scopes and bodies. See parser.hpp.
#include "claims/syntax/parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "claims/syntax/layout.hpp"
#include "claims/syntax/reader.hpp"
#include "claims/syntax/rules.hpp"

namespace robochart::claims {
namespace {

using diagnostics::Advice;

constexpr std::string_view claim_form = "a claim has the form `claim NAME : after estop until reset, never goTo`";
constexpr std::string_view value_form = "a value has a name: `goTo(w) with w > 3`";
constexpr std::string_view response_form = "a response is `obstacle leads to halt within 1 s`";
constexpr std::string_view claims_are_timed = "claims are timed, and the form of a claim says how it is compared";
constexpr std::string_view body = "'only', 'leads to' or 'at least'";

constexpr std::array advice{
    Advice{"", "NAME @ >", value_form},
    Advice{"", "NAME @ <", value_form},
    Advice{"", "NAME @ >=", value_form},
    Advice{"", "NAME @ <=", value_form},
    Advice{"", "NAME @ ==", value_form},
    Advice{"", "NAME @ !=", value_form},
    Advice{"", "NAME @ =", value_form},
    Advice{"", "= @ =", "`==` compares values"},
    Advice{"a claim", "@ assertion", "assertions are in `.assertions` files"},
    Advice{"a claim", "@ untimed", claims_are_timed},
    Advice{"a claim", "@ timed", claims_are_timed},
    Advice{"a claim", "@", claim_form},
    Advice{"the end of the claim", "@ in", claims_are_timed},
    Advice{body, "NAME @ never", "`never` comes first: `after stop, never goTo`"},
    Advice{body, "NAME @ must", response_form},
    Advice{body, "NAME @ then", response_form},
    Advice{body, "NAME @ implies", response_form},
    Advice{body, "when @", response_form},
    Advice{body, "if @", response_form},
    Advice{body, "after @", "a scope ends with a comma: `after stop, never goTo`"},
    Advice{body, "NAME @ after", "say `only after`, or `at least 3 s after`"},
    Advice{body, "NAME @ within", response_form},
    Advice{"','", "@ never", "a scope ends with a comma: `after stop, never goTo`"},
    Advice{"','", "@ between", "`after E until F` begins at E and ends at F"},
    Advice{"the unit of the duration", "NUMBER @", "a duration has a unit: `3 s`, `150 ms`, `2 min`, `30 units`"},
};

/// True for words that continue a claim after an event.
bool is_connective(std::string_view word) {
    constexpr std::array words{"or",     "and",   "with",   "only",  "leads",  "at",
                               "unless", "until", "before", "after", "within", "but"};
    return std::ranges::find(words, word) != words.end();
}

TimeUnit unit_of(std::string_view word) {
    struct Row {
        std::string_view word;
        TimeUnit unit;
    };
    constexpr std::array rows{
        Row{"ms", TimeUnit::milliseconds},
        Row{"millisecond", TimeUnit::milliseconds},
        Row{"milliseconds", TimeUnit::milliseconds},
        Row{"s", TimeUnit::seconds},
        Row{"second", TimeUnit::seconds},
        Row{"seconds", TimeUnit::seconds},
        Row{"min", TimeUnit::minutes},
        Row{"minute", TimeUnit::minutes},
        Row{"minutes", TimeUnit::minutes},
        Row{"h", TimeUnit::hours},
        Row{"hour", TimeUnit::hours},
        Row{"hours", TimeUnit::hours},
        Row{"unit", TimeUnit::units},
        Row{"units", TimeUnit::units},
    };
    const auto found = std::ranges::find(rows, word, &Row::word);
    return found == rows.end() ? TimeUnit::none : found->unit;
}

}  // namespace

Parser::Parser(std::vector<Token> tokens, diagnostics::Diagnostics& diagnostics)
    : Cursor(std::move(tokens), diagnostics, rules::findings, advice, max_depth) {}

std::span<const diagnostics::Advice> syntax_advice() {
    return advice;
}

// ---------------------------------------------------------------- tokens

words::WordUse Parser::use_of(std::string_view word) const {
    return is_connective(word) ? words::WordUse::connective : words::WordUse::name;
}

bool Parser::at_words(std::initializer_list<std::string_view> words) const {
    std::size_t ahead = 0;
    return std::ranges::all_of(words, [&](std::string_view word) { return is_at(word, ahead++); });
}

bool Parser::at_item() const {
    if (at_end()) return true;
    const bool named = peek(1).kind == Tok::word && (is_at(":", 2) || is_at("of", 2));
    if ((is_at("claim") || is_at("assume") || is_at("order")) && named) return true;
    return is_at("unit") && peek(1).kind == Tok::number && (at_ == 0 || !tokens_[at_ - 1].text.ends_with(","));
}

void Parser::skip_to_item() {
    while (!at_item()) take_token();
}

// ---------------------------------------------------------------- items

ClaimFile Parser::parse_file() {
    ClaimFile file;
    bool first = true;
    while (!at_end()) {
        diagnostics_.poll();
        const std::size_t before = at_;
        try {
            if (first && is_at("package")) {
                take_token();
                file.package = qualified_name("the name of a package");
            } else {
                parse_item(file);
            }
        } catch (const SyntaxError&) {
            if (at_ == before) take_token();
            skip_to_item();
        }
        first = false;
    }
    return file;
}

void Parser::parse_item(ClaimFile& file) {
    if (is_at("import")) {
        file.imports.push_back(parse_import());
    } else if (is_at("unit")) {
        const Span from = take_token().span;
        Duration unit = parse_duration();
        unit.span = span_since(from);
        file.units.push_back(unit);
    } else if (is_at("claim") || (is_at("assume") && at_item())) {
        file.claims.push_back(parse_claim());
    } else if (is_at("order") && at_item()) {
        file.orders.push_back(parse_order());
    } else {
        fail("a claim");
    }
}

Import Parser::parse_import() {
    take_token();
    Import result;
    result.name = qualified_name("the name of a package");
    if (accept("::")) {
        expect("*");
        result.wildcard = true;
    }
    return result;
}

/// Parses `order COMPONENT : E first, E drops E`. An event without a word continues the list before it.
Order Parser::parse_order() {
    Order order;
    const Span from = take_token().span;
    order.component = qualified_name("the name of a component");
    expect(":");
    bool drops = false, begun = false;
    Name event;
    do {
        (void)accept("^");
        const Name name = simple_name("an event");
        if (accept("first")) {
            order.first.push_back(name);
            drops = false;
        } else if (accept("drops")) {
            event = name;
            drops = true;
            order.drops.push_back({event, simple_name("an event")});
        } else if (!begun) {
            fail("'first' or 'drops'");
        } else if (drops) {
            order.drops.push_back({event, name});
        } else {
            order.first.push_back(name);
        }
        begun = true;
    } while (accept(","));
    order.span = span_since(from);
    if (!at_item() && !is_at("import") && !is_at("unit")) fail("the end of the order");
    return order;
}

Claim Parser::parse_claim() {
    Claim claim;
    claim.assumption = is_at("assume");
    const Span from = take_token().span;
    claim.name = simple_name("the name of the claim");
    if (accept("of")) claim.component = qualified_name("the name of a component");
    expect(":");
    const std::size_t begin = at_;
    claim.scope = parse_scope();
    claim.body = parse_body();
    if (at_constants()) claim.constants = parse_constants();
    claim.wording = one_line(std::span(tokens_).subspan(begin, at_ - begin));
    claim.span = span_since(from);
    if (!at_item() && !is_at("import") && !is_at("unit")) fail("the end of the claim");
    return claim;
}

/// True for `with constant C`. An event may carry a value called `constant`: `goTo(constant) with constant > 3`.
bool Parser::at_constants() const {
    return is_at("with") && is_at("constant", 1) && peek(2).kind == Tok::word && !is_connective(peek(2).text);
}

/// with constant C of X set to V, and constant C of X set to V: separated like the constants of assertions.
std::vector<SetConstant> Parser::parse_constants() {
    expect("with");
    std::vector<SetConstant> result{parse_constant()};
    while (is_at("and") || is_at(",")) {
        (void)accept(",");
        expect("and");
        result.push_back(parse_constant());
    }
    return result;
}

SetConstant Parser::parse_constant() {
    SetConstant result;
    expect("constant");
    result.name = simple_name("the name of a constant");
    expect("of");
    result.component = qualified_name("the name of a component");
    expect("set");
    expect("to");
    const Span from = peek().span;
    const bool negative = is_at("-");
    if (at_time(negative ? 1 : 0)) {
        result.duration = parse_duration();
    } else if (peek(negative ? 1 : 0).kind == Tok::number) {
        if (negative) take_token();
        result.value = fmt::format("{}{}", negative ? "-" : "", take_token().text);
    } else {
        result.value = qualified_name("a number, a truth value, a literal or a time").text;
    }
    result.value_span = span_since(from);
    return result;
}

/// True if a number with a unit of time follows. `unit 0.1 s` after a number begins an item.
bool Parser::at_time(std::size_t ahead) const {
    const bool begins_item = is_at("unit", ahead + 1) && peek(ahead + 2).kind == Tok::number;
    return peek(ahead).kind == Tok::number && unit_of(peek(ahead + 1).text) != TimeUnit::none && !begins_item;
}

Scope Parser::parse_scope() {
    Scope scope;
    const Span from = peek().span;
    if (accept("before")) {
        scope.kind = ScopeKind::before;
        scope.first = parse_events();
    } else if (is_at("after")) {
        take_token();
        scope.kind = ScopeKind::after;
        const bool named = peek(1).kind == Tok::word && !is_connective(peek(1).text);
        if (is_at("each") && named) {
            take_token();
            scope.kind = ScopeKind::after_each;
        } else if (is_at("first") && named) {
            take_token();
            scope.only_first = true;
        }
        scope.first = parse_events();
        if (is_at("until")) {
            if (scope.kind == ScopeKind::after_each) fail("','");
            take_token();
            scope.kind = ScopeKind::after_until;
            scope.last = parse_events();
        }
    } else if (is_at("for") && (peek(1).kind == Tok::number || is_at("-", 1))) {
        take_token();
        scope.kind = ScopeKind::for_after;
        scope.duration = parse_duration();
        expect("after");
        scope.first = parse_events();
    } else if (at_words({"in", "a", "cycle", "with"})) {
        for (int word = 0; word < 4; ++word) take_token();
        scope.kind = ScopeKind::cycle;
        scope.first = parse_events();
    } else if (is_at("while") && !is_connective(peek(1).text)) {
        take_token();
        scope.kind = ScopeKind::during;
        scope.condition = parse_disjunction();
    } else {
        return scope;
    }
    scope.span = span_since(from);
    expect(",");
    return scope;
}

/// True if the body is `CONDITION for at least D` or `CONDITION for at most D`.
bool Parser::at_duration_of_stay() const {
    for (std::size_t i = at_; i + 2 < tokens_.size(); ++i) {
        const auto is = [&](std::size_t place, std::string_view word) {
            return tokens_[place].kind == Tok::word && tokens_[place].text == word;
        };
        if (is(i, "claim") || is(i, "leads") || is(i, "only") || is(i, "never")) return false;
        if (is(i, "for") && is(i + 1, "at") && (is(i + 2, "least") || is(i + 2, "most"))) return true;
    }
    return false;
}

/// True if `possible` is followed by a condition and not by an event: `not ...`, `(...)`, `retries > 2`, `in S and
/// ...`, `in Operating::Held`.
bool Parser::at_condition() const {
    if (is_at("not") || is_at("(")) return true;
    std::size_t ahead = is_at("in") && peek(1).kind == Tok::word ? 1 : 0;
    const bool state = ahead == 1;
    ++ahead;
    bool path = false;
    while (is_at("::", ahead)) {
        path = true;
        ahead += 2;
    }
    if (state && (path || is_at("and", ahead))) return true;
    constexpr std::array symbols{"<", "<=", ">", ">=", "==", "!=", "+", "-", "*", "%"};
    return !state && std::ranges::any_of(symbols, [&](const char* symbol) { return is_at(symbol, ahead); });
}

Body Parser::parse_body() {
    Body result;
    const Span from = peek().span;
    if (is_at("never") && !is_connective(peek(1).text)) {
        take_token();
        result.kind = BodyKind::never;
        result.events = parse_events();
    } else if (is_at("possible") && !is_connective(peek(1).text)) {
        result = parse_possible(std::move(result));
    } else if (is_at("always") && !is_connective(peek(1).text)) {
        take_token();
        result.kind = BodyKind::always;
        result.condition = parse_disjunction();
    } else if (at_words({"can", "take"})) {
        result = parse_readiness(std::move(result));
    } else if (at_duration_of_stay()) {
        result = parse_stay(std::move(result));
    } else if (at_words({"at", "most"})) {
        result = parse_count(std::move(result));
    } else {
        result.events = parse_events();
        if (is_at("only"))
            result = parse_only(std::move(result));
        else if (at_words({"leads", "to"}))
            result = parse_leads(std::move(result));
        else if (at_words({"at", "least"}))
            result = parse_at_least(std::move(result));
        else
            fail(body);
    }
    result.span = span_since(from);
    return result;
}

/// Parses `possible E` or `possible P`.
Body Parser::parse_possible(Body result) {
    take_token();
    result.kind = BodyKind::possible;
    if (at_condition())
        result.condition = parse_disjunction();
    else
        result.events = parse_events();
    return result;
}

/// Parses `P for at least D` or `P for at most D`.
Body Parser::parse_stay(Body result) {
    result.condition = parse_disjunction();
    expect("for");
    expect("at");
    result.kind = is_at("least") ? BodyKind::for_at_least : BodyKind::for_at_most;
    take_token();
    result.duration = parse_duration();
    return result;
}

/// Parses `can take E [within D]`.
Body Parser::parse_readiness(Body result) {
    take_token();
    take_token();
    result.kind = BodyKind::can_take;
    result.events = parse_events();
    if (accept("within")) result.duration = parse_duration();
    return result;
}

/// Parses `at most N E [in any D]`.
Body Parser::parse_count(Body result) {
    result.kind = BodyKind::at_most;
    take_token();
    take_token();
    if (peek().kind != Tok::number || peek().text.find('.') != std::string_view::npos) fail("a whole number");
    result.count_span = peek().span;
    result.count = std::string(take_token().text);
    result.events = parse_events();
    if (at_words({"in", "any"})) {
        take_token();
        take_token();
        result.duration = parse_duration();
    }
    return result;
}

/// Parses `E only [within D] after E`.
Body Parser::parse_only(Body result) {
    take_token();
    result.kind = BodyKind::only_after;
    if (accept("within")) {
        result.kind = BodyKind::only_within;
        result.duration = parse_duration();
    }
    expect("after");
    result.others = parse_events();
    return result;
}

/// Parses `E leads to E [within D] [unless E]` or `E leads to E before E`.
Body Parser::parse_leads(Body result) {
    take_token();
    take_token();
    result.others = parse_events();
    if (accept("before")) {
        result.kind = BodyKind::leads_before;
        result.exceptions = parse_events();
        return result;
    }
    result.kind = BodyKind::leads;
    if (accept("within")) {
        result.kind = BodyKind::leads_within;
        result.duration = parse_duration();
    }
    parse_exceptions(result);
    return result;
}

/// Parses `E at least D after E [unless E]` or `E at least every D`.
Body Parser::parse_at_least(Body result) {
    take_token();
    take_token();
    if (accept("every")) {
        result.kind = BodyKind::every;
        result.duration = parse_duration();
        return result;
    }
    result.kind = BodyKind::at_least;
    result.duration = parse_duration();
    expect("after");
    result.others = parse_events();
    parse_exceptions(result);
    return result;
}

void Parser::parse_exceptions(Body& result) {
    if (accept("unless")) result.exceptions = parse_events();
}

Duration Parser::parse_duration() {
    Duration duration;
    const Span from = peek().span;
    duration.negative = accept("-");
    if (peek().kind != Tok::number) fail("a duration");
    duration.number = std::string(take_token().text);
    // `unit 0.1 s` after a number without unit begins an item.
    const bool begins_item = is_at("unit") && peek(1).kind == Tok::number;
    if (peek().kind == Tok::word && !begins_item) duration.unit = unit_of(peek().text);
    if (duration.unit != TimeUnit::none)
        take_token();
    else if (peek().kind == Tok::word && !is_connective(peek().text) && !at_item())
        fail("the unit of the duration");
    duration.span = span_since(from);
    return duration;
}

ClaimFile read_parts(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                     const std::vector<Span>& places, diagnostics::Diagnostics& diagnostics) {
    std::string text(sources.source_text(source));
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool inside = std::ranges::any_of(places, [&](Span place) { return i >= place.begin && i < place.end; });
        if (!inside && text[i] != '\n') text[i] = ' ';
    }
    ClaimFile file = Parser(lex(text, source, diagnostics), diagnostics).parse_file();
    file.source = source;
    return file;
}

ClaimFile read(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
               diagnostics::Diagnostics& diagnostics) {
    ClaimFile file = Parser(lex(sources.source_text(source), source, diagnostics), diagnostics).parse_file();
    file.source = source;
    return file;
}

}  // namespace robochart::claims
