// SPDX-License-Identifier: Apache-2.0
// Reports forms of other notations with the equivalent form of RoboChart, and interprets them as this form
// (foreign_words.hpp).
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/syntax/parser.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

namespace {

/// Returns the type of package core that the word denotes.
std::string_view type_named(std::string_view word) {
    const ForeignWord* const row = foreign_word(word, ForeignPlace::type);
    return row == nullptr ? word : row->instead;
}

}  // namespace

/// True for the name of a type of package core, and for the name that another notation has for it.
bool Parser::names_core_type(std::string_view word) {
    constexpr std::array<std::string_view, 5> core = {"int", "nat", "real", "boolean", "string"};
    return std::ranges::find(core, word) != core.end() || foreign_word(word, ForeignPlace::type) != nullptr;
}

bool Parser::replace_foreign(ForeignPlace place) {
    const Token token = peek();
    const ForeignWord* const row = token.escaped ? nullptr : foreign_word(token.text, place);
    if (row == nullptr || token.kind == TokenKind::string) return false;
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, token.span, {std::string(token.text), std::string(row->reason)});
    if (row->left_out) {
        if (finding != nullptr) finding->fixes.push_back({token.span, "", "leave it out"});
        advance_token();
    } else if (!row->instead.empty()) {
        if (finding != nullptr) finding->fixes.push_back({token.span, std::string(row->instead), "write"});
        tokens_.correct_token(at_, is_reserved(row->instead) ? TokenKind::keyword : TokenKind::symbol, row->instead);
    } else {
        throw SyntaxError{};
    }
    // A word of the grammar may be misplaced for other reasons, but if a name follows, the author probably means the
    // word of the other notation.
    const bool meant = place == ForeignPlace::clause && peek(1).kind == TokenKind::identifier;
    if (token.kind == TokenKind::identifier || meant) quiet_until_ = 0;
    return true;
}

void Parser::pass_superfluous(std::string_view reason) {
    const Token token = peek();
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, token.span, {std::string(token.text), std::string(reason)});
    if (finding != nullptr) {
        finding->fixes.push_back({token.span, "", "leave it out"});
        quiet_until_ = 0;
    }
    advance_token();
}

void Parser::pass_sign_behind_word() {
    const Token next = peek(1);
    const bool goes_on = (next.kind == TokenKind::identifier && !next.first_on_line) || next.is_word("skip") ||
                         next.is_word("if") || next.is_word("wait") || next.is_word("send") || next.is_word("#") ||
                         next.is_word("not") || next.is_word("since");
    const bool number = next.kind == TokenKind::integer || next.kind == TokenKind::real;
    if (!goes_on && !(number && at_token(":"))) return;

    if (at_token(":") || (at_token("=") && !peek(1).is_word("=")))
        pass_superfluous("a keyword is directly followed by its contents");
}

/// See parser.hpp. The intended word replaces the second word.
void Parser::replace_two_words(std::string_view instead, std::string_view reason) {
    const Span span = diagnostics::join_spans(peek().span, peek(1).span);
    const std::string text(sources_.source_text(source_).substr(span.begin, span.end - span.begin));
    if (diagnostics::Diagnostic* finding =
            report(syntax::other_notation, span, {shorten_token(text), std::string(reason)}))
        finding->fixes.push_back({span, std::string(instead), "write"});
    advance_token();
    tokens_.correct_token(at_, is_reserved(instead) ? TokenKind::keyword : TokenKind::symbol, instead);
    quiet_until_ = 0;
}

/// Reports `state machine S` and reads it as `stm S`.
bool Parser::state_machine_words() {
    if (!at_token("state") || !at_word("machine", 1)) return false;
    replace_two_words("stm", foreign_word("machine", ForeignPlace::declaration)->reason);
    return true;
}

/// Reports `int x` in the place of `var x : int` and skips it.
bool Parser::typed_like_c() {
    const Token first = peek();
    const Token second = peek(1);
    const bool declares = first.kind == TokenKind::identifier && second.kind == TokenKind::identifier &&
                          !second.first_on_line && names_core_type(first.text);
    if (!declares) return false;
    const Span span = diagnostics::join_spans(first.span, second.span);
    const std::string own = fmt::format("var {} : {}", second.text, type_named(first.text));
    diagnostics::Diagnostic* const finding = report(syntax::other_notation, span,
                                                    {fmt::format("{} {}", first.text, second.text),
                                                     fmt::format("write the declaration of a variable as `{}`", own)});
    if (finding != nullptr) finding->fixes.push_back({span, own, "write"});
    lost_names_.emplace_back(second.text);
    advance_token();
    advance_token();
    quiet_until_ = at_ + 1;
    return true;
}

/// Reports `initial state A` or `final state B` after its first word. Returns true for `initial`.
bool Parser::pseudo_state(DeclKind kind) {
    const bool meant = at_token("state") && peek(1).kind == TokenKind::identifier && !peek(1).first_on_line;
    if (!meant || (kind != DeclKind::initial && kind != DeclKind::final)) return false;
    const Span word = previous_token().span;
    const Span both = diagnostics::join_spans(word, peek().span);
    if (kind == DeclKind::final) {
        diagnostics::Diagnostic* const finding =
            report(syntax::other_notation, both, {"final state", "`final` and a name declare a final state"});
        if (finding != nullptr) finding->fixes.push_back({both, "final", "write"});
        advance_token();
    } else {
        report(
            syntax::other_notation, both,
            {"initial state", "`initial i` is a separate junction, from which a transition leads to the first state"});
    }
    quiet_until_ = 0;
    return kind == DeclKind::initial;
}

/// Reports `and`, `mod`, `<>` or `/=` between two expressions, and reads RoboChart's operator. In assertion files,
/// `and` has a different meaning.
bool Parser::foreign_operator() {
    if (is_assertions_) return false;
    const Token next = peek(1);
    const bool adjacent = next.span.begin == peek().span.end;
    if (adjacent && ((at_token("<") && next.is_word(">")) || (at_token("/") && next.is_word("=")))) {
        replace_two_words("!=", "`!=` tests whether two values differ");
        return true;
    }
    const bool called = adjacent && next.is_word("(");
    if (peek().kind != TokenKind::identifier || peek().first_on_line || called) return false;
    return replace_foreign(ForeignPlace::infix);
}

/// Reports a guard `[ x > 0 ]` and reads it as a condition.
void Parser::bracketed_guard(Transition& transition) {
    const Span begin = peek().span;
    const auto behind = behind_brackets(0);
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, begin, {"[", std::string(foreign_word("guard", ForeignPlace::clause)->reason)});
    if (finding != nullptr && behind) {
        const Span end = peek(*behind - 1).span;
        std::string inner(sources_.source_text(source_).substr(begin.end, end.begin - begin.end));
        inner.erase(0, std::min(inner.size(), inner.find_first_not_of(" \t")));
        inner.erase(inner.find_last_not_of(" \t") + 1);
        finding->fixes.push_back({diagnostics::join_spans(begin, end), "condition " + inner, "write"});
    }
    quiet_until_ = 0;
    expect_token("[");
    transition.condition = parse_expression();
    expect_token("]");
}

/// Reports `e` or `e [c] / a` without `trigger`, as in a UML transition, and reads it as clauses. Returns the position
/// of the last clause in the order of clauses, or 0 for other texts.
int Parser::forgotten_trigger(Transition& transition) {
    const Token next = peek(1);
    const bool clause_follows = next.is_word("[") || next.is_word("/") || next.is_word("?") || next.is_word("!") ||
                                next.is_word(".") || next.is_word("condition") || next.is_word("action") ||
                                next.is_word("#") || next.is_word("<{") || next.is_word("}");
    if (peek().kind != TokenKind::identifier || peek().escaped || transition.trigger || !clause_follows) return 0;
    if (is_robosim()) return 0;  // there are no triggers
    const Span begin = peek().span;
    const std::size_t failures = failures_;
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, begin,
               {std::string(peek().text), std::string(foreign_word("on", ForeignPlace::clause)->reason)});
    quiet_until_ = 0;
    const std::string_view text = sources_.source_text(source_);
    const auto written = [&](Span from) {
        const Span span = span_since(from);
        return std::string(text.substr(span.begin, span.end - span.begin));
    };
    transition.trigger = parse_communication();
    std::string own = "trigger " + written(begin);
    int clause = 1;
    if (accept_token("[")) {
        const Span condition = peek().span;
        transition.condition = parse_expression();
        own += " condition " + written(condition);
        expect_token("]");
        clause = 4;
    }
    Span whole = span_since(begin);
    if (accept_token("/")) {
        own += " action";
        whole = span_since(begin);
        transition.action = parse_statement();
        clause = 5;
    }
    if (finding != nullptr && failures_ == failures + 1) finding->fixes.push_back({whole, own, "write"});
    return clause;
}

/// Reports `reset(C)` as a clause and reads it as `reset C`.
bool Parser::called_reset(Transition& transition) {
    const bool called =
        at_word("reset") && peek(1).is_word("(") && peek(2).kind == TokenKind::identifier && peek(3).is_word(")");
    if (!called) return false;
    const Token clock = peek(2);
    const Span span = diagnostics::join_spans(peek().span, peek(3).span);
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, span,
               {fmt::format("reset({})", clock.text), fmt::format("write `#{}` to reset a clock", clock.text)});
    if (finding != nullptr) finding->fixes.push_back({span, fmt::format("#{}", clock.text), "write"});
    quiet_until_ = 0;
    advance_token();
    advance_token();
    transition.resets.push_back({plain_name("the name of a clock"), nullptr});
    advance_token();
    return true;
}

/// Reports `A -> B` and reads it as the ends of a transition.
void Parser::ends_by_arrow(Transition& transition) {
    const Span span = diagnostics::join_spans(peek().span, peek(1).span);
    const std::string source(peek().text);
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, span, {source + " ->", "a transition leads `from` a node `to` a node"});
    if (finding != nullptr) finding->fixes.push_back({span, fmt::format("from {} to", source), "write"});
    quiet_until_ = 0;
    transition.from = plain_name("the transition's source");
    advance_token();
    transition.to = plain_name("the transition's target");
}

bool Parser::at_foreign_statement() const {
    const Token next = peek(1);
    const bool followed = !next.first_on_line && (next.kind == TokenKind::identifier || next.is_word("not") ||
                                                  next.is_word("true") || next.kind == TokenKind::integer);
    return peek().kind == TokenKind::identifier && followed &&
           foreign_word(peek().text, ForeignPlace::statement) != nullptr;
}

/// Reports `x++` or `x += e` and reads it as an assignment. Returns null if the statement has neither form.
StmtPtr Parser::updating_statement() {
    const Token op = peek(1);
    const bool counts =
        (op.is_word("+") || op.is_word("-")) && peek(2).is_word(op.text) && peek(2).span.begin == op.span.end;
    const bool updates = (op.is_word("+") || op.is_word("-") || op.is_word("*") || op.is_word("/")) &&
                         peek(2).is_word("=") && peek(2).span.begin == op.span.end;
    if (!counts && !updates) return nullptr;
    const Token name = peek();
    auto statement = std::make_unique<Stmt>();
    statement->kind = StmtKind::error;
    statement->span = diagnostics::join_spans(name.span, peek(2).span);
    const std::string own = fmt::format("{0} = {0} {1}", name.text, op.text);
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, statement->span,
               {fmt::format("{} {}{}", name.text, op.text, peek(2).text),
                fmt::format("an assignment is written in full: `{} {}`", own, counts ? "1" : "...")});
    if (finding != nullptr) finding->fixes.push_back({statement->span, counts ? own + " 1" : own, "write"});
    for (int i = 0; i < 3; ++i) advance_token();
    quiet_until_ = 0;
    if (updates) (void)parse_expression();
    return statement;
}

/// True if the text declares a clock, but no variable, of this name.
bool Parser::names_clock(std::string_view word) const {
    bool clock = false;
    for (std::size_t i = 0; i + 2 < tokens_.size(); ++i) {
        if (tokens_.kind(i + 1) != TokenKind::identifier || tokens_.token_at(i + 1).text != word) continue;
        clock = clock || tokens_.token_at(i).is_word("clock");
        if (tokens_.token_at(i + 2).is_word(":") && !tokens_.token_at(i + 3).is_word("=")) return false;
    }
    return clock;
}

/// Reports `C := 0` and reads it as a reset of the clock. Returns null if the statement does not have this form.
StmtPtr Parser::clock_set_to_zero() {
    const Token name = peek();
    const bool zero =
        peek(1).is_word(":") && peek(2).is_word("=") && peek(3).kind == TokenKind::integer && peek(3).text == "0";
    if (!zero || !names_clock(name.text)) return nullptr;
    auto statement = std::make_unique<Stmt>();
    statement->kind = StmtKind::clock_reset;
    statement->span = diagnostics::join_spans(name.span, peek(3).span);
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, statement->span,
               {fmt::format("{} := 0", name.text), fmt::format("write `#{}` to reset a clock", name.text)});
    if (finding != nullptr) finding->fixes.push_back({statement->span, fmt::format("#{}", name.text), "write"});
    quiet_until_ = 0;
    statement->name = simple_name("the name of a clock");
    for (int i = 0; i < 3; ++i) advance_token();
    return statement;
}

/// Reports `if c { S } else { T }` after its condition, and reads it as a conditional statement.
StmtPtr Parser::braced_if(StmtPtr begun) {
    report(syntax::other_notation, peek().span, {"{", "an `if` has the form `if c then S else T end`, without braces"});
    quiet_until_ = 0;
    expect_token("{");
    begun->body.push_back(parse_statement());
    expect_token("}");
    if (accept_token("else")) {
        expect_token("{");
        begun->body.push_back(parse_statement());
        expect_token("}");
    }
    begun->span = span_since(begun->span);
    return begun;
}

/// Reports `{ S }` in the place of a statement and reads the statement S.
StmtPtr Parser::braced_statement() {
    const Span begin = peek().span;
    report(syntax::other_notation, begin, {"{", "statements have no braces: `entry a(); b()`"});
    quiet_until_ = 0;
    expect_token("{");
    auto group = std::make_unique<Stmt>();
    group->kind = StmtKind::error;
    if (!at_token("}")) group->body.push_back(parse_statement());
    expect_token("}");
    group->span = span_since(begin);
    return group;
}

/// Reports `event e()`, `event e(int)` or `event e(x : int)` after the name, and reads the type.
void Parser::bracketed_event(Event& event) {
    const std::optional<std::size_t> behind = behind_brackets(0);
    constexpr std::size_t most_words = 12;
    if (!behind || *behind > most_words || !peek(*behind - 1).is_word(")")) return;
    for (std::size_t i = 0; i < *behind; ++i)
        if (peek(i).first_on_line) return;
    const bool named = peek(1).kind == TokenKind::identifier && peek(2).is_word(":");
    const std::size_t first = named ? 3 : 1;
    const Span span = diagnostics::join_spans(peek().span, peek(*behind - 1).span);
    const std::string_view text = sources_.source_text(source_);
    std::string own;
    if (*behind > first + 1)
        own = " : " +
              std::string(text.substr(peek(first).span.begin, peek(*behind - 2).span.end - peek(first).span.begin));
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, span,
               {shorten_token(text.substr(span.begin, span.end - span.begin)),
                "an event is declared `event e`, and an event with a value `event e : int`"});
    if (finding != nullptr) finding->fixes.push_back({span, own, "write"});
    quiet_until_ = 0;
    for (std::size_t i = 0; i < first; ++i) advance_token();
    if (!at_token(")")) event.type_expr = parse_type();
    expect_token(")");
}

/// Reports `clock C = 0` or `clock C : real` after the name, and skips the value or type.
void Parser::clock_with_value() {
    const bool typed = at_token(":") && peek(1).kind == TokenKind::identifier;
    const bool set = at_token("=") && peek(1).kind == TokenKind::integer;
    if (!typed && !set) return;
    const Span span = diagnostics::join_spans(previous_token().span, peek(1).span);
    const std::string clock(previous_token().text);
    const std::string_view text = sources_.source_text(source_);
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, span,
               {shorten_token(text.substr(span.begin, span.end - span.begin)),
                "a clock is declared only by its name, and counts time units from 0"});
    if (finding != nullptr) finding->fixes.push_back({span, clock, "write"});
    quiet_until_ = 0;
    advance_token();
    advance_token();
    clock_with_value();
}

/// Reports `async`, `_async` or `[async]` after a connection, and reads it as `(_async)`.
bool Parser::bare_async() {
    const auto async = [&](std::size_t ahead) { return at_word("async", ahead) || at_word("_async", ahead); };
    const bool bracketed = at_token("[") && async(1) && peek(2).is_word("]");
    if (!bracketed && !async(0)) return false;
    const Span span = bracketed ? diagnostics::join_spans(peek().span, peek(2).span) : peek().span;
    const std::string_view text = sources_.source_text(source_);
    diagnostics::Diagnostic* const finding = report(syntax::other_notation, span,
                                                    {std::string(text.substr(span.begin, span.end - span.begin)),
                                                     "an asynchronous connection ends with `(_async)`"});
    if (finding != nullptr) finding->fixes.push_back({span, "(_async)", "write"});
    quiet_until_ = 0;
    for (int i = 0; i < (bracketed ? 3 : 1); ++i) advance_token();
    return true;
}

/// Reports `50%`, if no operand for a remainder follows, and reads it as a fraction.
bool Parser::parse_percentage(Expr& number) {
    const bool literal = number.kind == ExprKind::integer && number.text.size() <= 3;
    const bool ends = peek(1).is_word("}") || peek(1).is_word(")") || peek(1).is_word(";") ||
                      peek(1).is_word("condition") || peek(1).is_word("action") || peek(1).kind == TokenKind::end ||
                      peek(1).first_on_line;
    if (!at_token("%") || !literal || !ends) return false;
    const std::string digits = std::string(3 - number.text.size(), '0') + number.text;
    const std::string own = digits.substr(0, 1) + "." + digits.substr(1);
    const Span span = diagnostics::join_spans(number.span, peek().span);
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, span, {number.text + "%", "write a share as a number from 0 to 1"});
    if (finding != nullptr) finding->fixes.push_back({span, own, "write"});
    quiet_until_ = 0;
    number.kind = ExprKind::real;
    number.text = own;
    advance_token();
    return true;
}

/// Reports `state S` without braces, after the name. It is read as a state without actions.
bool Parser::body_left_out() {
    const bool ends = at_token(";") && peek(1).first_on_line;
    const bool next_member = ((at_member_word() || at_token("}")) && peek().first_on_line) || ends;
    if (!next_member || at_token("entry") || at_token("during") || at_token("exit")) return false;
    const Span place = missing_place();
    diagnostics::Diagnostic* const finding = report(syntax::unexpected, place, {"`{`", describe_token()});
    const std::uint32_t end = previous_token().span.end;
    if (finding != nullptr)
        finding->fixes.push_back({{source_, end, at_token(";") ? peek().span.end : end}, " { }", "write"});
    quiet_until_ = 0;
    if (at_token(";")) advance_token();
    return true;
}

/// Reports a query of PRISM such as `P=? [ F p ]` or `Rmax<=3 [ ... ]` as a whole, and skips the rest of the claim.
void Parser::prism_query() {
    constexpr std::array<std::string_view, 6> words = {"P", "Pmin", "Pmax", "R", "Rmin", "Rmax"};
    const Token word = peek();
    if (word.kind != TokenKind::identifier || std::ranges::find(words, word.text) == words.end()) return;
    std::size_t next = 1;
    if (word.text.starts_with("R") && peek(next).is_word("{") && peek(next + 2).is_word("}")) next += 3;
    const bool asks = peek(next).is_word("=") && peek(next + 1).is_word("?");
    constexpr std::array<std::string_view, 4> bounds = {"<=", ">=", "<", ">"};
    const bool compares =
        std::ranges::any_of(bounds, [&](std::string_view relation) { return peek(next).is_word(relation); }) &&
        peek(next + 2).is_word("[");
    if (!asks && !compares) return;
    const std::size_t bracket = next + 2;
    const std::size_t behind = peek(bracket).is_word("[") ? behind_brackets(bracket).value_or(0) : 0;
    const bool probability = word.text.starts_with("P");
    const Span span = diagnostics::join_spans(word.span, peek(bracket - 1).span);
    const std::string_view text = sources_.source_text(source_);
    diagnostics::Diagnostic* const finding = report(
        syntax::other_notation, span,
        {shorten_token(text.substr(span.begin, span.end - span.begin)),
         probability ? "a query for a probability is `Prob=? of [Finally ...]`, and a bound is `Prob>=0.9 of [...]`"
                     : "a query for a reward is `Reward {r} =? of [Reachable ...]`"});
    if (finding != nullptr && behind > 0 && probability) {
        const std::string bound = word.text.size() > 1 ? " " + std::string(word.text.substr(1)) : "";
        const std::string operation(text.substr(peek(1).span.begin, peek(bracket - 1).span.end - peek(1).span.begin));
        finding->fixes.push_back({diagnostics::join_spans(word.span, peek(behind - 1).span),
                                  fmt::format("Prob{}{} of [{}]", bound, operation, prism_path(bracket, behind - 1)),
                                  "write"});
    }
    throw SyntaxError{};
}

/// Returns the text between two tokens, with PRISM's path operators replaced by RoboChart's.
std::string Parser::prism_path(std::size_t begin, std::size_t end) const {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 8> words = {{{"F", "Finally"},
                                                                                     {"G", "Globally"},
                                                                                     {"X", "Next"},
                                                                                     {"U", "Until"},
                                                                                     {"W", "Weak Until"},
                                                                                     {"&", "/\\"},
                                                                                     {"|", "\\/"},
                                                                                     {"!", "not "}}};
    const std::string_view text = sources_.source_text(source_);
    std::string result;
    for (std::size_t i = begin + 1; i < end; ++i) {
        const Token token = peek(i);
        result += text.substr(peek(i - 1).span.end, token.span.begin - peek(i - 1).span.end);
        const auto* const word =
            std::ranges::find_if(words, [&](const auto& entry) { return entry.first == token.text; });
        result += word != words.end() ? word->second : text.substr(token.span.begin, token.span.end - token.span.begin);
    }
    return result.append(text.substr(peek(end - 1).span.end, peek(end).span.begin - peek(end - 1).span.end));
}

}  // namespace robochart::frontend
