// SPDX-License-Identifier: Apache-2.0
#include "driver/settings/claim_selection.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "base/diagnostics/spelling.hpp"

namespace robochart::driver {
namespace {

std::optional<std::size_t> number_in(std::string_view text) {
    std::size_t number = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

/// Parses "3..5", and "3" as 3..3.
std::optional<std::pair<std::size_t, std::size_t>> numbers_in(std::string_view word) {
    const std::size_t dots = word.find("..");
    const auto first = number_in(word.substr(0, dots));
    const auto last = dots == std::string_view::npos ? first : number_in(word.substr(dots + 2));
    if (!first || !last) return std::nullopt;
    return std::pair(*first, *last);
}

bool is_pattern(std::string_view word) {
    return word.find_first_of("*?") != std::string_view::npos;
}

/// True if the whole text matches the pattern.
bool matches_pattern(std::string_view text, std::string_view pattern) {
    std::size_t at = 0, t = 0;
    std::size_t star = std::string_view::npos, after = 0;  // index of the last star, and end of the text that it covers
    while (t < text.size()) {
        if (at < pattern.size() && pattern[at] == '*') {
            star = at++;
            after = t;
        } else if (at < pattern.size() && (pattern[at] == '?' || pattern[at] == text[t])) {
            ++at;
            ++t;
        } else if (star != std::string_view::npos) {
            at = star + 1;
            t = ++after;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', at) == std::string_view::npos;
}

/// Returns the indices of the names that a word selects.
std::vector<std::size_t> places_of(std::string_view word, const std::vector<std::string>& names) {
    std::vector<std::size_t> places;
    const auto add_all = [&](const auto& meant) {
        for (std::size_t i = 0; i < names.size(); ++i)
            if (meant(i)) places.push_back(i);
    };
    add_all([&](std::size_t i) { return names[i] == word; });
    if (!places.empty()) return places;
    if (const auto numbers = numbers_in(word))
        add_all([&](std::size_t i) { return numbers->first <= i + 1 && i + 1 <= numbers->second; });
    else if (is_pattern(word))
        add_all([&](std::size_t i) { return matches_pattern(names[i], word); });
    return places;
}

}  // namespace

ClaimSelection select_claims(const std::vector<std::string>& words, const std::vector<std::string>& names) {
    ClaimSelection selection;
    std::vector<bool> chosen(names.size(), words.empty());
    for (const std::string& word : words) {
        const std::vector<std::size_t> places = places_of(word, names);
        if (places.empty()) selection.lost.push_back(word);
        for (const std::size_t place : places) chosen[place] = true;
    }
    for (std::size_t i = 0; i < names.size(); ++i)
        if (chosen[i]) selection.chosen.push_back(i);
    return selection;
}

bool selects_by_number(std::string_view word) {
    return numbers_in(word).has_value();
}

std::string why_lost(std::string_view word, const std::vector<std::string>& names, std::string_view subject) {
    if (names.empty()) return fmt::format("{} has no assertions", subject);
    if (numbers_in(word))
        return fmt::format("{} has {} assertion{}", subject, names.size(), names.size() == 1 ? "" : "s");
    if (is_pattern(word)) return fmt::format("{} has no assertion that fits this pattern", subject);
    std::string text = fmt::format("{} has no assertion of this name", subject);
    if (const std::string meant = diagnostics::nearest_spelling(word, names); !meant.empty())
        return text + fmt::format("; did you mean '{}'?", meant);
    constexpr std::size_t few = 8;
    return names.size() <= few ? text + fmt::format("; there are {}", fmt::join(names, ", ")) : text;
}

}  // namespace robochart::driver
