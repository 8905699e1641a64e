// SPDX-License-Identifier: Apache-2.0
// See lexer.hpp. The lexer makes one pass over the bytes and takes the longest matching symbol, as in Xtext.
#include "frontend/syntax/lexer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "base/diagnostics/scanner.hpp"
#include "base/diagnostics/utf8.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

using diagnostics::begins_name;
using diagnostics::continues_name;
using diagnostics::Diagnostics;
using diagnostics::is_digit;
using diagnostics::SourceId;
using diagnostics::Span;

const std::vector<std::string_view>& reserved_words() {
    static const std::vector<std::string_view> words = {"_async",       "_broadcast",    "action",      "as",
                                                        "cat",          "clock",         "condition",   "connection",
                                                        "const",        "controller",    "cref",        "datatype",
                                                        "diagram",      "during",        "else",        "end",
                                                        "entry",        "enumeration",   "event",       "exists",
                                                        "exists1",      "exit",          "false",       "final",
                                                        "forall",       "from",          "function",    "if",
                                                        "iff",          "import",        "in",          "initial",
                                                        "interface",    "inverse",       "is",          "junction",
                                                        "lambda",       "let",           "matrix",      "module",
                                                        "mult",         "not",           "on",          "operation",
                                                        "opref",        "package",       "platform",    "postcondition",
                                                        "precondition", "probabilistic", "probability", "provides",
                                                        "record",       "requires",      "result",      "robotic",
                                                        "rref",         "send",          "since",       "sinceEntry",
                                                        "skip",         "sref",          "state",       "stm",
                                                        "terminates",   "the",           "then",        "to",
                                                        "transition",   "transpose",     "trigger",     "true",
                                                        "type",         "uses",          "var",         "vector",
                                                        "wait"};
    return words;
}

bool is_reserved(std::string_view word) {
    const auto& words = reserved_words();
    return std::ranges::binary_search(words, word);
}

std::span<const std::string_view> robosim_words() {
    static constexpr std::array<std::string_view, 6> words = {"context", "cycle", "cycleDef",
                                                              "exec",    "input", "output"};
    return words;
}

bool is_reserved(std::string_view word, Dialect dialect) {
    return is_reserved(word) || (dialect == Dialect::robosim && std::ranges::binary_search(robosim_words(), word));
}

std::string shorten_token(std::string_view text) {
    constexpr std::size_t limit = 40;
    std::string out;
    std::size_t shown = 0;
    while (!text.empty() && shown < limit) {
        const std::size_t length = std::max<std::size_t>(1, diagnostics::utf8_length(text));
        const bool plain = length > 1 || (static_cast<unsigned char>(text[0]) >= 0x20U && text[0] != 0x7F &&
                                          static_cast<unsigned char>(text[0]) < 0x80U);
        out += plain ? text.substr(0, length) : std::string_view("?");
        text.remove_prefix(length);
        ++shown;
    }
    return text.empty() ? out : out + "...";
}

namespace {

// The operators and brackets, longest first.
constexpr std::array<std::string_view, 46> symbols = {
    "<->", "::", "->", "<{", "=>", "==", "!=", ">=", "<=", "\\/", "/\\", "(|", "|)", "[|", "|]", "&&",
    "||",  "{",  "}",  "(",  ")",  "[",  "]",  "<",  ">",  "=",   ":",   ";",  ",",  ".",  "?",  "!",
    "#",   "|",  "@",  "+",  "-",  "*",  "/",  "%",  "^",  "$",   "&",   "~",  "`",  "\\"};
/// The remaining `symbols` are used only in probabilistic assertions.
constexpr std::size_t model_symbols = 42;

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// Returns all texts that a corrected token may have: the reserved words of both dialects, and the symbols.
const std::vector<std::string_view>& known_texts() {
    static const std::vector<std::string_view> texts = [] {
        std::vector<std::string_view> all = reserved_words();
        all.insert(all.end(), robosim_words().begin(), robosim_words().end());
        all.insert(all.end(), symbols.begin(), symbols.end());
        return all;
    }();
    return texts;
}

std::size_t index_of(std::string_view word) {
    return static_cast<std::size_t>(std::ranges::find(known_texts(), word) - known_texts().begin());
}

class Lexer : diagnostics::Scanner {
public:
    Lexer(std::string_view text, SourceId source, bool is_assertions, Dialect dialect, Diagnostics& out)
        : Scanner(text, source), is_assertions_(is_assertions), dialect_(dialect), out_(out) {}

    TokenStream run();

private:
    void add(TokenKind kind, std::size_t begin, bool escaped = false);
    bool refuse_binary();
    void skip_space();
    bool read_comment();
    void read_word();
    void csp_code(std::size_t begin);
    void read_number();
    void check_integer(std::size_t begin);
    void check_real(std::size_t begin);
    void read_string();
    bool read_symbol();
    void skip_unexpected();
    bool read_mathematical_sign();
    void read_token();
    bool too_long();

    bool is_assertions_;
    Dialect dialect_;
    Diagnostics& out_;
    std::size_t line_begin_ = 0;  ///< offset just after the last line end passed
    std::size_t last_end_ = 0;    ///< end of the last token
    TokenStream stream_{TokenList(text_, source_), {}};
};

void Lexer::add(TokenKind kind, std::size_t begin, bool escaped) {
    const bool first_on_line = stream_.tokens.empty() || last_end_ <= line_begin_;
    stream_.tokens.add(kind, span_from(begin), escaped, first_on_line);
    last_end_ = std::max(at_, begin + 1);
}

/// Rejects a file with a NUL byte, which never occurs in text. The whole file gets one message.
bool Lexer::refuse_binary() {
    const std::size_t nul = text_.find('\0');
    if (nul == std::string_view::npos) return false;
    at_ = nul + 1;
    out_.report(syntax::not_text, span_from(nul));
    at_ = text_.size();
    return true;
}

void Lexer::skip_space() {
    for (; is_space(peek()); ++at_)
        if (peek() == '\n' || peek() == '\r') line_begin_ = at_ + 1;
}

bool Lexer::read_comment() {
    const std::size_t begin = at_;
    if (accept("/*")) {
        const Span opening = span_from(begin);
        if (!skip_past("*/")) out_.report(syntax::open_comment, opening);
        const std::size_t last = text_from(begin).find_last_of("\r\n");
        if (last != std::string_view::npos) line_begin_ = begin + last + 1;
    } else if (looking_at("//")) {
        skip_to("\r\n");
    } else {
        return false;
    }
    stream_.comments.push_back(span_from(begin));
    return true;
}

void Lexer::csp_code(std::size_t begin) {
    const Span opening = span_from(begin);
    if (!skip_past("csp-end")) out_.report(syntax::open_csp_block, opening);
    add(TokenKind::csp_code, begin);
}

void Lexer::read_word() {
    const std::size_t begin = at_;
    const bool escaped = accept("^");
    const std::size_t name = at_;
    skip_name();
    const std::string_view text = text_from(name);
    if (is_assertions_ && text == "csp" && accept("-begin")) return csp_code(begin);
    if (!escaped && (text == "Set" || text == "Seq") && accept("(")) return add(TokenKind::symbol, begin);
    add(!escaped && is_reserved(text, dialect_) ? TokenKind::keyword : TokenKind::identifier, begin, escaped);
}

void Lexer::check_integer(std::size_t begin) {
    const std::string_view digits = text_from(begin);
    std::int64_t value = 0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (result.ec != std::errc()) out_.report(syntax::huge_integer, span_from(begin), {shorten_token(digits)});
}

/// Reports a real with too many digits. Reals are stored exactly, as decimals of at most 18 digits.
void Lexer::check_real(std::size_t begin) {
    std::string_view digits = text_from(begin);
    const std::size_t leading = std::min(digits.find_first_not_of('0'), digits.find('.'));
    digits.remove_prefix(leading);
    if (digits.size() - 1 > 18) out_.report(syntax::long_real, span_from(begin), {shorten_token(digits)});
}

void Lexer::read_number() {
    const std::size_t begin = at_;
    skip_digits();
    const bool real = peek() == '.' && is_digit(peek(1));
    if (real) {
        ++at_;
        skip_digits();
        check_real(begin);
    } else {
        check_integer(begin);
    }
    add(real ? TokenKind::real : TokenKind::integer, begin);
}

void Lexer::read_string() {
    const std::size_t begin = at_;
    const char quote = text_[at_++];
    while (!at_end() && text_[at_] != quote) at_ += text_[at_] == '\\' ? 2U : 1U;
    if (at_end()) {
        at_ = begin + 1;
        diagnostics::Diagnostic& finding = out_.report(syntax::open_string, span_from(begin));
        if (quote == '\'' && begin > 0 && continues_name(text_[begin - 1]))
            finding.notes.push_back({{}, "a name cannot contain a prime: an assignment is written `x = e`"});
        skip_to("\r\n");
    } else {
        ++at_;
    }
    add(TokenKind::string, begin);
}

bool Lexer::read_symbol() {
    const std::size_t begin = at_;
    const std::size_t known = is_assertions_ ? symbols.size() : model_symbols;
    if (accept_first(std::span(symbols).first(known)) == nullptr) return false;
    add(TokenKind::symbol, begin);
    return true;
}

/// Reports a mathematical sign such as ≤ and reads it as RoboChart's equivalent.
bool Lexer::read_mathematical_sign() {
    struct Sign {
        std::string_view written;
        std::string_view own;
    };
    constexpr std::array<Sign, 9> signs{{{"\u2264", "<="},
                                         {"\u2265", ">="},
                                         {"\u2260", "!="},
                                         {"\u2227", "/\\"},
                                         {"\u2228", "\\/"},
                                         {"\u00AC", "not"},
                                         {"\u2192", "->"},
                                         {"\u00D7", "*"},
                                         {"\u2212", "-"}}};
    const std::size_t begin = at_;
    const Sign* const sign = accept_first(signs, &Sign::written);
    if (sign == nullptr) return false;
    const bool word = sign->own == "not";
    out_.report(syntax::strange_character, span_from(begin), {std::string(sign->written)})
        .fixes.push_back({span_from(begin), word ? "not " : std::string(sign->own), "write"});
    const TokenKind kind = word ? TokenKind::keyword : TokenKind::symbol;
    add(kind, begin);
    stream_.tokens.correct_token(stream_.tokens.size() - 1, kind, sign->own);
    return true;
}

/// Skips consecutive bytes that begin no token, and reports them as one mistake. If they are inside a name, the mistake
/// includes the rest of the name.
void Lexer::skip_unexpected() {
    const std::size_t begin = at_;
    const auto strange = [](char c) {
        return static_cast<unsigned char>(c) >= 0x80U || static_cast<unsigned char>(c) < 0x20U || c == 0x7F;
    };
    const bool inside_name =
        last_end_ == begin && !stream_.tokens.empty() && stream_.tokens.last_token().kind == TokenKind::identifier;
    const auto goes_on = [&](char c) { return (strange(c) && !is_space(c)) || (inside_name && continues_name(c)); };
    ++at_;
    skip_while(goes_on);
    out_.report(syntax::strange_character, span_from(begin), {shorten_token(text_from(begin))});
}

void Lexer::read_token() {
    const char c = peek();
    if (read_comment()) return;
    if (begins_name(c) || (c == '^' && begins_name(peek(1)))) return read_word();
    if (is_digit(c)) return read_number();
    if (c == '"' || c == '\'') return read_string();
    if (!read_symbol() && !read_mathematical_sign()) skip_unexpected();
}

bool Lexer::too_long() {
    if (stream_.tokens.size() < max_tokens) return false;
    out_.report(syntax::too_long, span_from(at_), {std::to_string(max_tokens)});
    at_ = text_.size();
    return true;
}

TokenStream Lexer::run() {
    if (!refuse_binary()) {
        for (skip_space(); !at_end() && !too_long(); skip_space()) {
            out_.poll();
            read_token();
        }
    }
    add(TokenKind::end, at_);
    return std::move(stream_);
}

}  // namespace

std::span<const std::string_view> assertion_words() {
    static constexpr std::array<std::string_view, 94> words = {
        "ACI",           "APMC",        "CI",          "Cumul",      "Exists",      "Finally",
        "Forall",        "Globally",    "LTL",         "Next",       "Prob",        "Reachable",
        "Release",       "Reward",      "SPRT",        "Total",      "Until",       "Weak",
        "and",           "assertion",   "assigned",    "associated", "assume",      "at",
        "begin",         "bool",        "claim",       "cmdoptions", "conform",     "conforms",
        "constant",      "constants",   "csp",         "deadlock",   "definitions", "defs",
        "deterministic", "divergence",  "divergences", "does",       "endrewards",  "equal",
        "equals",        "failures",    "for",         "formula",    "free",        "generate",
        "init",          "initialised", "instantiate", "label",      "max",         "min",
        "missed",        "model",       "modules",     "of",         "order",       "out",
        "parameter",     "path",        "pfunction",   "pmodule",    "pmodules",    "poperation",
        "prob",          "property",    "reachable",   "refine",     "refines",     "repeats",
        "return",        "rewards",     "set",         "sim",        "simulation",  "sleec",
        "steps",         "terminate",   "tick",        "time",       "timed",       "timelock",
        "tock",          "traces",      "unit",        "units",      "untimed",     "up",
        "using",         "val",         "value",       "with"};
    return words;
}

std::span<const std::string_view> symbol_words() {
    return symbols;
}

Token TokenList::operator[](std::size_t index) const {
    const Packed& item = items_[index];
    Token token;
    token.kind = item.kind;
    token.escaped = item.escaped;
    token.first_on_line = item.first_on_line;
    token.span = {source_, item.begin, item.end};
    const std::uint32_t begin = item.begin + (item.escaped ? 1U : 0U);
    token.text = item.word != 0 ? known_texts()[item.word - 1U] : text_.substr(begin, item.end - begin);
    return token;
}

void TokenList::add(TokenKind kind, Span span, bool escaped, bool first_on_line) {
    items_.push_back({span.begin, span.end, kind, escaped, first_on_line, 0});
}

void TokenList::correct_token(std::size_t index, TokenKind kind, std::string_view word) {
    items_[index].kind = kind;
    items_[index].escaped = false;
    items_[index].word = static_cast<std::uint16_t>(index_of(word) + 1);
}

void TokenList::drop_first_character(std::size_t index) {
    ++items_[index].begin;
    items_[index].escaped = false;
    items_[index].first_on_line = false;
}

TokenStream tokenize(const diagnostics::SourceManager& sources, SourceId source, bool is_assertions, Diagnostics& out) {
    return Lexer(sources.source_text(source), source, is_assertions, dialect_of(sources.path(source)), out).run();
}

}  // namespace robochart::frontend
