// SPDX-License-Identifier: Apache-2.0
// See layout.hpp.
#include "claims/syntax/layout.hpp"

#include <set>
#include <string_view>
#include <vector>

#include "base/words/item_layout.hpp"
#include "claims/syntax/reader.hpp"

namespace robochart::claims {
namespace {

using words::is_one_of;

/// True if a `-` after this token is a sign.
bool comes_before_sign(const Token& token) {
    if (token.kind == Tok::number || is_one_of(token, {")"})) return false;
    return token.kind == Tok::symbol ||
           is_one_of(token, {"and", "or", "not", "with", "within", "least", "every", "any", "to"});
}

bool no_blank_between(const Token* before, const Token& left, const Token& right) {
    if (is_one_of(left, {"(", "[", "::", "^"}) || is_one_of(right, {")", "]", ",", "::"})) return true;
    if (right.text == "(" && left.kind == Tok::word) return !is_one_of(left, {"and", "or", "not", "with", "but"});
    return left.text == "-" && left.kind == Tok::symbol && (before == nullptr || comes_before_sign(*before));
}

/// The layout of claims files. An item is an import, the unit, a claim or an order.
class Layout final : public words::ItemLayout {
public:
    Layout(std::string_view text, const std::vector<Token>& tokens, const ClaimFile& file) : ItemLayout(text, tokens) {
        for (const Claim& claim : file.claims) begins_.insert(claim.span.begin);
        for (const Order& order : file.orders) begins_.insert(order.span.begin);
        for (const Duration& unit : file.units) begins_.insert(unit.span.begin);
    }

private:
    [[nodiscard]] bool word_begins_item(std::size_t at) const override {
        const Token& token = tokens_[at];
        if (token.kind != Tok::word) return false;
        if (begins_.contains(token.span.begin)) return true;
        const bool in_head = begins_.empty() || token.span.begin < *begins_.begin();
        return in_head && (token.text == "import" || (token.text == "package" && at == 0));
    }
    [[nodiscard]] std::string item_text(std::size_t from, std::size_t to) override {
        std::string result;
        for (std::size_t i = from; i < to; ++i) {
            if (i > from) result += between(i);
            result += words::shown_text(tokens_[i]);
        }
        return result;
    }
    /// Returns the text between two tokens. After a comment to the end of a line, the item continues on the next line.
    [[nodiscard]] std::string_view between(std::size_t at) const {
        const Token& left = tokens_[at - 1];
        if (left.kind == Tok::comment && left.text.starts_with("//")) return "\n    ";
        const Token* const before = at >= 2 ? &tokens_[at - 2] : nullptr;
        return no_blank_between(before, left, tokens_[at]) ? "" : " ";
    }

    std::set<std::uint32_t> begins_;  ///< starts of claims and of the unit
};

}  // namespace

std::string one_line(std::span<const Token> tokens) {
    std::string result;
    const Token* before = nullptr;
    const Token* left = nullptr;
    for (const Token& token : tokens) {
        if (token.kind == Tok::comment || token.kind == Tok::end) continue;
        if (left != nullptr && !no_blank_between(before, *left, token)) result += ' ';
        result += token.text;
        before = left;
        left = &token;
    }
    return result;
}

std::optional<std::string> format(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                                  diagnostics::Diagnostics& diagnostics) {
    diagnostics::Diagnostics ignored;
    const std::string_view text = sources.source_text(source);
    return words::format_items(
        text, diagnostics, [&](diagnostics::Diagnostics& found) { return read(sources, source, found); },
        [&](std::string_view of) { return lex(of, source, ignored, true); },
        [&](const std::vector<Token>& tokens, const ClaimFile& file) { return Layout(text, tokens, file).write(); });
}

}  // namespace robochart::claims
