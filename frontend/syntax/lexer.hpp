// SPDX-License-Identifier: Apache-2.0
// Splits RoboChart and assertion text into tokens, after Xtext's common terminals (ID, INT, STRING, comments) and
// RoboChart.xtext.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/source.hpp"
#include "frontend/syntax/dialect.hpp"

namespace robochart::frontend {

enum class TokenKind : std::uint8_t {
    end,         ///< after the last token
    identifier,  ///< a name, or a word that is reserved only in some places
    keyword,     ///< a reserved word of the dialect
    integer,
    real,
    string,    ///< including its quotes
    symbol,    ///< operator or bracket, longest match; `Set(` and `Seq(` are also symbols
    csp_code,  ///< `csp-begin … csp-end`, whole (assertion files)
};

/// One token. `text` is a view of the source. The text of an escaped name (`^end`) does not contain the `^`.
struct Token {
    TokenKind kind = TokenKind::end;
    bool escaped = false;  ///< written with `^`
    bool first_on_line = false;
    std::string_view text;
    diagnostics::Span span;

    [[nodiscard]] bool is_word(std::string_view word) const {
        return (kind == TokenKind::keyword || kind == TokenKind::symbol) && text == word;
    }
};

/// The tokens of one text, packed into twelve bytes each. A Token is made on request. The source text must outlive the
/// object.
class TokenList {
public:
    TokenList() = default;
    TokenList(std::string_view text, diagnostics::SourceId source) : text_(text), source_(source) {}

    [[nodiscard]] std::size_t size() const { return items_.size(); }
    [[nodiscard]] bool empty() const { return items_.empty(); }
    [[nodiscard]] Token operator[](std::size_t index) const;
    [[nodiscard]] Token token_at(std::size_t index) const { return (*this)[std::min(index, size() - 1)]; }
    [[nodiscard]] Token last_token() const { return (*this)[size() - 1]; }
    /// Returns the kind, without reading the text.
    [[nodiscard]] TokenKind kind(std::size_t index) const { return items_[index].kind; }

    void add(TokenKind kind, diagnostics::Span span, bool escaped, bool first_on_line);
    /// Replaces the token by a reserved word or symbol.
    void correct_token(std::size_t index, TokenKind kind, std::string_view word);
    /// Removes the first character of the token (`<{` becomes `{`, `^b` becomes `b`).
    void drop_first_character(std::size_t index);

    class Iterator {
    public:
        using iterator_category = std::input_iterator_tag;
        using difference_type = std::ptrdiff_t;
        using value_type = Token;
        using pointer = const Token*;
        using reference = Token;

        Iterator(const TokenList& list, std::size_t at) : list_(&list), at_(at) {}
        Token operator*() const { return (*list_)[at_]; }
        Iterator& operator++() {
            ++at_;
            return *this;
        }
        Iterator operator++(int) { return {*list_, at_++}; }
        friend bool operator==(const Iterator&, const Iterator&) = default;

    private:
        const TokenList* list_;
        std::size_t at_;
    };
    [[nodiscard]] Iterator begin() const { return {*this, 0}; }
    [[nodiscard]] Iterator end() const { return {*this, size()}; }

private:
    struct Packed {
        std::uint32_t begin;
        std::uint32_t end;
        TokenKind kind;
        bool escaped : 1;
        bool first_on_line : 1;
        std::uint16_t word;  ///< the index, from 1, of a corrected token in the table of words
    };
    static_assert(sizeof(Packed) == 12);

    std::string_view text_;
    diagnostics::SourceId source_ = diagnostics::SourceId::none;
    std::deque<Packed> items_;  ///< a deque, because it never copies a long text to grow
};

/// The tokens of a text, and the places of its comments for the formatter. The last token is `end`.
struct TokenStream {
    TokenList tokens;
    std::vector<diagnostics::Span> comments;
};

/// The largest number of tokens in a file. A longer file was not written by hand and is rejected.
inline constexpr std::size_t max_tokens = 16'000'000;

/// Splits a text into tokens of the dialect of its path. Characters that belong to no token are reported and skipped.
[[nodiscard]] TokenStream tokenize(const diagnostics::SourceManager&, diagnostics::SourceId, bool is_assertions,
                                   diagnostics::Diagnostics&);

/// True if this is a reserved word of RoboChart.
[[nodiscard]] bool is_reserved(std::string_view word);
/// Returns the reserved words of RoboChart, sorted.
[[nodiscard]] const std::vector<std::string_view>& reserved_words();
/// Returns the words that RoboSim reserves in addition, sorted.
[[nodiscard]] std::span<const std::string_view> robosim_words();
/// True if the word is reserved in the dialect.
[[nodiscard]] bool is_reserved(std::string_view word, Dialect dialect);
/// Returns the words that assertion text reserves in some places, in addition to the reserved words (Assertions.xtext),
/// sorted.
[[nodiscard]] std::span<const std::string_view> assertion_words();
/// Returns the operators and brackets, longest first. Those at the end are used only in probabilistic assertions.
[[nodiscard]] std::span<const std::string_view> symbol_words();

/// Shortens a piece of source text to one line of at most 40 characters, for a message.
[[nodiscard]] std::string shorten_token(std::string_view text);

}  // namespace robochart::frontend
