// The parser's foundation: words, mistakes, recovery, and the file as a whole.
#include "frontend/parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/names.hpp"
#include "frontend/project.hpp"
#include "frontend/syntax_rules.hpp"

namespace robochart::frontend {

namespace {

/// Words that begin a declaration of a file and nothing inside one.
constexpr std::array<std::string_view, 10> top_level_words = {
    "package", "import", "diagram", "interface", "type", "enumeration", "datatype", "record", "function", "module"};
/// Words that begin a member of some body.
constexpr std::array<std::string_view, 29> member_words = {
    "uses",       "requires", "provides",   "var",          "const",        "event",         "_broadcast", "clock",
    "operation",  "opref",    "stm",        "sref",         "cref",         "rref",          "robotic",    "controller",
    "connection", "state",    "initial",    "final",        "junction",     "probabilistic", "transition", "entry",
    "during",     "exit",     "terminates", "precondition", "postcondition"};

template <class Words>
bool among(const Token& token, const Words& words) {
    return token.kind == TokenKind::keyword && std::find(words.begin(), words.end(), token.text) != words.end();
}

}  // namespace

Parser::Parser(const diagnostics::SourceManager& sources, diagnostics::SourceId source, bool is_assertions,
               diagnostics::Diagnostics& out)
    : sources_(sources), source_(source), is_assertions_(is_assertions), out_(out) {
    const std::size_t errors = out.errors();
    TokenStream stream = tokenize(sources, source, is_assertions, out);
    tokens_ = std::move(stream.tokens);
    comments_ = std::move(stream.comments);
    lexical_errors_ = out.errors() > errors;
}

Parser::Nesting::Nesting(Parser& parser) : parser_(parser) {
    if (parser_.depth_ >= max_depth) parser_.too_deep(max_depth);
    ++parser_.depth_;
}

// ---------------------------------------------------------------- words

const Token& Parser::peek(std::size_t ahead) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

bool Parser::at_word(std::string_view word, std::size_t ahead) const {
    const Token& token = peek(ahead);
    const bool word_like = token.kind == TokenKind::identifier || token.kind == TokenKind::keyword;
    return word_like && !token.escaped && token.text == word;
}

const Token& Parser::advance() {
    const Token& token = peek();
    if (at_ + 1 < tokens_.size()) ++at_;
    return token;
}

bool Parser::accept(std::string_view word) {
    if (!at(word)) return false;
    advance();
    return true;
}

bool Parser::accept_word(std::string_view word) {
    if (!at_word(word)) return false;
    advance();
    return true;
}

Span Parser::expect(std::string_view word) {
    if (!at(word)) expected(fmt::format("`{}`", word));
    return advance().span;
}

void Parser::expect_word(std::string_view word) {
    if (!accept_word(word)) expected(fmt::format("`{}`", word));
}

void Parser::name(Declaration& declaration) {
    const QualifiedName read = simple_name("a name");
    declaration.name = read.parts.front();
    declaration.name_span = read.span;
}

QualifiedName Parser::simple_name(std::string_view what) {
    QualifiedName result;
    add_part(result, what);
    return result;
}

QualifiedName Parser::qualified_name(std::string_view what) {
    QualifiedName result = simple_name(what);
    while (at("::") && !peek(1).is("*")) {
        advance();
        add_part(result, "a name after `::`");
    }
    return result;
}

/// A reserved word on the same line is taken for the name that was meant.
void Parser::add_part(QualifiedName& result, std::string_view what) {
    const Token& token = peek();
    if (token.kind == TokenKind::keyword && !token.first_on_line && at_ >= quiet_until_) {
        const Span span = token.span;
        report(syntax::reserved_name, span, {std::string(token.text)});
    } else if (token.kind != TokenKind::identifier) {
        expected(what);
    }
    result.parts.emplace_back(token.text);
    result.spans.push_back(token.span);
    result.span = diagnostics::join(result.span, token.span);
    advance();
}

std::string Parser::found() const {
    const Token& token = peek();
    switch (token.kind) {
        case TokenKind::end:
            return "the end of the file";
        case TokenKind::keyword:
            return fmt::format("the reserved word `{}`", token.text);
        case TokenKind::string:
            return "a string";
        case TokenKind::csp_code:
            return "a CSP block";
        default:
            return fmt::format("`{}`", shorten(token.text));
    }
}

// ---------------------------------------------------------------- mistakes and recovery

diagnostics::Diagnostic* Parser::report(const diagnostics::Rule& rule, Span span, std::vector<std::string> arguments) {
    if (at_ < quiet_until_) return nullptr;
    quiet_until_ = at_ + 3;
    if (++mistakes_ > max_mistakes) {
        out_.report(syntax::too_many, span);
        throw GiveUp{};
    }
    return &out_.report(rule, span, std::move(arguments));
}

void Parser::fail(const diagnostics::Rule& rule, Span span, std::vector<std::string> arguments) {
    report(rule, span, std::move(arguments));
    throw SyntaxError{};
}

/// What is nested like this was not written by people; the rest of the file is not read.
void Parser::too_deep(std::size_t limit) {
    report(syntax::too_deep, peek().span, {std::to_string(limit)});
    throw GiveUp{};
}

/// Something missing at a line's end is shown there, not at the next line's beginning.
void Parser::expected(std::string_view what) {
    Span span = peek().span;
    if (at_ > 0 && (peek().first_on_line || at_end())) span = {source_, previous().span.end, previous().span.end};
    fail(syntax::unexpected, span, {std::string(what), found()});
}

/// The word of the grammar that a misspelt name is near to; "" if there is none.
std::string_view Parser::meant_word() {
    constexpr std::size_t most_checks = 1000;  // garbage of many lines is not worth more
    if (peek().kind != TokenKind::identifier || peek().escaped || ++spelling_checks_ > most_checks) return {};
    std::vector<std::string> words(member_words.begin(), member_words.end());
    words.insert(words.end(), top_level_words.begin(), top_level_words.end());
    const std::string meant = nearest(peek().text, words);
    const auto& reserved = reserved_words();
    const auto word = std::lower_bound(reserved.begin(), reserved.end(), meant);
    return meant.empty() || word == reserved.end() || *word != meant ? std::string_view() : *word;
}

void Parser::wrong_word(std::string_view what) {
    const Span span = peek().span;
    const std::string_view meant = meant_word();
    diagnostics::Diagnostic* finding = report(syntax::unexpected, span, {std::string(what), found()});
    if (finding == nullptr || meant.empty()) throw SyntaxError{};
    finding->fixes.push_back({span, std::string(meant), "did you mean"});
    tokens_[at_].kind = TokenKind::keyword;
    tokens_[at_].text = meant;
    quiet_until_ = 0;
    mended_ = true;
    throw SyntaxError{};
}

bool Parser::mended() {
    const bool result = mended_;
    mended_ = false;
    return result;
}

bool Parser::at_top_level_word() const {
    return among(peek(), top_level_words);
}

bool Parser::at_member_word() const {
    return among(peek(), member_words);
}

/// From an opening brace to behind its closing one. A word that only begins declarations ends the search: a brace is
/// missing.
void Parser::skip_balanced() {
    std::size_t open = 0;
    while (!at_end()) {
        if (open > 0 && at_top_level_word() && peek().first_on_line) return;
        if (at("{") || at("<{")) ++open;
        if (at("}") && --open == 0) {
            advance();
            return;
        }
        advance();
    }
}

void Parser::skip_to_member() {
    while (!at_end() && !at("}") && !at_member_word() && !at_top_level_word()) {
        if (peek().first_on_line && !meant_word().empty()) {
            quiet_until_ = 0;  // a mistake of its own
            return;
        }
        if (at("{") || at("<{"))
            skip_balanced();
        else
            advance();
    }
}

/// In this body, is the next word a sign that the closing brace was forgotten?
bool Parser::closes_missing_brace(unsigned members) const {
    if (at_end() || at_top_level_word()) return true;
    constexpr std::array<std::string_view, 9> part_words = {"stm",  "operation", "controller", "robotic",   "opref",
                                                            "sref", "cref",      "rref",       "connection"};
    constexpr std::array<std::string_view, 8> context_words = {"uses",  "requires", "provides",   "var",
                                                               "const", "event",    "_broadcast", "clock"};
    const bool holds_parts = (members & (controller_members | module_members)) != 0;
    const bool holds_context = (members & context_members) != 0;
    return (!holds_parts && among(peek(), part_words)) ||
           (!holds_parts && !holds_context && among(peek(), context_words));
}

std::unique_ptr<File> Parser::file() {
    auto result = std::make_unique<File>();
    result->source = source_;
    result->is_assertions = is_assertions_;
    try {
        guarded([&] { package_clause(*result); });
        while (!at_end()) is_assertions_ ? assertion_member(*result) : top_level(*result);
    } catch (const GiveUp&) {
        // Reported already; what was read is kept.
    }
    result->comments = std::move(comments_);
    result->has_syntax_errors = lexical_errors_ || mistakes_ > 0;
    return result;
}

std::unique_ptr<File> parse(const diagnostics::SourceManager& sources, diagnostics::SourceId source, bool is_assertions,
                            diagnostics::Diagnostics& out) {
    return Parser(sources, source, is_assertions, out).file();
}

}  // namespace robochart::frontend
