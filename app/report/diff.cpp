// SPDX-License-Identifier: Apache-2.0
// See diff.hpp. The greedy algorithm of Myers ("An O(ND) difference algorithm", 1986) finds the shortest edit between
// the common prefix and the common suffix of the texts.
#include "app/report/diff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace robochart::app {
namespace {

using Lines = std::vector<std::string_view>;

Lines lines_of(std::string_view text) {
    Lines lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return lines;
}

/// Consecutive lines that are unchanged (` `), removed (`-`) or added (`+`).
struct Edit {
    char kind;
    std::size_t before;  ///< line of the old text, from 0
    std::size_t after;   ///< line of the new text
};

/// The result of one step of the search: the furthest old line reached on each diagonal.
using Frontier = std::vector<std::ptrdiff_t>;

class Search {
public:
    Search(const Lines& before, const Lines& after) : before_(before), after_(after) {}

    /// Returns the edits in order. If more than `most` steps would be needed, all lines are replaced.
    std::vector<Edit> run();

private:
    static constexpr std::ptrdiff_t most = 1000;
    [[nodiscard]] std::ptrdiff_t height() const { return static_cast<std::ptrdiff_t>(before_.size()); }
    [[nodiscard]] std::ptrdiff_t width() const { return static_cast<std::ptrdiff_t>(after_.size()); }
    [[nodiscard]] static std::ptrdiff_t furthest_at(const Frontier& frontier, std::ptrdiff_t diagonal) {
        return frontier[static_cast<std::size_t>(diagonal + most + 1)];
    }
    [[nodiscard]] static bool moves_down(const Frontier& frontier, std::ptrdiff_t step, std::ptrdiff_t diagonal) {
        return diagonal == -step ||
               (diagonal != step && furthest_at(frontier, diagonal - 1) < furthest_at(frontier, diagonal + 1));
    }
    bool advance_step(std::ptrdiff_t step);
    [[nodiscard]] std::vector<Edit> trace_back() const;
    [[nodiscard]] std::vector<Edit> replace_all() const;

    const Lines& before_;
    const Lines& after_;
    Frontier frontier_ = Frontier(static_cast<std::size_t>(2 * most + 3), 0);
    std::vector<Frontier> history_;
};

/// Extends every path by one change and then along equal lines. Returns true if a path reached the end.
bool Search::advance_step(std::ptrdiff_t step) {
    history_.push_back(frontier_);
    for (std::ptrdiff_t diagonal = -step; diagonal <= step; diagonal += 2) {
        std::ptrdiff_t x = moves_down(frontier_, step, diagonal) ? furthest_at(frontier_, diagonal + 1)
                                                                 : furthest_at(frontier_, diagonal - 1) + 1;
        while (x < height() && x - diagonal < width() && x - diagonal >= 0 &&
               before_[static_cast<std::size_t>(x)] == after_[static_cast<std::size_t>(x - diagonal)])
            ++x;
        frontier_[static_cast<std::size_t>(diagonal + most + 1)] = x;
        if (x >= height() && x - diagonal >= width()) return true;
    }
    return false;
}

std::vector<Edit> Search::trace_back() const {
    std::vector<Edit> edits;
    const auto add = [&](char kind, std::ptrdiff_t x, std::ptrdiff_t y) {
        edits.push_back({kind, static_cast<std::size_t>(x), static_cast<std::size_t>(y)});
    };
    std::ptrdiff_t x = height();
    std::ptrdiff_t y = width();
    for (auto step = static_cast<std::ptrdiff_t>(history_.size()) - 1; step >= 0; --step) {
        const Frontier& frontier = history_[static_cast<std::size_t>(step)];
        const std::ptrdiff_t diagonal = x - y;
        const std::ptrdiff_t from = moves_down(frontier, step, diagonal) ? diagonal + 1 : diagonal - 1;
        const std::ptrdiff_t old_x = step == 0 ? 0 : furthest_at(frontier, from);
        const std::ptrdiff_t old_y = step == 0 ? 0 : old_x - from;
        while (x > old_x && y > old_y) add(' ', --x, --y);
        if (step == 0) break;
        if (x > old_x)
            add('-', --x, y);
        else
            add('+', x, --y);
    }
    std::ranges::reverse(edits);
    return edits;
}

std::vector<Edit> Search::replace_all() const {
    std::vector<Edit> edits;
    for (std::size_t i = 0; i < before_.size(); ++i) edits.push_back({'-', i, 0});
    for (std::size_t i = 0; i < after_.size(); ++i) edits.push_back({'+', before_.size(), i});
    return edits;
}

std::vector<Edit> Search::run() {
    for (std::ptrdiff_t step = 0; step <= std::min(most, height() + width()); ++step)
        if (advance_step(step)) return trace_back();
    return replace_all();
}

/// Returns the edits between two texts, including the common lines at both ends.
std::vector<Edit> edits_between(const Lines& before, const Lines& after) {
    const std::size_t shorter = std::min(before.size(), after.size());
    std::size_t head = 0;
    while (head < shorter && before[head] == after[head]) ++head;
    std::size_t tail = 0;
    while (tail < shorter - head && before[before.size() - 1 - tail] == after[after.size() - 1 - tail]) ++tail;
    const auto middle = [&](const Lines& lines) {
        return Lines(lines.begin() + static_cast<std::ptrdiff_t>(head),
                     lines.end() - static_cast<std::ptrdiff_t>(tail));
    };
    const Lines old_middle = middle(before);
    const Lines new_middle = middle(after);
    std::vector<Edit> edits;
    for (std::size_t i = 0; i < head; ++i) edits.push_back({' ', i, i});
    for (const Edit& edit : Search(old_middle, new_middle).run())
        edits.push_back({edit.kind, edit.before + head, edit.after + head});
    for (std::size_t i = tail; i > 0; --i) edits.push_back({' ', before.size() - i, after.size() - i});
    return edits;
}

std::string range_text(std::size_t first, std::size_t count) {
    if (count == 1) return fmt::format("{}", first + 1);
    return fmt::format("{},{}", count == 0 ? first : first + 1, count);
}

using Place = std::vector<Edit>::const_iterator;

bool is_change(const Edit& edit) {
    return edit.kind != ' ';
}

std::string hunk_text(Place begin, Place end, const Lines& before, const Lines& after) {
    const auto counted = [&](char other) {
        return static_cast<std::size_t>(
            std::count_if(begin, end, [&](const Edit& e) { return e.kind == ' ' || e.kind == other; }));
    };
    std::string out =
        fmt::format("@@ -{} +{} @@\n", range_text(begin->before, counted('-')), range_text(begin->after, counted('+')));
    for (Place edit = begin; edit != end; ++edit) {
        const std::string_view line = edit->kind == '+' ? after[edit->after] : before[edit->before];
        out += fmt::format("{}{}", edit->kind, line);
        if (!line.ends_with('\n')) out += "\n\\ No newline at end of file\n";
    }
    return out;
}

/// Returns the end of the hunk that begins at `change`. Changes that are closer than twice the context are in one hunk.
Place hunk_end(Place change, Place end, std::ptrdiff_t context) {
    for (;;) {
        const Place quiet = std::find_if_not(change, end, is_change);
        change = std::find_if(quiet, end, is_change);
        if (change == end || change - quiet > 2 * context) return quiet + std::min(context, end - quiet);
    }
}

}  // namespace

std::string unified_diff(const std::string& path, std::string_view before, std::string_view after) {
    if (before == after) return "";
    constexpr std::ptrdiff_t context = 3;
    const Lines old_lines = lines_of(before);
    const Lines new_lines = lines_of(after);
    const std::vector<Edit> edits = edits_between(old_lines, new_lines);
    std::string out = fmt::format("--- {}\n+++ {}\n", path, path);
    Place at = edits.begin();
    for (Place change = std::find_if(at, edits.end(), is_change); change != edits.end();
         change = std::find_if(at, edits.end(), is_change)) {
        const Place begin = change - std::min(context, change - at);
        at = hunk_end(change, edits.end(), context);
        out += hunk_text(begin, at, old_lines, new_lines);
    }
    return out;
}

}  // namespace robochart::app
