// SPDX-License-Identifier: Apache-2.0
// Collects the leaves of the behaviour's tree, with the moments in which they move and the moments between which they
// exist. Moments get their numbers when all of them are known.
#include "counterexample/timeline.hpp"

#include <iterator>
#include <list>

namespace robochart::runs {
namespace {

using process::Behaviour;
using process::TermId;

struct Entry {
    std::size_t raw = 0;
    bool shown = true;
    std::size_t number = 0;
    std::vector<Mover> movers;
    std::vector<std::pair<Leaf, TermId>> reached;
};
using Entries = std::list<Entry>;
using Point = Entries::iterator;

class Builder {
public:
    explicit Builder(std::size_t steps) {
        for (std::size_t i = 0; i < steps; ++i) entries_.push_back({i, true, 0, {}, {}});
    }
    Timeline build_timeline(const Behaviour& whole);

private:
    /// The time in which a part exists: from moment `begin` (no value: from the start) until before moment `end`.
    struct Span {
        std::optional<Point> begin = std::nullopt, end = std::nullopt;
    };
    struct Present {
        TermId initial;
        Span span;
    };
    /// Adds a part. `moments`: the moment of each step of the run to which the part's trace refers.
    void add(const Behaviour& part, const std::vector<Point>& moments, Span span);
    void add_leaf(const Behaviour& part, const std::vector<Point>& moments, Span span);
    void add_compressed(const Behaviour& part, const std::vector<Point>& moments, Span span);
    Point moment_at(const std::vector<Point>& moments, std::size_t step) {
        if (step < moments.size()) return moments[step];
        return moments.empty() ? entries_.end() : std::next(moments.back());
    }

    Entries entries_;
    std::vector<Present> leaves_;
};

void Builder::add_leaf(const Behaviour& part, const std::vector<Point>& moments, Span span) {
    const Leaf leaf = leaves_.size();
    leaves_.push_back({part.initial, span});
    for (std::size_t i = 0; i < moments.size() && i < part.trace.size(); ++i) {
        if (part.trace[i] == process::no_event) continue;
        const bool hides = part.trace[i] == process::tau && part.revealed[i] != process::no_event;
        moments[i]->movers.push_back({leaf, hides ? part.revealed[i] : part.trace[i]});
        moments[i]->reached.emplace_back(leaf, part.reached[i]);
    }
}

void Builder::add_compressed(const Behaviour& part, const std::vector<Point>& moments, Span span) {
    const Behaviour& inside = part.parts.front();
    std::size_t visible_left = 0;
    for (const process::Event event : inside.trace) visible_left += event != process::tau ? 1 : 0;
    std::vector<Point> own;
    for (std::size_t i = 0; i < inside.shown_by.size(); ++i) {
        const std::size_t at = inside.shown_by[i];
        const bool any = at < moments.size();
        const bool visible = inside.trace[i] != process::tau;
        if (any && visible) {
            own.push_back(moments[at]);
            --visible_left;
            continue;
        }
        // If no later step is visible, the step is inserted after the last visible one.
        Point before = entries_.end();
        if (any) before = visible_left > 0 ? moments[at] : std::next(moments[at]);
        own.push_back(entries_.insert(before, {any ? moments[at]->raw : 0, false, 0, {}, {}}));
    }
    add(inside, own, span);
}

void Builder::add(const Behaviour& part, const std::vector<Point>& moments, Span span) {
    if (part.begins > 0) span.begin = moment_at(moments, part.begins);
    if (part.ends <= part.trace.size()) span.end = moment_at(moments, part.ends);
    const bool compressed = part.parts.size() == 1 &&
                            part.parts.front().shown_by.size() == part.parts.front().trace.size() &&
                            !part.parts.front().shown_by.empty();
    if (part.parts.empty()) return add_leaf(part, moments, span);
    if (compressed) return add_compressed(part, moments, span);
    for (const Behaviour& inner : part.parts) add(inner, moments, span);
}

Timeline Builder::build_timeline(const Behaviour& whole) {
    std::vector<Point> moments;
    for (Point at = entries_.begin(); at != entries_.end(); ++at) moments.push_back(at);
    add(whole, moments, {});
    std::size_t number = 0;
    for (Entry& entry : entries_) entry.number = number++;
    const auto is_next = [&](const std::optional<Point>& at, const Entry& entry) {
        return at && (*at == entries_.end() ? number : (*at)->number) == entry.number + 1;
    };

    Timeline result;
    std::vector<std::optional<TermId>> now(leaves_.size());
    for (std::size_t i = 0; i < leaves_.size(); ++i)
        if (!leaves_[i].span.begin) now[i] = leaves_[i].initial;
    result.initial = now;
    for (Entry& entry : entries_) {
        for (const auto& [leaf, term] : entry.reached) now[leaf] = term;
        // The list shows the leaves after this moment. So a leaf that begins to exist in the next moment is added now,
        // and a leaf that no longer exists in the next moment is removed now.
        for (std::size_t i = 0; i < leaves_.size(); ++i) {
            if (is_next(leaves_[i].span.begin, entry)) now[i] = leaves_[i].initial;
            if (is_next(leaves_[i].span.end, entry)) now[i] = std::nullopt;
        }
        result.moments.push_back({entry.raw, entry.shown, std::move(entry.movers), now});
    }
    return result;
}

}  // namespace

Timeline timeline_of(const Behaviour& behaviour, std::size_t steps) {
    return Builder(steps).build_timeline(behaviour);
}

}  // namespace robochart::runs
