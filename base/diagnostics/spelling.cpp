// SPDX-License-Identifier: Apache-2.0
// Compares words by optimal string alignment, an edit distance with Damerau's four edits in which no part of a word is
// edited twice.
#include "base/diagnostics/spelling.hpp"

#include <algorithm>
#include <numeric>

#include "base/diagnostics/fixes.hpp"

namespace robochart::diagnostics {

namespace {

/// Returns the edit distance, in which the transposition of two neighbours is one edit (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::iota(last.begin(), last.end(), 0U);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::vector<std::size_t> row(b.size() + 1, i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = std::move(last);
        last = std::move(row);
    }
    return last.back();
}

}  // namespace

std::string nearest_spelling(std::string_view name, const std::vector<std::string>& candidates) {
    if (name.size() > 100) return {};
    std::size_t best = std::max<std::size_t>(1, name.size() / 3) + 1;
    std::string result;
    for (const std::string& candidate : candidates) {
        const std::size_t difference =
            candidate.size() > name.size() ? candidate.size() - name.size() : name.size() - candidate.size();
        if (candidate == name || difference >= best) continue;
        const std::size_t d = edit_distance(name, candidate);
        if (d < best && d < name.size()) {
            best = d;
            result = candidate;
        }
    }
    return result;
}

bool is_certain(std::string_view name, std::string_view meant, const std::vector<std::string>& candidates) {
    const std::size_t best = edit_distance(name, meant);
    if (meant.empty() || best > 2 || best * 2 >= name.size()) return false;
    return std::ranges::none_of(candidates, [&](const std::string& other) {
        return other != meant && other.size() <= name.size() + best && edit_distance(name, other) <= best;
    });
}

std::string suggestion_verb(bool certain) {
    return certain ? "write" : std::string(suggestion_title);
}

}  // namespace robochart::diagnostics
