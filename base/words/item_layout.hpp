// SPDX-License-Identifier: Apache-2.0
// Writes the standard layout of texts that consist of items: claims, and rules in SLEEC. It only changes blanks and
// line ends.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/words/words.hpp"

namespace robochart::words {

/// Returns true for a word or a symbol with one of these texts.
[[nodiscard]] bool is_one_of(const Token& token, std::initializer_list<std::string_view> texts);
/// Returns the text of a token. A comment is returned without trailing blanks.
[[nodiscard]] std::string_view shown_text(const Token& token);

/// Lays out one text, item by item. A comment on a separate line before an item is an item, too.
class ItemLayout {
public:
    /// `tokens`: the tokens of the text, including comments.
    ItemLayout(std::string_view text, const std::vector<Token>& tokens) : text_(text), tokens_(tokens) {}
    ItemLayout(const ItemLayout&) = delete;
    ItemLayout& operator=(const ItemLayout&) = delete;
    virtual ~ItemLayout() = default;

    std::string write();

protected:
    [[nodiscard]] virtual bool word_begins_item(std::size_t at) const = 0;
    /// Returns the lines of an item, without the last line end.
    [[nodiscard]] virtual std::string item_text(std::size_t from, std::size_t to) = 0;

    /// Returns true if the token is the first of its line.
    [[nodiscard]] bool own_line(std::size_t at) const;

    std::string_view text_;
    const std::vector<Token>& tokens_;

private:
    [[nodiscard]] std::string_view text_before(std::size_t at) const;
};

/// Throws std::logic_error if the texts of the tokens differ.
void require_same_words(const std::vector<Token>& written, const std::vector<Token>& tokens);

/// Formats a text. `read` reads it and reports errors. `lex` returns its tokens, including comments. Returns no value
/// if the text has syntax errors, which are reported. Throws std::logic_error if a token or comment would be lost,
/// which is an internal error.
template <class Read, class Lex, class Layout>
[[nodiscard]] std::optional<std::string> format_items(std::string_view text, diagnostics::Diagnostics& diagnostics,
                                                      const Read& read, const Lex& lex, const Layout& layout) {
    diagnostics::Diagnostics found;
    found.set_budget(diagnostics.budget());
    const auto file = read(found);
    if (!found.ok()) {
        diagnostics.add(found);
        return std::nullopt;
    }
    const std::vector<Token> tokens = lex(text);
    std::string result = layout(tokens, file);
    require_same_words(lex(result), tokens);
    return result;
}
}  // namespace robochart::words
