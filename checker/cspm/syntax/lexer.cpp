// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/syntax/lexer.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string>

#include "base/diagnostics/scanner.hpp"
#include "base/diagnostics/utf8.hpp"
#include "checker/cspm/syntax/advice.hpp"
#include "checker/cspm/syntax/rules.hpp"

namespace robochart::cspm {

namespace {

using diagnostics::is_digit;
using diagnostics::Span;

// Says which line ends around a token have no effect (FDR's lexer, libcspm Lexer.x). `before`: those before the token,
// because it cannot begin an expression or declaration. `after`: those after the token.
enum LineBreaks : std::uint8_t { plain = 0, before = 1, after = 2, both_sides = 3 };

struct Symbol {
    Tok kind;
    std::string_view text;
    LineBreaks layout;
};

// The longest spellings come first, so that the first match is the longest.
constexpr std::array symbols{
    Symbol{Tok::refines_fd, "[FD=", both_sides},
    Symbol{Tok::refines_vd, "[VD=", both_sides},
    Symbol{Tok::refines_rd, "[RD=", both_sides},
    Symbol{Tok::refines_t, "[T=", both_sides},
    Symbol{Tok::refines_f, "[F=", both_sides},
    Symbol{Tok::refines_v, "[V=", both_sides},
    Symbol{Tok::refines_r, "[R=", both_sides},
    Symbol{Tok::internal_choice, "|~|", both_sides},
    Symbol{Tok::interleave, "|||", both_sides},
    Symbol{Tok::tie, "<->", both_sides},
    Symbol{Tok::yield_star, "=>*", both_sides},
    Symbol{Tok::external_choice, "[]", both_sides},
    Symbol{Tok::interrupt, "/\\", both_sides},
    Symbol{Tok::arrow, "->", both_sides},
    Symbol{Tok::sliding, "[>", both_sides},
    Symbol{Tok::exception_end, "|>", both_sides},
    Symbol{Tok::parallel_bar, "||", both_sides},
    Symbol{Tok::project, "|\\", both_sides},
    Symbol{Tok::l_sync_interrupt, "/+", both_sides},
    Symbol{Tok::r_sync_interrupt, "+\\", both_sides},
    Symbol{Tok::l_sync_choice, "[+", both_sides},
    Symbol{Tok::r_sync_choice, "+]", both_sides},
    Symbol{Tok::equal_equal, "==", both_sides},
    Symbol{Tok::not_equal, "!=", both_sides},
    Symbol{Tok::less_equal, "<=", both_sides},
    Symbol{Tok::greater_equal, ">=", both_sides},
    Symbol{Tok::drawn_from, "<-", both_sides},
    Symbol{Tok::yield, "=>", both_sides},
    Symbol{Tok::double_at, "@@", both_sides},
    Symbol{Tok::dot_dot, "..", both_sides},
    Symbol{Tok::l_pipe_brace, "{|", after},
    Symbol{Tok::r_pipe_brace, "|}", before},
    Symbol{Tok::r_map, "|)", before},
    Symbol{Tok::l_double_square, "[[", both_sides},
    Symbol{Tok::r_double_square, "]]", before},
    Symbol{Tok::l_pipe_square, "[|", both_sides},
    Symbol{Tok::r_pipe_square, "|]", both_sides},
    Symbol{Tok::scope, "::", after},
    Symbol{Tok::l_paren, "(", after},
    Symbol{Tok::r_paren, ")", before},
    Symbol{Tok::l_brace, "{", after},
    Symbol{Tok::r_brace, "}", before},
    Symbol{Tok::l_square, "[", both_sides},
    Symbol{Tok::r_square, "]", both_sides},
    Symbol{Tok::semicolon, ";", both_sides},
    Symbol{Tok::ampersand, "&", both_sides},
    Symbol{Tok::less, "<", after},
    Symbol{Tok::greater, ">", before},
    Symbol{Tok::pipe, "|", both_sides},
    Symbol{Tok::comma, ",", both_sides},
    Symbol{Tok::dot, ".", both_sides},
    Symbol{Tok::question, "?", both_sides},
    Symbol{Tok::exclamation, "!", both_sides},
    Symbol{Tok::dollar, "$", both_sides},
    Symbol{Tok::colon, ":", both_sides},
    Symbol{Tok::at, "@", both_sides},
    Symbol{Tok::equals, "=", both_sides},
    Symbol{Tok::backslash, "\\", both_sides},
    Symbol{Tok::plus, "+", both_sides},
    Symbol{Tok::minus, "-", after},
    Symbol{Tok::times, "*", both_sides},
    Symbol{Tok::divide, "/", both_sides},
    Symbol{Tok::modulus, "%", both_sides},
    Symbol{Tok::concat, "^", both_sides},
    Symbol{Tok::hash, "#", after},
    Symbol{Tok::underscore, "_", both_sides},
};

constexpr std::array words{
    Symbol{Tok::kw_false, "false", before},      Symbol{Tok::kw_true, "true", before},
    Symbol{Tok::kw_and, "and", both_sides},      Symbol{Tok::kw_or, "or", both_sides},
    Symbol{Tok::kw_not, "not", both_sides},      Symbol{Tok::kw_if, "if", both_sides},
    Symbol{Tok::kw_then, "then", both_sides},    Symbol{Tok::kw_else, "else", both_sides},
    Symbol{Tok::kw_let, "let", both_sides},      Symbol{Tok::kw_within, "within", both_sides},
    Symbol{Tok::kw_channel, "channel", after},   Symbol{Tok::kw_assert, "assert", after},
    Symbol{Tok::kw_datatype, "datatype", after}, Symbol{Tok::kw_subtype, "subtype", after},
    Symbol{Tok::kw_external, "external", after}, Symbol{Tok::kw_transparent, "transparent", after},
    Symbol{Tok::kw_nametype, "nametype", after}, Symbol{Tok::kw_module, "module", after},
    Symbol{Tok::kw_exports, "exports", plain},   Symbol{Tok::kw_endmodule, "endmodule", plain},
    Symbol{Tok::kw_instance, "instance", after}, Symbol{Tok::kw_timed, "Timed", after},
};

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

class Lexer : diagnostics::Scanner {
public:
    Lexer(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics& diagnostics)
        : Scanner(text, source), diagnostics_(diagnostics) {}

    std::vector<Token> run() {
        while (skip_space(), !at_end()) {
            diagnostics_.poll();
            read_token();
        }
        const auto place = static_cast<std::uint32_t>(line_end_ ? line_end_at_ : at_);
        tokens_.push_back({Tok::newline, {source_, place, place}, {}, 0});
        line_end_ = false;
        emit_token(Tok::end, at_, plain);
        return std::move(tokens_);
    }

private:
    void skip_space() {
        blank_before_ = false;
        while (!at_end()) {
            const char c = peek();
            if (c == '\n') {
                if (!line_end_) line_end_at_ = at_;
                line_end_ = true;
                blank_before_ = true;
                ++at_;
            } else if (is_blank(c)) {
                blank_before_ = true;
                ++at_;
            } else if (looking_at("--")) {
                arrow_comment();
                at_ = line_end();
            } else if (looking_at("{-")) {
                line_end_ = false;  // in FDR's lexer, the line ends before a block comment belong to it
                block_comment();
            } else {
                return;
            }
        }
    }

    /// Reports `a --> P`. The comment begins after other text on its line, so the user probably meant an arrow.
    void arrow_comment() {
        if (!looking_at("-->") || line_end_ || tokens_.empty() || tokens_.back().kind == Tok::newline) return;
        const Span place{source_, static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(at_ + 3)};
        diagnostics_.report(rules::arrow_comment, place).fixes.push_back({place, "->", "write"});
    }

    void block_comment() {
        const std::size_t from = at_;
        std::size_t depth = 0;
        do {
            if (at_end()) return open_comment(from);
            if (accept("{-"))
                ++depth;
            else if (accept("-}"))
                --depth;
            else
                ++at_;
        } while (depth > 0);
    }

    // Reports a block comment without an end. If `{-` probably begins a set whose first element is negative, emits `{`
    // instead, so that the parser still sees the rest of the script.
    void open_comment(std::size_t from) {
        const Span place{source_, static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(from + 2)};
        diagnostics::Diagnostic& finding = diagnostics_.report(rules::open_comment, place);
        const std::size_t line = std::min(text_.find('\n', from), text_.size());
        const std::size_t close = text_.find('}', from);
        if (from + 2 >= text_.size() || !is_digit(text_[from + 2]) || close >= line) return;
        finding.notes.push_back(
            {place, "`{-` begins a comment: a set that begins with a negative number is written `{ " +
                        std::string(text_.substr(from + 1, close - from)) + "`, with a blank"});
        at_ = from + 1;
        emit_token(Tok::l_brace, from, after);
    }

    void emit_token(Tok kind, std::size_t from, LineBreaks layout, std::int64_t number = 0) {
        if (line_end_ && kind != Tok::newline && (layout & before) == 0 && !soaking_) {
            const auto place = static_cast<std::uint32_t>(line_end_at_);
            tokens_.push_back({Tok::newline, {source_, place, place}, {}, 0});
        }
        line_end_ = false;
        soaking_ = (layout & after) != 0;
        tokens_.push_back({kind, span_from(from), text_from(from), number});
    }

    void read_token() {
        const char c = peek();
        if ((diagnostics::begins_name(c) && c != '_') || foreign_letter(rest()) > 0) {
            read_word();
        } else if (is_digit(c)) {
            read_integer();
        } else if (c == '"') {
            read_string();
        } else if (c == '\'') {
            read_character();
        } else if (looking_at(":[")) {
            read_property();
        } else if (!read_special() && !read_symbol()) {
            report_bad_character();
        }
    }

    void read_word() {
        const std::size_t from = at_;
        bool foreign = false;
        for (skip_name(); const std::size_t length = foreign_letter(rest()); skip_name()) {
            foreign = true;
            at_ += length;
        }
        while (peek() == '\'') ++at_;
        if (foreign) foreign_name(from);
        const std::string_view text = text_from(from);
        const bool first = starts_declaration();
        if (text == "print" && peek() == ' ' && first) return read_print_line(from);
        if (text == "include" && first) return read_include(from);
        const auto* found = std::ranges::find(words, text, &Symbol::text);
        if (found != words.end()) return emit_token(found->kind, from, found->layout);
        emit_token(Tok::identifier, from, plain);
    }

    // Reports a name with letters outside ASCII, once for each name. Then accepts it as a name.
    void foreign_name(std::size_t from) {
        const std::string name(text_from(from));
        if (!foreign_names_.insert(name).second) return;
        diagnostics::Diagnostic& finding = diagnostics_.report(rules::foreign_name, span_from(from), {name});
        if (const std::string plain = in_plain_letters(name); !plain.empty())
            finding.notes.push_back({span_from(from), "write '" + plain + "'"});
    }

    // Returns true if the next token is the first token of a declaration.
    [[nodiscard]] bool starts_declaration() const {
        if (tokens_.empty() || tokens_.back().kind == Tok::newline) return true;
        if (line_end_ && !soaking_) return true;
        return tokens_.back().kind == Tok::l_brace && line_end_;
    }

    // Reads the rest of the line after `print`. The statement always ends with the line, even if an expression could
    // continue on the next one.
    void read_print_line(std::size_t from) {
        emit_token(Tok::print, from, after);
        const std::string_view whole = text_;
        text_ = text_.substr(0, line_end());
        while (skip_space(), !at_end()) read_token();
        text_ = whole;
        emit_token(Tok::newline, at_, plain);
    }

    void read_include(std::size_t from) {
        const std::size_t line = line_end();
        const std::size_t open = text_.find_first_not_of(" \t\r", at_);
        const std::size_t close =
            open < line && text_[open] == '"' ? text_.find('"', open + 1) : std::string_view::npos;
        if (close >= line) {
            at_ = line;
            diagnostics_.report(rules::bad_include, span_from(from));
            return;
        }
        at_ = close;
        emit_token(Tok::include, open + 1, plain);
        at_ = close + 1;
        emit_token(Tok::newline, at_, plain);
    }

    void read_integer() {
        const std::size_t from = at_;
        std::int64_t value = 0;
        bool fits = true;
        for (; is_digit(peek()); ++at_) {
            const std::int64_t digit = peek() - '0';
            fits = fits && value <= (std::numeric_limits<std::int64_t>::max() - digit) / 10;
            if (fits) value = value * 10 + digit;
        }
        if (!fits) {
            const std::string digits(text_from(from).substr(0, 40));
            diagnostics_.report(rules::big_number, span_from(from), {digits});
        }
        emit_token(Tok::integer, from, before, value);
    }

    void read_string() {
        const std::size_t from = at_++;
        while (!at_end() && peek() != '"' && peek() != '\n') at_ += peek() == '\\' && peek(1) != '\n' ? 2U : 1U;
        at_ = std::min(at_, text_.size());
        if (accept("\""))
            emit_token(Tok::string, from, before);
        else
            diagnostics_.report(rules::open_literal, span_from(from), {"string"});
    }

    void read_character() {
        const std::size_t from = at_++;
        char value = peek();
        ++at_;
        if (value == '\\') {
            value = peek();
            ++at_;
            if (value == 'n')
                value = '\n';
            else if (value == 't')
                value = '\t';
            else if (value == 'r')
                value = '\r';
        }
        at_ = std::min(at_, text_.size());
        if (accept("'"))
            emit_token(Tok::character, from, before, static_cast<unsigned char>(value));
        else
            diagnostics_.report(rules::open_literal, span_from(from), {"character"});
    }

    // Reads `:[words [M]]` or `:[words]:` as one token. The parser parses its contents.
    void read_property() {
        const std::size_t from = at_;
        const std::size_t line = line_end();
        const std::size_t inner = text_.find('[', at_ + 2);
        std::size_t close = text_.find(']', at_);
        if (inner < close && close < line) close = text_.find(']', close + 1);
        if (close >= line) {
            at_ = std::min(line, from + 2);
            diagnostics_.report(rules::bad_property, span_from(from), {std::string(text_.substr(from, line - from))});
            at_ = line;
            return;
        }
        at_ = close + 1;
        accept(":");  // FDR's lexer accepts `]:` for `]` after every property
        const std::string_view inside = text_.substr(from + 2, close - from - 2);
        const bool takes_more =
            inside.find("trace") != std::string_view::npos || inside.find("priority") != std::string_view::npos;
        emit_token(Tok::property, from, takes_more ? both_sides : before);
    }

    // Reads tokens that depend on the characters around them.
    bool read_special() {
        const std::size_t from = at_;
        if (looking_at("(|") && (is_blank(peek(2)) || peek(2) == '\n')) {
            at_ += 2;
            emit_token(Tok::l_map, from, after);
            return true;
        }
        if (peek() == '<' && empty_sequence()) {
            emit_token(Tok::empty_sequence, from, plain);
            return true;
        }
        if (looking_at("::") && (blank_before_ || is_blank(peek(2)))) {
            at_ += 2;
            emit_token(Tok::of_type, from, both_sides);
            return true;
        }
        return false;
    }

    bool empty_sequence() {
        std::size_t next = at_ + 1;
        while (next < text_.size() && (is_blank(text_[next]) || text_[next] == '\n')) ++next;
        if (next >= text_.size() || text_[next] != '>') return false;
        at_ = next + 1;
        return true;
    }

    bool read_symbol() {
        const std::size_t from = at_;
        const Symbol* const found = accept_first(symbols, &Symbol::text);
        if (found == nullptr) return false;
        emit_token(found->kind, from, found->layout);
        return true;
    }

    // Emits the token that the user probably meant, if one is known, so that the parser can continue with the
    // declaration. The caller has reported the error.
    void read_as(std::string_view written, std::size_t from) {
        if (const auto* word = std::ranges::find(words, written, &Symbol::text); word != words.end())
            return emit_token(word->kind, from, word->layout);
        const auto* symbol = std::ranges::find(symbols, written, &Symbol::text);
        if (symbol != symbols.end()) emit_token(symbol->kind, from, symbol->layout);
    }

    void report_bad_character() {
        const std::size_t from = at_;
        const std::size_t length = diagnostics::utf8_length(rest());
        at_ += std::max<std::size_t>(length, 1);
        const auto code = static_cast<unsigned char>(text_[from]);
        const std::string_view character = text_from(from);
        constexpr std::string_view digits = "0123456789abcdef";
        const std::string hex{'0', 'x', digits[code >> 4U], digits[code & 15U]};
        const bool printable = length > 1 || (code >= 0x20U && code < 0x7fU);
        diagnostics::Diagnostic& finding =
            diagnostics_.report(rules::bad_character, span_from(from),
                                {printable ? "'" + std::string(character) + "'" : "the byte " + hex});
        if (const std::string_view written = written_for(character); !written.empty()) {
            finding.notes.push_back({span_from(from), "write `" + std::string(written) + "`"});
            return read_as(written, from);
        }
        while (looking_at(character)) at_ += character.size();
        if (code < 0x80U || length > 0) return;
        while (static_cast<unsigned char>(peek()) >= 0x80U && diagnostics::utf8_length(rest()) == 0) ++at_;
    }

    diagnostics::Diagnostics& diagnostics_;
    bool line_end_ = false;        // whether a line end was skipped after the last token
    std::size_t line_end_at_ = 0;  // position of the first skipped line end
    bool soaking_ = true;          // true if line ends after the last token have no effect
    bool blank_before_ = false;    // whether white space precedes the token
    std::vector<Token> tokens_;
    std::set<std::string> foreign_names_;  // names that have been reported
};

}  // namespace

std::vector<Token> lex(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics& diagnostics) {
    return Lexer(text, source, diagnostics).run();
}

bool continues_name(char c) {
    return diagnostics::continues_name(c) || c == '\'';
}

std::string_view spelling(Tok kind) {
    switch (kind) {
        case Tok::end:
            return "the end of the file";
        case Tok::newline:
            return "the end of the line";
        case Tok::bad:
            return "a broken token";
        case Tok::identifier:
            return "a name";
        case Tok::integer:
            return "a number";
        case Tok::character:
            return "a character";
        case Tok::string:
            return "a string";
        case Tok::property:
            return "a property";
        case Tok::print:
            return "print";
        case Tok::include:
            return "include";
        case Tok::l_map:
            return "(|";
        case Tok::of_type:
            return "::";
        case Tok::empty_sequence:
            return "<>";
        default:
            break;
    }
    if (const auto* word = std::ranges::find(words, kind, &Symbol::kind); word != words.end()) return word->text;
    const auto* symbol = std::ranges::find(symbols, kind, &Symbol::kind);
    return symbol != symbols.end() ? symbol->text : "?";
}

}  // namespace robochart::cspm
