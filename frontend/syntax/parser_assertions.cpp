// SPDX-License-Identifier: Apache-2.0
// Parses assertion files (Assertions.xtext). CSP blocks and the parts for other tools are stored as text.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "base/diagnostics/spelling.hpp"
#include "frontend/syntax/parser.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

/// True at the beginning of a part that is stored as text: `instantiate T as …`, or a definition of PRISM, at the
/// beginning of a line.
bool Parser::at_kept_part() const {
    if (at_word("instantiate")) {
        std::size_t ahead = 2;
        while (peek(ahead).is_word("::")) ahead += 2;
        if (peek(1).kind == TokenKind::identifier && at_word("as", ahead)) return true;
    }
    if (at_claim()) return true;
    constexpr std::array<std::string_view, 5> words = {"label", "formula", "rewards", "defs", "pmodules"};
    const bool known = std::ranges::any_of(words, [&](std::string_view word) { return at_word(word); });
    return known && peek().first_on_line && peek(1).kind == TokenKind::string;
}

/// True at a part of a claims file at the beginning of a line: `claim A : …`, `claim A of X : …` or `unit 0.1 s`.
bool Parser::at_claim() const {
    if (!peek().first_on_line) return false;
    if (at_word("unit")) return !peek(1).text.empty() && peek(1).text[0] >= '0' && peek(1).text[0] <= '9';
    const bool named = peek(1).kind == TokenKind::identifier && (peek(2).is_word(":") || at_word("of", 2));
    return named && (at_word("claim") || at_word("assume") || at_word("order"));
}

/// True at `robocert assertion …` at the beginning of a line, which is for another tool.
bool Parser::at_foreign_assertion() const {
    if (!peek().first_on_line || peek(1).first_on_line) return false;
    return peek().kind == TokenKind::identifier && !at_word("timed") && !at_word("untimed") && !at_word("assertion") &&
           !at_word("csp") && !at_word("sleec") && at_word("assertion", 1) && peek(2).kind == TokenKind::identifier;
}

/// Stores the text up to the next member, and reports that this tool does not check assertions of this kind.
void Parser::foreign_assertion(File& file) {
    const Span begin = peek().span;
    const std::string word(peek().text);
    advance_token();
    advance_token();
    const std::string name(peek().text);
    KeptPart part{word + " assertion", name, diagnostics::join_spans(begin, peek().span), true, {}, {}};
    while (!at_end() && !at_assertion_member()) advance_token();
    part.whole = {begin.source, begin.begin, span_since(begin).end};
    part.text = sources_.source_text(source_).substr(part.whole.begin, part.whole.end - part.whole.begin);
    report(syntax::foreign_assertion, part.whole, {name, word});
    quiet_until_ = 0;
    file.kept.push_back(std::move(part));
}

bool Parser::at_assertion_member() const {
    if (at_foreign_assertion()) return true;
    if (at_token("import") || at_token("package") || at_simulation() || at_probabilistic_part() || at_kept_part())
        return true;
    if (at_word("timed") || at_word("untimed"))
        return at_word("assertion", 1) || at_word("csp", 1) || at_word("sleec", 1);
    if (at_word("sleec")) return at_word("assertion", 1);
    return (at_word("assertion") || at_word("csp")) && peek(1).kind == TokenKind::identifier;
}

void Parser::assertion_member(File& file) {
    const std::size_t start = at_;
    const bool read = catch_syntax_error([&] {
        if (at_token("import")) return parse_import(file);
        if (at_token("package")) {
            report(syntax::late_package, peek().span);
            advance_token();
            qualified_name("the package's name");
            return;
        }
        AssertionTime time = AssertionTime::both;
        const Span word = peek().span;
        if (accept_word("timed"))
            time = AssertionTime::timed;
        else if (accept_word("untimed"))
            time = AssertionTime::untimed;
        refuse_untimed(time, word);
        if (time == AssertionTime::both && at_simulation()) return parse_simulation(file);
        if (time == AssertionTime::both && at_foreign_assertion()) return foreign_assertion(file);
        if (neural_construct()) return;
        if (at_word("assertion")) return parse_assertion(file, time);
        if (at_word("sleec") && time != AssertionTime::untimed) return rule_assertion(file);
        if (at_word("csp")) return csp_block(file, time);
        if (at_probabilistic_part() && time == AssertionTime::both) return probabilistic_part(file);
        if (at_word("claim") && time != AssertionTime::both)
            fail_expecting("`assertion` or `csp`: claims are about the timed semantics, without a word for it,");
        if (at_kept_part() && time == AssertionTime::both) return keep_as_text(file);
        fail_expecting("`assertion`, `csp` or `import`");
    });
    if (read) return;
    if (at_ == start) advance_token();
    while (!at_end() && !at_assertion_member()) advance_token();
}

/// Parses the head of a part that is stored as text, such as `instantiate P::T` or `label "…"`. The head includes the
/// whole qualified name.
KeptPart Parser::kept_part() const {
    KeptPart part{std::string(peek().text), {}, peek().span, false, {}, {}};
    std::size_t at = 1;
    const auto take = [&] {
        part.name += peek(at).text;
        part.span = diagnostics::join_spans(part.span, peek(at).span);
        ++at;
    };
    if (peek(at).kind == TokenKind::identifier || peek(at).kind == TokenKind::string) take();
    while (peek(at).is_word("::") && peek(at + 1).kind == TokenKind::identifier) {
        take();
        take();
    }
    return part;
}

/// Stores a part as text, up to the next member.
void Parser::keep_as_text(File& file) {
    const Span begin = peek().span;
    const bool rewards = at_word("rewards");
    const bool claim = at_claim();
    KeptPart part = kept_part();
    advance_token();
    while (!at_end() && (rewards ? !at_word("endrewards") : !at_assertion_member())) advance_token();
    if (rewards) accept_word("endrewards");
    part.whole = span_since(begin);
    part.text = sources_.source_text(source_).substr(part.whole.begin, part.whole.end - part.whole.begin);
    if (claim) {
        std::string name = sources_.path(source_);
        name = name.substr(name.rfind('/') + 1);
        // the text is a correct claim, so this is no syntax error
        out_.report(syntax::claim_in_assertions, part.span, {part.form, name.substr(0, name.rfind('.'))});
    }
    file.kept.push_back(std::move(part));
}

/// Parses `csp NAME associated to X, Y csp-begin … csp-end`.
void Parser::csp_block(File& file, AssertionTime time) {
    constexpr std::string_view open = "csp-begin";
    constexpr std::string_view close = "csp-end";
    CspBlock block;
    block.time = time;
    block.span = peek().span;
    expect_word("csp");
    const QualifiedName name = simple_name("the block's name");
    block.name = name.text();
    block.name_span = name.span;
    if (accept_word("associated")) {
        expect_word("to");
        do block.associated.push_back(qualified_name("the name of a component"));
        while (accept_token(","));
    }
    if (peek().kind != TokenKind::csp_code) fail_expecting("`csp-begin`");
    const Token code = advance_token();
    std::string_view text = code.text;
    text.remove_prefix(open.size());
    if (text.size() >= close.size() && text.substr(text.size() - close.size()) == close)
        text.remove_suffix(close.size());
    const auto begin = code.span.begin + static_cast<std::uint32_t>(open.size());
    block.text_span = {source_, begin, begin + static_cast<std::uint32_t>(text.size())};
    block.text = std::string(text);
    block.span = span_since(block.span);
    file.csp_blocks.push_back(std::move(block));
}

void Parser::assertion_name(Assertion& assertion) {
    expect_word("assertion");
    const QualifiedName name = simple_name("the assertion's name");
    assertion.name = name.text();
    assertion.name_span = name.span;
    expect_token(":");
}

/// Parses `sleec assertion N : C conforms to R` or `C does not conform to R`. The assertion is always timed, even
/// without the word `timed` before it.
void Parser::rule_assertion(File& file) {
    Assertion assertion;
    assertion.time = AssertionTime::timed;
    assertion.kind = AssertionKind::conforms;
    assertion.span = peek().span;
    expect_word("sleec");
    assertion_name(assertion);
    assertion.subject = qualified_name("the name of a component");
    assertion.negated = accept_word("does");
    if (assertion.negated) {
        expect_token("not");
        expect_word("conform");
    } else {
        expect_word("conforms");
    }
    expect_word("to");
    assertion.other = simple_name("the name of a rule");
    accept_token(".");
    assertion.span = span_since(assertion.span);
    file.assertions.push_back(std::move(assertion));
}

void Parser::parse_assertion(File& file, AssertionTime time) {
    Assertion assertion;
    assertion.time = time;
    const Span time_word = previous_token().span;
    assertion.span = peek().span;
    assertion_name(assertion);
    assertion_body(assertion, time_word);
    assertion_model(assertion);
    assertion_parameters(assertion);
    accept_token(".");
    assertion.span = span_since(assertion.span);
    file.assertions.push_back(std::move(assertion));
}

/// Reports `timed` or `untimed` before an assertion about clocks, where the grammar does not allow these words.
void Parser::refuse_time(AssertionTime time, Span word) {
    const std::string text = time == AssertionTime::timed ? "timed" : "untimed";
    if (diagnostics::Diagnostic* finding = report(syntax::clock_time, word, {text}))
        finding->fixes.push_back({word, "", "leave it out"});
    quiet_until_ = 0;
}

void Parser::assertion_body(Assertion& assertion, Span time_word) {
    if (at_token("clock")) {
        if (assertion.time != AssertionTime::both) refuse_time(assertion.time, time_word);
        advance_token();
        assertion.kind = AssertionKind::clock_initialised;
        assertion.other = qualified_name("the name of a clock");
        expect_token("is");
        assertion.negated = accept_token("not");
        return expect_word("initialised");
    }
    if (at_token("event")) return assertion_event(assertion);
    assertion.subject = qualified_name("the name of a component");
    if (accept_token("is")) return assertion_is(assertion);
    if (accept_word("does")) return assertion_does(assertion);
    if (accept_word("terminates")) {
        assertion.kind = AssertionKind::terminates;
        return;
    }
    const bool refines = at_word("refines");
    if (!refines && !at_word("equals")) fail_expecting("`is`, `does`, `terminates`, `refines` or `equals`");
    advance_token();
    assertion.kind = refines ? AssertionKind::refines : AssertionKind::equals;
    assertion.other = qualified_name("the name of a component or CSP process");
}

/// Parses `event E is not missed in S for N time units`.
void Parser::assertion_event(Assertion& assertion) {
    advance_token();
    assertion.kind = AssertionKind::event_missed;
    assertion.event = simple_name("the name of an event");
    expect_token("is");
    assertion.negated = accept_token("not");
    expect_word("missed");
    expect_token("in");
    assertion.other = qualified_name("the name of a state machine or state");
    if (!accept_word("for")) return;
    if (peek().kind != TokenKind::integer) return fail_expecting("a number of time units");
    const Token units = advance_token();
    std::int64_t value = 0;  // the lexer reports a number that is too large
    std::from_chars(units.text.data(), units.text.data() + units.text.size(), value);
    assertion.time_units = value;
    assertion.time_units_span = units.span;
    expect_word("time");
    if (!accept_word("unit")) expect_word("units");
}

/// Parses what follows `X is`: a property, `not equal to Y`, or `reachable in Y`.
void Parser::assertion_is(Assertion& assertion) {
    constexpr std::array<std::pair<std::string_view, AssertionKind>, 3> hyphenated = {
        {{"deadlock", AssertionKind::deadlock_free},
         {"divergence", AssertionKind::divergence_free},
         {"timelock", AssertionKind::timelock_free}}};
    assertion.negated = accept_token("not");
    for (const auto& [word, kind] : hyphenated) {
        if (!at_word(word)) continue;
        assertion.kind = kind;
        return hyphenated_word(word, "free");
    }
    if (accept_word("deterministic")) {
        assertion.kind = AssertionKind::deterministic;
    } else if (accept_word("reachable")) {
        assertion.kind = AssertionKind::reachable;
        expect_token("in");
        assertion.other = std::move(assertion.subject);
        assertion.subject = qualified_name("the name of a component");
    } else if (assertion.negated && accept_word("equal")) {
        expect_token("to");
        assertion.kind = AssertionKind::equals;
        assertion.other = qualified_name("the name of a component or CSP process");
    } else if (!schedulable_property(assertion)) {
        unknown_property();
    }
}

void Parser::unknown_property() {
    static const std::vector<std::string> words = {"deadlock",      "divergence", "timelock",
                                                   "deterministic", "reachable",  "initialised"};
    constexpr std::string_view expected = "a property such as `deadlock-free`";
    const std::string meant = form_meant(expected).empty() ? diagnostics::nearest_spelling(peek().text, words) : "";
    diagnostics::Diagnostic* const finding =
        report(syntax::unexpected, missing_place(), {std::string(expected), describe_token()});
    if (finding != nullptr && !meant.empty())
        finding->fixes.push_back(
            {peek().span, meant, diagnostics::suggestion_verb(diagnostics::is_certain(peek().text, meant, words))});
    throw SyntaxError{};
}

/// Parses what follows `X does`: `not terminate` or `not refine Y`.
void Parser::assertion_does(Assertion& assertion) {
    expect_token("not");
    assertion.negated = true;
    if (accept_word("terminate")) {
        assertion.kind = AssertionKind::terminates;
        return;
    }
    if (!accept_word("refine")) fail_expecting("`terminate` or `refine`");
    assertion.kind = AssertionKind::refines;
    assertion.other = qualified_name("the name of a component or CSP process");
}

/// Parses two words that are joined by `-`, such as `deadlock-free` and `tick-tock`.
void Parser::hyphenated_word(std::string_view first, std::string_view second) {
    const Span begin = peek().span;
    advance_token();
    const bool hyphen = accept_token("-");
    if (!at_word(second)) return expect_word(fmt::format("{}-{}", first, second));
    advance_token();
    const Span span = span_since(begin);
    const std::string word = fmt::format("{}-{}", first, second);
    if (hyphen && span.end - span.begin == word.size()) return;
    if (diagnostics::Diagnostic* finding = report(syntax::hyphenated, span, {word}))
        finding->fixes.push_back({span, word, "write"});
    quiet_until_ = 0;
}

/// Parses `in the traces model`.
void Parser::assertion_model(Assertion& assertion) {
    if (!accept_token("in")) return;
    expect_word("the");
    if (at_word("tick")) {
        hyphenated_word("tick", "tock");
        assertion.model = AssertionModel::tick_tock;
    } else if (accept_word("traces")) {
        assertion.model = AssertionModel::traces;
    } else if (accept_word("failures")) {
        pass_model_hyphen();
        assertion.model = accept_word("divergences") ? AssertionModel::failures_divergences : AssertionModel::failures;
    } else {
        fail_expecting("`traces`, `failures`, `failures divergences` or `tick-tock`");
    }
    expect_word("model");
}

/// Reports the hyphen in `failures-divergences` and skips it.
void Parser::pass_model_hyphen() {
    if (!at_token("-") || !at_word("divergences", 1)) return;
    const Span hyphen = peek().span;
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, hyphen, {"-", "this model is written `failures divergences`"});
    if (finding != nullptr) finding->fixes.push_back({hyphen, " ", "write a blank"});
    quiet_until_ = 0;
    advance_token();
}

/// Parses `with P` or `with P, P and P`. In RoboSim, `,`, `and` or `, and` separates parameters.
void Parser::assertion_parameters(Assertion& assertion) {
    if (!accept_word("with")) return;
    assertion.parameters.push_back(assertion_parameter());
    bool closed = true;
    while (at_token(",") || at_word("and")) {
        accept_token(",");
        closed = accept_word("and");
        assertion.parameters.push_back(assertion_parameter());
        if (closed && !is_robosim()) return;
    }
    if (!closed && !is_robosim()) report(syntax::parameter_list, assertion.parameters.back().name.span);
}

AssertionParameter Parser::assertion_parameter() {
    AssertionParameter parameter;
    if (!cycle_parameter(parameter)) {
        parameter.kind = at_word("constant") ? ParameterKind::constant : ParameterKind::parameter;
        if (!accept_word("constant") && !accept_word("parameter"))
            fail_expecting(is_robosim() ? "`constant`, `parameter` or `cycleDef`" : "`constant` or `parameter`");
        parameter.name = plain_name("the name of a constant or parameter");
    }
    expect_word("of");
    parameter.context = qualified_name("the name of a component");
    if (accept_word("set")) {
        expect_token("to");
    } else if (accept_word("with")) {
        expect_word("value");
    } else if (!accept_word("assigned")) {
        fail_expecting("`set to`, `assigned` or `with value`");
    }
    parameter.value = parse_expression();
    return parameter;
}

}  // namespace robochart::frontend
