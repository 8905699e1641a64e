// What people write who know another notation: reported with RoboChart's own form, and read on as that
// (foreign_words.hpp).
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/syntax/parser.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

namespace {

/// The type of core that the word stands for.
std::string_view type_named(std::string_view word) {
    const ForeignWord* const row = foreign_word(word, ForeignPlace::type);
    return row == nullptr ? word : row->instead;
}

}  // namespace

/// Of core, or of another notation for one of core.
bool Parser::names_core_type(std::string_view word) {
    constexpr std::array<std::string_view, 5> core = {"int", "nat", "real", "boolean", "string"};
    return std::find(core.begin(), core.end(), word) != core.end() || foreign_word(word, ForeignPlace::type) != nullptr;
}

bool Parser::replace_foreign(ForeignPlace place) {
    const Token token = peek();
    const ForeignWord* const row = token.escaped ? nullptr : foreign_word(token.text, place);
    if (row == nullptr || token.kind == TokenKind::string) return false;
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, token.span, {std::string(token.text), std::string(row->reason)});
    if (row->left_out) {
        if (finding != nullptr) finding->fixes.push_back({token.span, "", "leave it out"});
        advance();
    } else if (!row->instead.empty()) {
        if (finding != nullptr) finding->fixes.push_back({token.span, std::string(row->instead), "write"});
        tokens_.correct(at_, is_reserved(row->instead) ? TokenKind::keyword : TokenKind::symbol, row->instead);
    } else {
        throw SyntaxError{};
    }
    // A word of the grammar may be in a wrong place for other reasons, but hardly in front of a name.
    const bool meant = place == ForeignPlace::clause && peek(1).kind == TokenKind::identifier;
    if (token.kind == TokenKind::identifier || meant) quiet_until_ = 0;
    return true;
}

/// The second of them becomes what is meant.
void Parser::replace_two_words(std::string_view instead, std::string_view reason) {
    const Span span = diagnostics::join(peek().span, peek(1).span);
    const std::string text(sources_.text(source_).substr(span.begin, span.end - span.begin));
    if (diagnostics::Diagnostic* finding = report(syntax::other_notation, span, {shorten(text), std::string(reason)}))
        finding->fixes.push_back({span, std::string(instead), "write"});
    advance();
    tokens_.correct(at_, is_reserved(instead) ? TokenKind::keyword : TokenKind::symbol, instead);
    quiet_until_ = 0;
}

/// `state machine S`
bool Parser::state_machine_words() {
    if (!at("state") || !at_word("machine", 1)) return false;
    replace_two_words("stm", foreign_word("machine", ForeignPlace::declaration)->reason);
    return true;
}

/// `int x`
bool Parser::typed_like_c() {
    const Token first = peek();
    const Token second = peek(1);
    const bool declares = first.kind == TokenKind::identifier && second.kind == TokenKind::identifier &&
                          !second.first_on_line && names_core_type(first.text);
    if (!declares) return false;
    const Span span = diagnostics::join(first.span, second.span);
    const std::string own = fmt::format("var {} : {}", second.text, type_named(first.text));
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, span,
               {fmt::format("{} {}", first.text, second.text), fmt::format("a variable is declared `{}`", own)});
    if (finding != nullptr) finding->fixes.push_back({span, own, "write"});
    lost_names_.emplace_back(second.text);
    advance();
    advance();
    quiet_until_ = at_ + 1;
    return true;
}

/// `initial state A` and `final state B`, behind their first word.
bool Parser::pseudo_state(DeclKind kind) {
    const bool meant = at("state") && peek(1).kind == TokenKind::identifier && !peek(1).first_on_line;
    if (!meant || (kind != DeclKind::initial && kind != DeclKind::final)) return false;
    const Span word = previous().span;
    const Span both = diagnostics::join(word, peek().span);
    if (kind == DeclKind::final) {
        diagnostics::Diagnostic* const finding =
            report(syntax::other_notation, both, {"final state", "a final state is declared by `final` and its name"});
        if (finding != nullptr) finding->fixes.push_back({both, "final", "write"});
        advance();
    } else {
        report(syntax::other_notation, both,
               {"initial state",
                "`initial i` is a junction of its own, from which a transition leads to the first state"});
    }
    quiet_until_ = 0;
    return kind == DeclKind::initial;
}

/// `and`, `mod`, `<>`, `/=` between two expressions; in assertion files `and` has a meaning.
bool Parser::foreign_operator() {
    if (is_assertions_) return false;
    const Token next = peek(1);
    const bool adjacent = next.span.begin == peek().span.end;
    if (adjacent && ((at("<") && next.is(">")) || (at("/") && next.is("=")))) {
        replace_two_words("!=", "values that differ are compared with `!=`");
        return true;
    }
    const bool called = adjacent && next.is("(");
    if (peek().kind != TokenKind::identifier || peek().first_on_line || called) return false;
    return replace_foreign(ForeignPlace::infix);
}

/// `[ x > 0 ]`
void Parser::bracketed_guard(Transition& transition) {
    const Span begin = peek().span;
    const auto behind = behind_brackets(0);
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, begin, {"[", std::string(foreign_word("guard", ForeignPlace::clause)->reason)});
    if (finding != nullptr && behind) {
        const Span end = peek(*behind - 1).span;
        std::string inner(sources_.text(source_).substr(begin.end, end.begin - begin.end));
        inner.erase(0, std::min(inner.size(), inner.find_first_not_of(" \t")));
        inner.erase(inner.find_last_not_of(" \t") + 1);
        finding->fixes.push_back({diagnostics::join(begin, end), "condition " + inner, "write"});
    }
    quiet_until_ = 0;
    expect("[");
    transition.condition = expression();
    expect("]");
}

/// `reset(C)` as a clause.
bool Parser::called_reset(Transition& transition) {
    const bool called = at_word("reset") && peek(1).is("(") && peek(2).kind == TokenKind::identifier && peek(3).is(")");
    if (!called) return false;
    const Token clock = peek(2);
    const Span span = diagnostics::join(peek().span, peek(3).span);
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, span,
               {fmt::format("reset({})", clock.text), fmt::format("a clock is reset by `#{}`", clock.text)});
    if (finding != nullptr) finding->fixes.push_back({span, fmt::format("#{}", clock.text), "write"});
    quiet_until_ = 0;
    advance();
    advance();
    transition.resets.push_back({plain_name("the name of a clock"), nullptr});
    advance();
    return true;
}

/// `A -> B`
void Parser::ends_by_arrow(Transition& transition) {
    const Span span = diagnostics::join(peek().span, peek(1).span);
    const std::string source(peek().text);
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, span, {source + " ->", "a transition leads `from` a node `to` a node"});
    if (finding != nullptr) finding->fixes.push_back({span, fmt::format("from {} to", source), "write"});
    quiet_until_ = 0;
    transition.from = plain_name("the transition's source");
    advance();
    transition.to = plain_name("the transition's target");
}

bool Parser::at_foreign_statement() const {
    const Token next = peek(1);
    const bool followed = !next.first_on_line && (next.kind == TokenKind::identifier || next.is("not") ||
                                                  next.is("true") || next.kind == TokenKind::integer);
    return peek().kind == TokenKind::identifier && followed &&
           foreign_word(peek().text, ForeignPlace::statement) != nullptr;
}

/// `x++` and `x += e`; null where it is neither.
StmtPtr Parser::updating_statement() {
    const Token op = peek(1);
    const bool counts = (op.is("+") || op.is("-")) && peek(2).is(op.text) && peek(2).span.begin == op.span.end;
    const bool updates =
        (op.is("+") || op.is("-") || op.is("*") || op.is("/")) && peek(2).is("=") && peek(2).span.begin == op.span.end;
    if (!counts && !updates) return nullptr;
    const Token name = peek();
    auto statement = std::make_unique<Stmt>();
    statement->kind = StmtKind::error;
    statement->span = diagnostics::join(name.span, peek(2).span);
    const std::string own = fmt::format("{0} = {0} {1}", name.text, op.text);
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, statement->span,
               {fmt::format("{} {}{}", name.text, op.text, peek(2).text),
                fmt::format("an assignment is written in full: `{} {}`", own, counts ? "1" : "...")});
    if (finding != nullptr) finding->fixes.push_back({statement->span, counts ? own + " 1" : own, "write"});
    for (int i = 0; i < 3; ++i) advance();
    quiet_until_ = 0;
    if (updates) (void)expression();
    return statement;
}

/// Whether the text declares a clock of this name, and no variable.
bool Parser::names_clock(std::string_view word) const {
    bool clock = false;
    for (std::size_t i = 0; i + 2 < tokens_.size(); ++i) {
        if (tokens_.kind(i + 1) != TokenKind::identifier || tokens_.at(i + 1).text != word) continue;
        clock = clock || tokens_.at(i).is("clock");
        if (tokens_.at(i + 2).is(":") && !tokens_.at(i + 3).is("=")) return false;
    }
    return clock;
}

/// `C := 0`; null where it is something else.
StmtPtr Parser::clock_set_to_zero() {
    const Token name = peek();
    const bool zero = peek(1).is(":") && peek(2).is("=") && peek(3).kind == TokenKind::integer && peek(3).text == "0";
    if (!zero || !names_clock(name.text)) return nullptr;
    auto statement = std::make_unique<Stmt>();
    statement->kind = StmtKind::clock_reset;
    statement->span = diagnostics::join(name.span, peek(3).span);
    diagnostics::Diagnostic* const finding =
        report(syntax::other_notation, statement->span,
               {fmt::format("{} := 0", name.text), fmt::format("a clock is reset by `#{}`", name.text)});
    if (finding != nullptr) finding->fixes.push_back({statement->span, fmt::format("#{}", name.text), "write"});
    quiet_until_ = 0;
    statement->name = simple_name("the name of a clock");
    for (int i = 0; i < 3; ++i) advance();
    return statement;
}

/// `if c { S } else { T }`, behind its condition.
StmtPtr Parser::braced_if(StmtPtr begun) {
    report(syntax::other_notation, peek().span, {"{", "an `if` has the form `if c then S else T end`, without braces"});
    quiet_until_ = 0;
    expect("{");
    begun->body.push_back(statement());
    expect("}");
    if (accept("else")) {
        expect("{");
        begun->body.push_back(statement());
        expect("}");
    }
    begun->span = since(begun->span);
    return begun;
}

}  // namespace robochart::frontend
