// SPDX-License-Identifier: Apache-2.0
// Parses statements and communications (RoboChart.xtext: Statement to CommunicationStmt, Communication).
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/syntax/parser.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

namespace {

StmtPtr make_statement(StmtKind kind, Span begin) {
    auto statement = std::make_unique<Stmt>();
    statement->kind = kind;
    statement->span = begin;
    return statement;
}

}  // namespace

/// Parses `S; S; …`.
StmtPtr Parser::parse_statement() {
    const Nesting nesting(*this);
    const Span begin = peek().span;
    StmtPtr first = timed_statement();
    if (!at_token(";") && !at_statement()) return first;
    StmtPtr sequence = make_statement(StmtKind::sequence, begin);
    sequence->body.push_back(std::move(first));
    while (at_token(";") || missing_semicolon()) {
        const Span separator = peek().span;
        if (accept_token(";") && at_body_end()) {
            if (diagnostics::Diagnostic* finding = report(syntax::trailing_semicolon, separator))
                finding->fixes.push_back({separator, "", "remove it"});
            quiet_until_ = 0;
            break;
        }
        sequence->body.push_back(timed_statement());
    }
    sequence->span = span_since(begin);
    return sequence;
}

/// True at a token that ends a list of statements.
bool Parser::at_body_end() const {
    return at_token("}") || at_token("end") || at_token("else") || at_token(")") || at_end() || at_member_word();
}

/// True directly after a statement if the next token begins another one, so that `;` is missing.
bool Parser::at_statement() const {
    constexpr std::array<std::string_view, 11> after_name = {"=",  "(", "!", "?",   ".",   "[",
                                                             "[|", ";", "}", "end", "else"};
    if (at_ < quiet_until_ || foreign_word(peek().text, ForeignPlace::if_end) != nullptr) return false;
    if (at_token("skip") || at_token("if") || at_token("wait") || at_token("send") || at_token("#")) return true;
    if (at_token("exec") || at_token("$")) return true;
    if (peek().kind != TokenKind::identifier) return false;
    const Token next = peek(1);
    const bool fits = std::ranges::any_of(after_name, [&](std::string_view w) { return next.is_word(w); });
    return fits || (next.kind == TokenKind::keyword && next.first_on_line);
}

bool Parser::missing_semicolon() {
    if (!at_statement()) return false;
    const Span place{source_, previous_token().span.end, previous_token().span.end};
    if (diagnostics::Diagnostic* finding =
            report(syntax::unexpected, missing_place(), {"`;` or the end of the action", describe_token()})) {
        finding->fixes.push_back({place, ";", "insert"});
        inserted_ = finding;
    }
    return true;
}

/// Parses `S <{ e }`.
StmtPtr Parser::timed_statement() {
    const Span begin = peek().span;
    StmtPtr inner = basic_statement();
    if (!accept_token("<{")) return inner;
    StmtPtr deadline = make_statement(StmtKind::deadline, begin);
    deadline->body.push_back(std::move(inner));
    deadline->value = parse_expression();
    expect_token("}");
    deadline->span = span_since(begin);
    return deadline;
}

StmtPtr Parser::basic_statement() {
    const Span begin = peek().span;
    if (at_foreign_statement()) (void)replace_foreign(ForeignPlace::statement);
    if (at_token("if")) return if_statement();
    if (at_token("wait")) return wait_statement();
    if (at_token("send")) return communication_statement();
    if (at_token("exec")) return exec_statement();
    if (at_token("$")) return register_statement();
    if (accept_token("skip")) return make_statement(StmtKind::skip, begin);
    if (accept_token("(")) {
        StmtPtr group = make_statement(StmtKind::parenthesised, begin);
        group->body.push_back(parse_statement());
        expect_token(")");
        group->span = span_since(begin);
        return group;
    }
    if (accept_token("#")) {
        StmtPtr reset = make_statement(StmtKind::clock_reset, begin);
        reset->name = plain_name("the name of a clock");
        reset->span = span_since(begin);
        return reset;
    }
    if (peek().kind == TokenKind::identifier) return name_statement();
    const Token before = previous_token();
    const bool begins =
        before.is_word("entry") || before.is_word("during") || before.is_word("exit") || before.is_word("action");
    if (at_token("{") && begins && (peek(1).kind == TokenKind::identifier || peek(1).is_word("skip")))
        return braced_statement();
    report_missing("a statement");
    return make_statement(StmtKind::error, begin);
}

StmtPtr Parser::if_statement() {
    StmtPtr result = make_statement(StmtKind::if_then_else, expect_token("if"));
    result->condition = parse_expression();
    if (at_token("{")) return braced_if(std::move(result));
    expect_token("then");
    result->body.push_back(parse_statement());
    if (accept_token("else")) result->body.push_back(parse_statement());
    if (!at_token("end")) (void)replace_foreign(ForeignPlace::if_end);
    if (!at_token("end"))
        if_without_end(result->span);
    else
        advance_token();
    result->span = span_since(result->span);
    return result;
}

/// Parses `wait(e)` or `wait([m,n])`.
StmtPtr Parser::wait_statement() {
    refuse_robochart(peek().span, "wait", "`exec` ends the cycle; to wait longer, compare a clock: `since(C) >= n`");
    StmtPtr result = make_statement(StmtKind::wait, expect_token("wait"));
    expect_token("(");
    ExprPtr duration = parse_expression();
    expect_token(")");
    if (duration->kind == ExprKind::range && duration->lower_closed && duration->upper_closed) {
        result->kind = StmtKind::wait_interval;
        result->value = std::move(duration->args[0]);
        result->upper = std::move(duration->args[1]);
    } else {
        result->value = std::move(duration);
    }
    result->span = span_since(result->span);
    return result;
}

StmtPtr Parser::communication_statement() {
    StmtPtr result = make_statement(StmtKind::communication, peek().span);
    result->send_keyword = accept_token("send");
    result->communication = parse_communication();
    result->span = span_since(result->span);
    check_plain_communication(*result);
    return result;
}

/// Returns the position after the bracket that closes the bracket at the current token, or no value if it is not
/// closed. The two brackets may differ, because ranges are written `(a, b]`.
std::optional<std::size_t> Parser::behind_brackets(std::size_t ahead) const {
    constexpr std::array<std::string_view, 8> opening = {"[", "(", "{", "[|", "(|", "<{", "Set(", "Seq("};
    constexpr std::array<std::string_view, 5> closing = {"]", ")", "}", "|]", "|)"};
    std::size_t open = 0;
    do {
        const Token& token = peek(ahead++);
        const auto here = [&](std::string_view word) { return token.is_word(word); };
        if (std::ranges::any_of(opening, here)) ++open;
        if (std::ranges::any_of(closing, here)) --open;
        const bool new_member = token.first_on_line && (token.is_word("transition") || token.is_word("state"));
        if (token.kind == TokenKind::end || new_member) return std::nullopt;
    } while (open > 0);
    return ahead;
}

/// True if the name before the token `behind_name` is followed by members and indices (possibly none) and then by `=`.
/// Any other use of `.` is a communication.
bool Parser::looks_like_assignment(std::size_t behind_name) const {
    std::size_t ahead = behind_name;
    while (peek(ahead).is_word("::")) ahead += 2;
    while (peek(ahead).is_word(".") || peek(ahead).is_word("[")) {
        if (peek(ahead).is_word(".")) {
            if (peek(ahead + 1).kind != TokenKind::identifier) return false;
            ahead += 2;
            continue;
        }
        const auto behind = behind_brackets(ahead);
        if (!behind) return false;
        ahead = *behind;
    }
    return peek(ahead).is_word("=") || (peek(ahead).is_word(":") && peek(ahead + 1).is_word("="));
}

/// Reports `:=` and reads it as `=`.
bool Parser::repair_assignment() {
    if (!at_token(":")) return false;
    const Span span = diagnostics::join_spans(peek().span, peek(1).span);
    if (diagnostics::Diagnostic* finding = report(syntax::colon_equal, span))
        finding->fixes.push_back({span, "=", "write"});
    advance_token();
    advance_token();
    quiet_until_ = 0;
    return true;
}

StmtPtr Parser::parse_assignment() {
    StmtPtr result = make_statement(StmtKind::assignment, peek().span);
    result->target = parse_steps(parse_atom(), true);
    if (!repair_assignment()) expect_token("=");
    result->value = parse_expression();
    result->span = span_since(result->span);
    return result;
}

/// Reports that `end` is missing, at the place where it was expected. A note points at the `if`.
void Parser::if_without_end(Span word) {
    const Span place = missing_place();
    diagnostics::Diagnostic* const finding = report_missing("`end`, which closes the `if`");
    if (finding == nullptr) return;
    finding->notes.push_back({word, "the `if` begins here"});
    finding->fixes.push_back({{source_, place.begin, place.begin}, " end ", "insert"});
    inserted_ = finding;
}

StmtPtr Parser::name_statement() {
    if (StmtPtr updating = updating_statement()) return updating;
    if (StmtPtr reset = clock_set_to_zero()) return reset;
    if (looks_like_assignment()) return parse_assignment();
    std::size_t ahead = 1;
    while (peek(ahead).is_word("::")) ahead += 2;
    if (!peek(ahead).is_word("(")) return communication_statement();
    StmtPtr call = make_statement(StmtKind::call, peek().span);
    call->name = qualified_name("the name of an operation");
    expect_token("(");
    expression_list(call->args, ")");
    call->span = span_since(call->span);
    return call;
}

// ---------------------------------------------------------------- communications

std::unique_ptr<Communication> Parser::parse_communication() {
    auto result = std::make_unique<Communication>();
    result->event = plain_name("the name of an event");
    if (accept_token("[|")) communication_predicate(*result);
    if (accept_token("?")) {
        result->kind = CommKind::input;
        result->variable = qualified_name("the variable that receives the value");
    } else if (at_token("!") || at_token(".")) {
        result->kind = at_token("!") ? CommKind::output : CommKind::sync;
        advance_token();
        result->value = communicated_value();
    }
    result->span = span_since(result->event.span);
    return result;
}

/// Parses `[| x = from |]`, `[| x = from | p |]`, `[| p |]` or `[| |]`.
void Parser::communication_predicate(Communication& communication) {
    if (peek().kind == TokenKind::identifier && peek(1).is_word("=")) {
        communication.from_variable = simple_name("a variable");
        expect_token("=");
        expect_token("from");
        if (accept_token("|]")) return;
        expect_token("|");
    }
    if (accept_token("|]")) return;
    communication.predicate = parse_expression();
    expect_token("|]");
}

/// Reads a CallExp. Larger expressions are reported with a fix, and read as intended.
ExprPtr Parser::communicated_value() {
    const std::size_t start = at_;
    const bool negative = at_token("-");
    ExprPtr value = negative ? nullptr : parse_call();
    if (!negative && !operator_here() && !at_token("[") && !at_token(".")) return value;
    at_ = start;
    const Span begin = peek().span;
    const std::size_t mistakes = mistakes_;
    value = parse_expression();
    if (mistakes_ != mistakes) return value;
    const std::string text(
        sources_.source_text(source_).substr(value->span.begin, value->span.end - value->span.begin));
    inserted_ = nullptr;
    ++failures_;
    out_.report(syntax::bare_value, span_since(begin)).fixes.push_back({value->span, "(" + text + ")", "write"});
    ++mistakes_;
    return value;
}

}  // namespace robochart::frontend
