// SPDX-License-Identifier: Apache-2.0
// Compares the tokens around an error with the rows of a table.
#include "base/advice/advice.hpp"

#include <algorithm>
#include <vector>

namespace robochart::diagnostics {
namespace {

bool matches_word(std::string_view pattern, const AdviceWord& word) {
    if (pattern == "NAME") return word.kind == WordKind::name;
    if (pattern == "NUMBER") return word.kind == WordKind::number;
    if (pattern == "TEXT") return word.kind == WordKind::text;
    if (pattern == "END") return word.kind == WordKind::end;
    return word.kind != WordKind::text && word.kind != WordKind::end && word.text == pattern;
}

std::vector<std::string_view> words_of(std::string_view pattern) {
    std::vector<std::string_view> words;
    while (!pattern.empty()) {
        const std::size_t blank = std::min(pattern.find(' '), pattern.size());
        words.push_back(pattern.substr(0, blank));
        pattern.remove_prefix(std::min(blank + 1, pattern.size()));
    }
    return words;
}

}  // namespace

std::string_view advice_on(std::span<const Advice> rows, std::string_view expected,
                           const std::function<AdviceWord(std::ptrdiff_t)>& word) {
    for (const Advice& row : rows) {
        if (!row.expected.empty() && row.expected != expected) continue;
        const std::vector<std::string_view> words = words_of(row.words);
        const auto place = std::ranges::find(words, "@");
        const std::ptrdiff_t before = place - words.begin();
        bool all = true;
        for (auto position = words.begin(); position != words.end() && all; ++position) {
            const std::ptrdiff_t at = position - words.begin();
            if (position != place) all = matches_word(*position, word(at < before ? at - before : at - before - 1));
        }
        if (all) return row.advice;
    }
    return {};
}

}  // namespace robochart::diagnostics
