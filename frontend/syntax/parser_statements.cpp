// SPDX-License-Identifier: Apache-2.0
// Statements and communications (RoboChart.xtext: Statement to CommunicationStmt, Communication).
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

/// `S; S; …`
StmtPtr Parser::statement() {
    const Nesting nesting(*this);
    const Span begin = peek().span;
    StmtPtr first = timed_statement();
    if (!at(";") && !at_statement()) return first;
    StmtPtr sequence = make_statement(StmtKind::sequence, begin);
    sequence->body.push_back(std::move(first));
    while (at(";") || missing_semicolon()) {
        const Span separator = peek().span;
        if (accept(";") && at_body_end()) {
            if (diagnostics::Diagnostic* finding = report(syntax::trailing_semicolon, separator))
                finding->fixes.push_back({separator, "", "remove it"});
            quiet_until_ = 0;
            break;
        }
        sequence->body.push_back(timed_statement());
    }
    sequence->span = since(begin);
    return sequence;
}

/// True at a token that ends a list of statements.
bool Parser::at_body_end() const {
    return at("}") || at("end") || at("else") || at(")") || at_end() || at_member_word();
}

/// True directly after a statement if the next token begins another one, so that `;` is missing.
bool Parser::at_statement() const {
    constexpr std::array<std::string_view, 11> after_name = {"=",  "(", "!", "?",   ".",   "[",
                                                             "[|", ";", "}", "end", "else"};
    if (at_ < quiet_until_ || foreign_word(peek().text, ForeignPlace::if_end) != nullptr) return false;
    if (at("skip") || at("if") || at("wait") || at("send") || at("#")) return true;
    if (peek().kind != TokenKind::identifier) return false;
    const Token next = peek(1);
    const bool fits = std::ranges::any_of(after_name, [&](std::string_view w) { return next.is(w); });
    return fits || (next.kind == TokenKind::keyword && next.first_on_line);
}

bool Parser::missing_semicolon() {
    if (!at_statement()) return false;
    const Span place{source_, previous().span.end, previous().span.end};
    if (diagnostics::Diagnostic* finding =
            report(syntax::unexpected, missing_place(), {"`;` or the end of the action", found()})) {
        finding->fixes.push_back({place, ";", "insert"});
        inserted_ = finding;
    }
    return true;
}

/// `S <{ e }`
StmtPtr Parser::timed_statement() {
    const Span begin = peek().span;
    StmtPtr inner = basic_statement();
    if (!accept("<{")) return inner;
    StmtPtr deadline = make_statement(StmtKind::deadline, begin);
    deadline->body.push_back(std::move(inner));
    deadline->value = expression();
    expect("}");
    deadline->span = since(begin);
    return deadline;
}

StmtPtr Parser::basic_statement() {
    const Span begin = peek().span;
    if (at_foreign_statement()) (void)replace_foreign(ForeignPlace::statement);
    if (at("if")) return if_statement();
    if (at("wait")) return wait_statement();
    if (at("send")) return communication_statement();
    if (accept("skip")) return make_statement(StmtKind::skip, begin);
    if (accept("(")) {
        StmtPtr group = make_statement(StmtKind::parenthesised, begin);
        group->body.push_back(statement());
        expect(")");
        group->span = since(begin);
        return group;
    }
    if (accept("#")) {
        StmtPtr reset = make_statement(StmtKind::clock_reset, begin);
        reset->name = plain_name("the name of a clock");
        reset->span = since(begin);
        return reset;
    }
    if (peek().kind == TokenKind::identifier) return name_statement();
    const Token before = previous();
    const bool begins = before.is("entry") || before.is("during") || before.is("exit") || before.is("action");
    if (at("{") && begins && (peek(1).kind == TokenKind::identifier || peek(1).is("skip"))) return braced_statement();
    missing("a statement");
    return make_statement(StmtKind::error, begin);
}

StmtPtr Parser::if_statement() {
    StmtPtr result = make_statement(StmtKind::if_then_else, expect("if"));
    result->condition = expression();
    if (at("{")) return braced_if(std::move(result));
    expect("then");
    result->body.push_back(statement());
    if (accept("else")) result->body.push_back(statement());
    if (!at("end")) (void)replace_foreign(ForeignPlace::if_end);
    if (!at("end"))
        if_without_end(result->span);
    else
        advance();
    result->span = since(result->span);
    return result;
}

/// `wait(e)`; `wait([m,n])` is a separate form.
StmtPtr Parser::wait_statement() {
    StmtPtr result = make_statement(StmtKind::wait, expect("wait"));
    expect("(");
    ExprPtr duration = expression();
    expect(")");
    if (duration->kind == ExprKind::range && duration->lower_closed && duration->upper_closed) {
        result->kind = StmtKind::wait_interval;
        result->value = std::move(duration->args[0]);
        result->upper = std::move(duration->args[1]);
    } else {
        result->value = std::move(duration);
    }
    result->span = since(result->span);
    return result;
}

StmtPtr Parser::communication_statement() {
    StmtPtr result = make_statement(StmtKind::communication, peek().span);
    result->send_keyword = accept("send");
    result->communication = communication();
    result->span = since(result->span);
    return result;
}

/// The position after the bracket that closes the one here; no value if it is not closed. The brackets may differ,
/// because ranges are written `(a, b]`.
std::optional<std::size_t> Parser::behind_brackets(std::size_t ahead) const {
    constexpr std::array<std::string_view, 8> opening = {"[", "(", "{", "[|", "(|", "<{", "Set(", "Seq("};
    constexpr std::array<std::string_view, 5> closing = {"]", ")", "}", "|]", "|)"};
    std::size_t open = 0;
    do {
        const Token& token = peek(ahead++);
        const auto here = [&](std::string_view word) { return token.is(word); };
        if (std::ranges::any_of(opening, here)) ++open;
        if (std::ranges::any_of(closing, here)) --open;
        const bool new_member = token.first_on_line && (token.is("transition") || token.is("state"));
        if (token.kind == TokenKind::end || new_member) return std::nullopt;
    } while (open > 0);
    return ahead;
}

/// True if the name here is followed by member and index steps and `=`. Any other use of `.` is a communication.
bool Parser::looks_like_assignment() const {
    std::size_t ahead = 1;
    while (peek(ahead).is("::")) ahead += 2;
    while (peek(ahead).is(".") || peek(ahead).is("[")) {
        if (peek(ahead).is(".")) {
            if (peek(ahead + 1).kind != TokenKind::identifier) return false;
            ahead += 2;
            continue;
        }
        const auto behind = behind_brackets(ahead);
        if (!behind) return false;
        ahead = *behind;
    }
    return peek(ahead).is("=") || (peek(ahead).is(":") && peek(ahead + 1).is("="));
}

/// `:=` is read as `=`.
bool Parser::repair_assignment() {
    if (!at(":")) return false;
    const Span span = diagnostics::join(peek().span, peek(1).span);
    if (diagnostics::Diagnostic* finding = report(syntax::colon_equal, span))
        finding->fixes.push_back({span, "=", "write"});
    advance();
    advance();
    quiet_until_ = 0;
    return true;
}

StmtPtr Parser::assignment() {
    StmtPtr result = make_statement(StmtKind::assignment, peek().span);
    result->target = steps(atom(), true);
    if (!repair_assignment()) expect("=");
    result->value = expression();
    result->span = since(result->span);
    return result;
}

/// The error is at the place where `end` was expected; a note points at the `if`.
void Parser::if_without_end(Span word) {
    const Span place = missing_place();
    diagnostics::Diagnostic* const finding = missing("`end`, which closes the `if`");
    if (finding == nullptr) return;
    finding->notes.push_back({word, "the `if` begins here"});
    finding->fixes.push_back({{source_, place.begin, place.begin}, " end ", "insert"});
    inserted_ = finding;
}

StmtPtr Parser::name_statement() {
    if (StmtPtr updating = updating_statement()) return updating;
    if (StmtPtr reset = clock_set_to_zero()) return reset;
    if (looks_like_assignment()) return assignment();
    std::size_t ahead = 1;
    while (peek(ahead).is("::")) ahead += 2;
    if (!peek(ahead).is("(")) return communication_statement();
    StmtPtr call = make_statement(StmtKind::call, peek().span);
    call->name = qualified_name("the name of an operation");
    expect("(");
    expression_list(call->args, ")");
    call->span = since(call->span);
    return call;
}

// ---------------------------------------------------------------- communications

std::unique_ptr<Communication> Parser::communication() {
    auto result = std::make_unique<Communication>();
    result->event = plain_name("the name of an event");
    if (accept("[|")) communication_predicate(*result);
    if (accept("?")) {
        result->kind = CommKind::input;
        result->variable = qualified_name("the variable that receives the value");
    } else if (at("!") || at(".")) {
        result->kind = at("!") ? CommKind::output : CommKind::sync;
        advance();
        result->value = communicated_value();
    }
    result->span = since(result->event.span);
    return result;
}

/// `[| x = from |]`, `[| x = from | p |]`, `[| p |]`, `[| |]`
void Parser::communication_predicate(Communication& communication) {
    if (peek().kind == TokenKind::identifier && peek(1).is("=")) {
        communication.from_variable = simple_name("a variable");
        expect("=");
        expect("from");
        if (accept("|]")) return;
        expect("|");
    }
    if (accept("|]")) return;
    communication.predicate = expression();
    expect("|]");
}

/// A CallExp. Larger expressions are reported with a fix, and read as intended.
ExprPtr Parser::communicated_value() {
    const std::size_t start = at_;
    const bool negative = at("-");
    ExprPtr value = negative ? nullptr : call();
    if (!negative && !operator_here() && !at("[") && !at(".")) return value;
    at_ = start;
    const Span begin = peek().span;
    const std::size_t mistakes = mistakes_;
    value = expression();
    if (mistakes_ != mistakes) return value;
    const std::string text(sources_.text(source_).substr(value->span.begin, value->span.end - value->span.begin));
    inserted_ = nullptr;
    ++failures_;
    out_.report(syntax::bare_value, since(begin)).fixes.push_back({value->span, "(" + text + ")", "write"});
    ++mistakes_;
    return value;
}

}  // namespace robochart::frontend
