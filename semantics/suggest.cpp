// Edit distance (Levenshtein) between short names.
#include "semantics/suggest.hpp"

#include <algorithm>
#include <numeric>

namespace robochart::ir {
namespace {

constexpr std::size_t longest_name = 200;  // longer names get no suggestion: the distance is quadratic

std::size_t distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, change});
        }
    }
    return row[b.size()];
}

}  // namespace

std::string did_you_mean(const std::string& name, const std::vector<std::string>& candidates) {
    std::string best;
    std::size_t fewest = name.size() / 3 + 1;
    if (name.size() > longest_name) return "";
    for (const auto& candidate : candidates) {
        if (candidate.size() > longest_name) continue;
        const std::size_t edits = distance(name, candidate);
        if (edits < fewest || (edits == fewest && candidate < best)) {
            best = candidate;
            fewest = edits;
        }
    }
    return best.empty() ? "" : "; did you mean '" + best + "'?";
}

}  // namespace robochart::ir
