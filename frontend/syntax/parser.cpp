// SPDX-License-Identifier: Apache-2.0
// Implements the core of the parser: tokens, errors, recovery, and the parsing of a whole file.
#include "frontend/syntax/parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/diagnostics/spelling.hpp"
#include "frontend/syntax/parse.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

namespace {

/// Words that can begin only a top-level declaration of a file.
constexpr std::array<std::string_view, 10> top_level_words = {
    "package", "import", "diagram", "interface", "type", "enumeration", "datatype", "record", "function", "module"};
/// Words that can begin a member of a body.
constexpr std::array<std::string_view, 29> member_words = {
    "uses",       "requires", "provides",   "var",          "const",        "event",         "_broadcast", "clock",
    "operation",  "opref",    "stm",        "sref",         "cref",         "rref",          "robotic",    "controller",
    "connection", "state",    "initial",    "final",        "junction",     "probabilistic", "transition", "entry",
    "during",     "exit",     "terminates", "precondition", "postcondition"};
/// Words of RoboSim that can begin a member of a body; RoboChart does not reserve them.
constexpr std::array<std::string_view, 3> robosim_member_words = {"cycleDef", "input", "output"};

/// True for words that begin a component in the extension of RoboChart with neural networks.
bool among_neural(std::string_view word) {
    constexpr std::array<std::string_view, 6> words = {"anncontroller", "ANNController", "annoperation",
                                                       "ANNOperation",  "ann",           "ANN"};
    return std::ranges::find(words, word) != words.end();
}

template <class Words>
bool is_among(const Token& token, const Words& words) {
    return token.kind == TokenKind::keyword && std::ranges::find(words, token.text) != words.end();
}

}  // namespace

Parser::Parser(const diagnostics::SourceManager& sources, diagnostics::SourceId source, bool is_assertions,
               diagnostics::Diagnostics& out)
    : sources_(sources),
      source_(source),
      is_assertions_(is_assertions),
      dialect_(dialect_of(sources.path(source))),
      out_(out) {
    const std::size_t errors = out.error_count();
    TokenStream stream = tokenize(sources, source, is_assertions, out);
    tokens_ = std::move(stream.tokens);
    comments_ = std::move(stream.comments);
    lexical_errors_ = out.error_count() > errors;
    if (lexical_errors_)
        for (const diagnostics::Diagnostic& finding : out.sorted_findings())
            if (finding.span.source == source && finding.rule == &syntax::strange_character)
                strange_.push_back(finding.span.begin);
    const std::string_view text = sources.source_text(source);
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\n' || text[i] == '\r') line_begins_.push_back(i + 1);
    for (const Token& token : tokens_) {
        if (token.kind != TokenKind::symbol) continue;
        if (token.text == "{" || token.text == "<{") ++surplus_;
        if (token.text == "}") --surplus_;
    }
}

Parser::Nesting::Nesting(Parser& parser) : parser_(parser) {
    if (parser_.depth_ >= max_depth) parser_.too_deep(max_depth);
    ++parser_.depth_;
}

// ---------------------------------------------------------------- words

bool Parser::at_word(std::string_view word, std::size_t ahead) const {
    const Token& token = peek(ahead);
    const bool word_like = token.kind == TokenKind::identifier || token.kind == TokenKind::keyword;
    return word_like && !token.escaped && token.text == word;
}

Token Parser::advance_token() {
    out_.poll();
    const Token token = peek();
    if (at_ + 1 < tokens_.size()) ++at_;
    return token;
}

bool Parser::accept_token(std::string_view word) {
    if (!at_token(word)) return false;
    advance_token();
    return true;
}

bool Parser::accept_word(std::string_view word) {
    if (!at_word(word)) return false;
    advance_token();
    return true;
}

Span Parser::expect_token(std::string_view word) {
    if (at_token(word)) return advance_token().span;
    const Span place = missing_place();
    diagnostics::Diagnostic* finding = report_missing(fmt::format("`{}`", word));
    const bool stray = peek(1).is_word(word) && !at_token("{") && !at_token("}") && !peek(1).first_on_line;
    if (stray) {
        advance_token();
        return advance_token().span;
    }
    const bool closes = word == ")" || word == "]" || word == "|)" || word == "|]";
    if (finding != nullptr && closes) {
        finding->fixes.push_back({{source_, place.begin, place.begin}, std::string(word), "insert"});
        inserted_ = finding;
    }
    return {source_, place.begin, place.begin};
}

void Parser::expect_word(std::string_view word) {
    if (accept_word(word)) return;
    report_missing(fmt::format("`{}`", word));
    if (!at_word(word, 1)) return;
    advance_token();
    advance_token();
}

void Parser::name(Declaration& declaration) {
    const QualifiedName read = simple_name("a name");
    declaration.name = read.parts.front();
    declaration.name_span = read.span;
    if (declaration.name.starts_with('?')) lost_declarations_ = true;
}

QualifiedName Parser::simple_name(std::string_view what) {
    QualifiedName result;
    add_part(result, what);
    return result;
}

QualifiedName Parser::plain_name(std::string_view what) {
    QualifiedName result = simple_name(what);
    if (!at_token("::")) return result;
    const std::size_t start = at_ - 1;
    at_ = start;
    const QualifiedName written = qualified_name(what);
    QualifiedName last;
    last.parts.push_back(written.parts.back());
    last.spans.push_back(written.spans.back());
    last.span = written.spans.back();
    if (diagnostics::Diagnostic* finding = report(syntax::plain_name, written.span, {shorten_token(written.text())}))
        finding->fixes.push_back({written.span, last.parts.front(), "remove the part that contains it"});
    return last;
}

QualifiedName Parser::qualified_name(std::string_view what) {
    QualifiedName result = simple_name(what);
    while (at_token("::") && !peek(1).is_word("*")) {
        advance_token();
        if (result.parts.size() >= max_depth) too_deep(max_depth);
        add_part(result, "a name after `::`");
    }
    return result;
}

/// Parses a part of a name. A reserved word on the same line is read as the name. A missing name is replaced by a name
/// that no author can write.
void Parser::add_part(QualifiedName& result, std::string_view what) {
    const Token token = peek();
    const bool reserved = token.kind == TokenKind::keyword && !token.first_on_line && at_ >= quiet_until_;
    const bool followed = peek(1).is_word("{") || peek(1).is_word(":") || peek(1).is_word("(") ||
                          peek(1).is_word("=") || result.parts.empty();
    std::string part(token.text);
    Span span = token.span;
    bool written = true;
    if (reserved && followed && !at_follower()) {
        if (diagnostics::Diagnostic* finding = report(syntax::reserved_name, span, {part}))
            finding->fixes.push_back({span, "^" + part, "escape it"});
        lost_names_.push_back(part);  // so that the name is not also reported as unknown
    } else if (token.kind != TokenKind::identifier) {
        span = missing_place();
        span.end = span.begin;
        part = fmt::format("?{}", span.begin);
        report_missing(what);
        written = token.kind == TokenKind::integer || token.kind == TokenKind::real || token.kind == TokenKind::string;
    }
    result.parts.push_back(std::move(part));
    result.spans.push_back(span);
    result.span = diagnostics::join_spans(result.span, span);
    if (written) advance_token();
}

/// True if the next word can only follow a name, so that the name before it is missing.
bool Parser::at_follower() const {
    constexpr std::array<std::string_view, 8> followers = {"to",        "on",     "from", "trigger",
                                                           "condition", "action", "is",   "in"};
    constexpr std::array<std::string_view, 8> members = {"var",  "const",    "event",    "clock",
                                                         "uses", "requires", "provides", "transition"};
    if (is_among(peek(), members) && peek(1).kind == TokenKind::identifier && !peek(1).first_on_line) return true;
    return is_among(peek(), followers) && (peek(1).kind == TokenKind::identifier || peek(1).kind == TokenKind::keyword);
}

std::string Parser::describe_token() const {
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
        case TokenKind::identifier:
        case TokenKind::integer:
        case TokenKind::real:
        case TokenKind::symbol:
            break;
    }
    return fmt::format("`{}`", shorten_token(token.text));
}

// ---------------------------------------------------------------- mistakes and recovery

diagnostics::Diagnostic* Parser::report(const diagnostics::Rule& rule, Span span, std::vector<std::string> arguments) {
    ++failures_;
    if (at_ < quiet_until_ || behind_strange_characters()) {
        // The inserted token did not repair the text, so it must not be offered as a fix.
        if (inserted_ != nullptr) inserted_->fixes.clear();
        inserted_ = nullptr;
        return nullptr;
    }
    inserted_ = nullptr;
    quiet_until_ = at_ + 3;
    if (++mistakes_ > max_mistakes) {
        out_.report(syntax::too_many, span);
        throw GiveUp{};
    }
    const std::string what = &rule == &syntax::unexpected ? arguments.front() : std::string();
    const std::string_view advice = what.empty() ? std::string_view() : form_meant(what);
    diagnostics::Diagnostic& finding = out_.report(rule, span, std::move(arguments));
    if (!what.empty()) point_to_open(what, finding);
    if (!advice.empty()) finding.notes.push_back({{}, std::string(advice)});
    return &finding;
}

std::string_view Parser::form_meant(std::string_view expected) const {
    return diagnostics::advice_on(foreign_forms(), expected, [this](std::ptrdiff_t ahead) {
        return advice_word(tokens_, static_cast<std::ptrdiff_t>(at_) + ahead);
    });
}

/// Returns the last opening brace before this place that is not closed. If a closing brace is indented less than the
/// line of its opening brace, that opening brace was probably not closed, and the closing brace belongs to an enclosing
/// block.
std::optional<std::size_t> Parser::unclosed_brace(bool& by_indentation) const {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < at_; ++i) {
        if (tokens_.kind(i) != TokenKind::symbol) continue;
        const Token token = tokens_[i];
        if (token.text == "{" || token.text == "<{") open.push_back(i);
        if (token.text != "}" || open.empty()) continue;
        by_indentation = token.first_on_line && indentation_of(i) < indentation_of(open.back());
        if (by_indentation) return open.back();
        open.pop_back();
    }
    return open.empty() ? std::nullopt : std::optional(open.back());
}

void Parser::point_to_open(std::string_view what, diagnostics::Diagnostic& finding) const {
    if (surplus_ <= 0 || what.find("`}`") == std::string_view::npos || !(peek().first_on_line || at_end())) return;
    bool by_indentation = false;
    const auto open = unclosed_brace(by_indentation);
    if (!open) return;
    finding.notes.push_back({tokens_.token_at(*open).span,
                             by_indentation
                                 ? "this `{` is probably not closed, because the matching `}` has a smaller indentation"
                                 : "this `{` is not closed"});
}

/// True if invalid characters were skipped before the next token. The message about them is then sufficient.
bool Parser::behind_strange_characters() const {
    const std::uint32_t from = at_ > 0 ? previous_token().span.end : 0;
    const auto first = std::ranges::lower_bound(strange_, from);
    return first != strange_.end() && *first < std::max(from + 1, peek().span.begin);
}

void Parser::report_and_throw(const diagnostics::Rule& rule, Span span, std::vector<std::string> arguments) {
    report(rule, span, std::move(arguments));
    throw SyntaxError{};
}

/// Reports nesting that is too deep, which nobody writes by hand, and skips the rest of the file.
void Parser::too_deep(std::size_t limit) {
    report(syntax::too_deep, peek().span, {std::to_string(limit)});
    throw GiveUp{};
}

/// Returns the place of a missing token. If the next token begins a line, the place is the end of the line before.
Span Parser::missing_place() const {
    const Span span = peek().span;
    if (at_ == 0 || !(peek().first_on_line || at_end())) return span;
    return {source_, previous_token().span.end, previous_token().span.end};
}

void Parser::fail_expecting(std::string_view what) {
    report_and_throw(syntax::unexpected, missing_place(), {std::string(what), describe_token()});
}

diagnostics::Diagnostic* Parser::report_missing(std::string_view what) {
    if (at_ < quiet_until_) fail_expecting(what);
    return report(syntax::unexpected, missing_place(), {std::string(what), describe_token()});
}

/// Reports an operand that needs parentheses. Parsing continues as if the parentheses were present.
void Parser::needs_parentheses(std::string_view what, Span span) {
    diagnostics::Diagnostic* finding = report(syntax::needs_parentheses, span, {std::string(what)});
    if (finding == nullptr) return;
    const std::string text(sources_.source_text(source_).substr(span.begin, span.end - span.begin));
    finding->fixes.push_back({span, "(" + text + ")", "write"});
}

/// Records names in a part that could not be parsed. They may be declared there, so they are not reported as unknown.
void Parser::mark_lost_names(std::size_t begin, std::size_t end) {
    if (failures_ == forgotten_) return;
    forgotten_ = failures_;
    for (std::size_t i = begin; i < end && i < tokens_.size(); ++i)
        if (tokens_.kind(i) == TokenKind::identifier) lost_names_.emplace_back(tokens_[i].text);
}

/// Reports a component that is a neural network, which newer grammars allow, and skips its body.
bool Parser::neural_construct() {
    const Token token = peek();
    const bool begins = token.kind == TokenKind::identifier && peek(1).kind == TokenKind::identifier &&
                        (peek(2).is_word("{") || peek(2).is_word("(") || peek(2).is_word("="));
    if (!begins || !among_neural(token.text)) return false;
    report(syntax::neural, diagnostics::join_spans(token.span, peek(1).span), {std::string(token.text)});
    const bool has_body = peek(2).is_word("{") || peek(2).is_word("(");
    while (has_body && !at_end() && !at_token("{")) advance_token();
    if (has_body)
        skip_balanced();
    else
        for (int i = 0; i < 4; ++i) advance_token();
    quiet_until_ = 0;
    return true;
}

std::size_t Parser::indentation_of(std::size_t token) const {
    const std::size_t end = tokens_.token_at(token).span.begin;
    const std::size_t begin = *std::prev(std::ranges::upper_bound(line_begins_, end));
    const std::string_view line = sources_.source_text(source_).substr(begin, end - begin);
    return std::min(line.size(), line.find_first_not_of(" \t"));
}

/// True if the text has too many closing braces and the body continues after the current one.
bool Parser::stray_brace(std::size_t open) const {
    if (surplus_ >= 0) return false;
    const std::string_view body =
        sources_.source_text(source_).substr(0, peek().span.begin).substr(tokens_.token_at(open).span.begin);
    if (body.find('\n') == std::string_view::npos) return false;
    const Token next = peek(1);
    if (next.is_word("}") || next.kind == TokenKind::end) return false;
    if (!next.first_on_line) return true;
    return !peek().first_on_line && indentation_of(at_ + 1) > indentation_of(open);
}

void Parser::pass_stray_brace() {
    if (diagnostics::Diagnostic* finding = report(syntax::stray_bracket, peek().span))
        finding->fixes.push_back({peek().span, "", "remove it"});
    ++surplus_;
    advance_token();
    quiet_until_ = at_ + 3;
}

/// Returns the word of the grammar that is nearest to a misspelt name, or "" if there is none.
std::string_view Parser::meant_word() {
    constexpr std::size_t most_checks = 1000;  // more checks would not help in a text that is not RoboChart
    if (peek().kind != TokenKind::identifier || peek().escaped || ++spelling_checks_ > most_checks) return {};
    std::vector<std::string> words = known_member_words();
    words.insert(words.end(), top_level_words.begin(), top_level_words.end());
    const std::string meant = diagnostics::nearest_spelling(peek().text, words);
    const auto* const own = std::ranges::find(robosim_member_words, meant);
    if (own != robosim_member_words.end()) return *own;
    const auto& reserved = reserved_words();
    const auto word = std::ranges::lower_bound(reserved, meant);
    return meant.empty() || word == reserved.end() || *word != meant ? std::string_view() : *word;
}

/// Returns the words that can begin a member of a body in the dialect of the file.
std::vector<std::string> Parser::known_member_words() const {
    std::vector<std::string> words(member_words.begin(), member_words.end());
    if (is_robosim()) words.insert(words.end(), robosim_member_words.begin(), robosim_member_words.end());
    return words;
}

bool Parser::correct_word(std::initializer_list<std::string_view> keywords) {
    if (peek().kind != TokenKind::identifier || peek().escaped || at_ < quiet_until_) return false;
    const std::vector<std::string> words(keywords.begin(), keywords.end());
    const std::string meant = diagnostics::nearest_spelling(peek().text, words);
    const auto* const keyword = std::ranges::find(keywords, meant);
    if (keyword == keywords.end()) return false;
    const bool certain = diagnostics::is_certain(peek().text, meant, words);
    diagnostics::Diagnostic* const finding =
        report(syntax::unexpected, peek().span, {fmt::format("`{}`", meant), describe_token()});
    if (finding != nullptr) finding->fixes.push_back({peek().span, meant, diagnostics::suggestion_verb(certain)});
    tokens_.correct_token(at_, TokenKind::keyword, *keyword);
    quiet_until_ = 0;
    return true;
}

void Parser::wrong_word(std::string_view what, std::initializer_list<ForeignPlace> places) {
    const bool replaced = state_machine_words() || typed_like_c() ||
                          std::ranges::any_of(places, [&](ForeignPlace p) { return replace_foreign(p); });
    if (replaced) {
        corrected_ = true;
        throw SyntaxError{};
    }
    const Span span = peek().span;
    const std::string_view meant = meant_word();
    const std::vector<std::string> words = known_member_words();
    const bool certain = diagnostics::is_certain(peek().text, meant, words);
    diagnostics::Diagnostic* finding = report(syntax::unexpected, span, {std::string(what), describe_token()});
    if (finding == nullptr || meant.empty()) throw SyntaxError{};
    finding->fixes.push_back({span, std::string(meant), diagnostics::suggestion_verb(certain)});
    tokens_.correct_token(at_, TokenKind::keyword, meant);
    quiet_until_ = 0;
    corrected_ = true;
    throw SyntaxError{};
}

bool Parser::take_correction() {
    const bool result = corrected_;
    corrected_ = false;
    return result;
}

bool Parser::at_top_level_word() const {
    return is_among(peek(), top_level_words);
}

bool Parser::at_member_word() const {
    return is_among(peek(), member_words) || is_among(peek(), robosim_member_words);
}

/// Skips from an opening brace to the position after its closing brace. A word that can only begin a top-level
/// declaration ends the search, because a brace must be missing.
void Parser::skip_balanced() {
    std::size_t open = 0;
    while (!at_end()) {
        if (open > 0 && at_top_level_word() && peek().first_on_line) return;
        if (at_token("{") || at_token("<{")) ++open;
        if (at_token("}") && --open == 0) {
            advance_token();
            return;
        }
        advance_token();
    }
}

void Parser::skip_to_member() {
    while (!at_end() && !at_member_word() && !at_top_level_word()) {
        if (at_token("}")) {
            if (surplus_ >= 0) return;
            ++surplus_;  // the opening brace of this brace was closed too early
            advance_token();
            continue;
        }
        if (peek().first_on_line && !meant_word().empty()) {
            quiet_until_ = 0;  // a separate mistake
            return;
        }
        if (at_token("{") || at_token("<{"))
            skip_balanced();
        else
            advance_token();
    }
}

/// True if the next word cannot occur in this body, so that the body's closing brace is missing.
bool Parser::closes_missing_brace(unsigned members) const {
    if (at_end() || at_top_level_word()) return true;
    constexpr std::array<std::string_view, 9> part_words = {"stm",  "operation", "controller", "robotic",   "opref",
                                                            "sref", "cref",      "rref",       "connection"};
    constexpr std::array<std::string_view, 8> context_words = {"uses",  "requires", "provides",   "var",
                                                               "const", "event",    "_broadcast", "clock"};
    // In an interface, `operation f()` without a body is a signature with a superfluous keyword.
    const bool signature = members == context_members && at_token("operation") && peek(2).is_word("(");
    if (signature)
        if (const auto behind = behind_brackets(2); behind && !peek(*behind).is_word("{")) return false;
    const bool holds_parts = (members & (controller_members | module_members)) != 0;
    const bool holds_context = (members & context_members) != 0;
    if ((members & register_members) != 0)
        return is_among(peek(), part_words) || is_among(peek(), robosim_member_words) || at_token("state") ||
               at_token("initial") || at_token("final") || at_token("junction") || at_token("transition");
    return (!holds_parts && is_among(peek(), part_words)) ||
           (!holds_parts && !holds_context &&
            (is_among(peek(), context_words) || is_among(peek(), robosim_member_words)));
}

std::unique_ptr<File> Parser::parse_file() {
    auto result = std::make_unique<File>();
    result->source = source_;
    result->dialect = dialect_;
    result->is_assertions = is_assertions_;
    try {
        catch_syntax_error([&] { package_clause(*result); });
        while (!at_end())
            if (is_assertions_)
                assertion_member(*result);
            else
                top_level(*result);
    } catch (const GiveUp&) {
        // The error has been reported. The part that was parsed before it is used.
    }
    result->comments = std::move(comments_);
    result->lost_names = std::move(lost_names_);
    result->lost_declarations = lost_declarations_;
    result->has_syntax_errors = lexical_errors_ || mistakes_ > 0;
    return result;
}

namespace {

/// Returns the folder of a displayed path, which may be relative.
std::string folder_of(const std::string& path) {
    std::error_code code;
    const std::filesystem::path absolute = std::filesystem::absolute(path, code);
    const std::string folder =
        (code ? std::filesystem::path(path) : absolute).lexically_normal().parent_path().string();
    return folder.ends_with("/") ? folder : folder + "/";
}

}  // namespace

std::unique_ptr<File> parse(const diagnostics::SourceManager& sources, diagnostics::SourceId source, bool is_assertions,
                            diagnostics::Diagnostics& out) {
    std::unique_ptr<File> file = Parser(sources, source, is_assertions, out).parse_file();
    file->folder = folder_of(sources.path(source));
    return file;
}

}  // namespace robochart::frontend
