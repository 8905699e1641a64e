// SPDX-License-Identifier: Apache-2.0
// Divides a text into items and formats them.
#include "base/words/item_layout.hpp"

#include <algorithm>
#include <stdexcept>

namespace robochart::words {

bool is_one_of(const Token& token, std::initializer_list<std::string_view> texts) {
    return token.kind != Tok::comment && std::ranges::find(texts, token.text) != texts.end();
}

std::string_view shown_text(const Token& token) {
    if (token.kind != Tok::comment) return token.text;
    return token.text.substr(0, token.text.find_last_not_of(" \t\r") + 1);
}

std::string ItemLayout::write() {
    std::vector<bool> begins_item(tokens_.size(), true);
    for (std::size_t i = tokens_.size() - 1; i-- > 0;)
        begins_item[i] = tokens_[i].kind == Tok::comment ? own_line(i) && begins_item[i + 1] : word_begins_item(i);
    std::string result;
    for (std::size_t at = 0, end = 0; tokens_[at].kind != Tok::end; at = end) {
        end = at + 1;
        while (!begins_item[end]) ++end;
        if (at > 0 && std::ranges::count(text_before(at), '\n') > 1) result += '\n';
        result += item_text(at, end) + '\n';
    }
    return result;
}

std::string_view ItemLayout::text_before(std::size_t at) const {
    const std::size_t from = at == 0 ? 0 : tokens_[at - 1].span.end;
    return text_.substr(from, tokens_[at].span.begin - from);
}

bool ItemLayout::own_line(std::size_t at) const {
    return at == 0 || text_before(at).find('\n') != std::string_view::npos;
}

void require_same_words(const std::vector<Token>& written, const std::vector<Token>& tokens) {
    if (!std::ranges::equal(written, tokens, {}, shown_text, shown_text))
        throw std::logic_error("formatting has lost a word");
}

}  // namespace robochart::words
