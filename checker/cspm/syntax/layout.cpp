// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/syntax/layout.hpp"

#include <algorithm>

namespace robochart::cspm {

namespace {

constexpr std::size_t never_fits = 1U << 30U;
constexpr std::size_t indent_step = 4;

bool would_join(char before, char after) {
    return (before == '{' && (after == '-' || after == '|')) || (before == '<' && (after == '-' || after == '>')) ||
           (before == '(' && after == '|') || (before == '-' && (after == '-' || after == '>'));
}

}  // namespace

void Layout::add_text(std::string_view piece) {
    if (piece.empty()) return;
    std::string text = would_join(last_, piece.front()) ? " " : "";
    text += piece;
    last_ = text.back();
    pieces_.push_back({Kind::text, std::move(text)});
}

void Layout::add_piece(Kind kind, std::string text) {
    last_ = '\0';
    pieces_.push_back({kind, std::move(text)});
}

// Returns the width of each group on one line, or never_fits if it contains a hard line end. Indexed by `open`.
std::vector<std::size_t> Layout::group_widths() const {
    std::vector<std::size_t> result(pieces_.size(), 0);
    std::vector<std::size_t> starts;
    std::size_t total = 0;
    std::vector<std::size_t> totals;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        switch (pieces_[i].kind) {
            case Kind::open:
                starts.push_back(i);
                totals.push_back(total);
                break;
            case Kind::close:
                result[starts.back()] = total - totals.back();
                starts.pop_back();
                totals.pop_back();
                break;
            case Kind::hard_line:
                total += never_fits;
                break;
            case Kind::text:
            case Kind::line:
            case Kind::indent:
            case Kind::outdent:
                total += pieces_[i].text.size();
                break;
        }
    }
    return result;
}

std::string Layout::render() const {
    const std::vector<std::size_t> widths = group_widths();
    std::string result;
    std::size_t column = 0;
    std::size_t indent = 0;
    std::vector<bool> broken{true};
    const auto end_line = [&] {
        while (!result.empty() && result.back() == ' ') result.pop_back();
        result += '\n';
        result.append(indent, ' ');
        column = indent;
    };
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const Piece& piece = pieces_[i];
        switch (piece.kind) {
            case Kind::open:
                broken.push_back(column + widths[i] > width_);
                break;
            case Kind::close:
                broken.pop_back();
                break;
            case Kind::indent:
                indent += indent_step;
                break;
            case Kind::outdent:
                indent -= indent_step;
                break;
            case Kind::hard_line:
                end_line();
                break;
            case Kind::line:
                if (broken.back()) {
                    end_line();
                    break;
                }
                [[fallthrough]];
            case Kind::text:
                result += piece.text;
                column += piece.text.size();
                break;
        }
    }
    while (!result.empty() && result.back() == ' ') result.pop_back();
    return result;
}

}  // namespace robochart::cspm
