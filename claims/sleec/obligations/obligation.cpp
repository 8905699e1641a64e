// SPDX-License-Identifier: Apache-2.0
// See obligation.hpp.
#include "claims/sleec/obligations/obligation.hpp"

#include <algorithm>
#include <utility>

namespace robochart::sleec {
namespace {

/// Collects demands from the response in force and from the responses after each `otherwise`.
class Collector {
public:
    Collector(const Valuation& values, WithoutLimit without) : values_(values), without_(without) {}

    std::optional<Obligation> collect_demands(const DutyPtr& duty) {
        DutyPtr at = in_force(duty);
        std::int64_t begin = 0;
        while (at) {
            if (at->measured) throw NotDecided("a measure decides a limit of time");
            if (at->to && *at->to < at->from) return std::nullopt;  // "at least 0 seconds" demands nothing
            const bool open = !at->to && without_ == WithoutLimit::eventually;
            const std::int64_t length = at->to.value_or(0);
            result_.any.push_back(
                {at->forbids, at->event, begin + at->from, open ? forever : begin + length, at->written});
            if (!at->otherwise || open) return std::move(result_);
            begin += length;
            at = in_force(at->otherwise);
        }
        return std::nullopt;  // the last part demands nothing, so the obligation is always fulfilled
    }

private:
    /// Returns the response in force. The last defeater whose condition is true decides; then the defeaters of its
    /// response are evaluated in the same way.
    DutyPtr in_force(DutyPtr duty) {
        while (duty) {
            const CheckedDefeater* last = nullptr;
            for (const CheckedDefeater& defeater : duty->defeaters) {
                if (defeater.event)
                    result_.ended_by.insert(result_.ended_by.end(), defeater.event->begin(), defeater.event->end());
                else if (evaluate_condition(defeater.condition, values_) != 0)
                    last = &defeater;
            }
            if (last == nullptr) return duty;
            duty = last->duty;
        }
        return nullptr;
    }

    const Valuation& values_;
    WithoutLimit without_;
    Obligation result_;
};

struct Window {
    std::int64_t begin, end;
};

/// True if these windows together cover `window`.
bool is_covered(Window window, std::vector<Window> by) {
    std::ranges::sort(by, [](const Window& a, const Window& b) { return a.begin < b.begin; });
    for (const Window& covering : by) {
        if (covering.begin > window.begin) return false;
        if (covering.end == forever || covering.end >= window.end) return true;
        window.begin = std::max(window.begin, covering.end + 1);
    }
    return window.begin > window.end;
}

/// Returns the windows in which the obligation demands an event.
std::vector<Window> demand_windows(const Obligation& obligation, std::size_t event) {
    std::vector<Window> result;
    for (const Demand& demand : obligation.any)
        if (!demand.forbids && demand.event.contains(event)) result.push_back({demand.begin, demand.end});
    return result;
}

/// True if `of` contains a prohibition that no history breaks under two assumptions: no event fulfils a positive demand
/// of `of`, and `assumed`, if it is given, is obeyed.
bool some_prohibition_within(const Obligation& of, const Demand* assumed) {
    return std::ranges::any_of(of.any, [&](const Demand& prohibition) {
        if (!prohibition.forbids) return false;
        return std::ranges::all_of(prohibition.event, [&](std::size_t event) {
            std::vector<Window> closed = demand_windows(of, event);
            if (assumed != nullptr && assumed->event.contains(event)) closed.push_back({assumed->begin, assumed->end});
            return is_covered({prohibition.begin, prohibition.end}, std::move(closed));
        });
    });
}

}  // namespace

bool always_fulfilled(const Obligation& obligation) {
    return some_prohibition_within(obligation, nullptr);
}

std::optional<Obligation> obligation_of(const DutyPtr& duty, const Valuation& values, WithoutLimit without) {
    return Collector(values, without).collect_demands(duty);
}

std::optional<Obligation> obligation_of(const CheckedRule& rule, const Valuation& values, WithoutLimit without) {
    if (rule.condition && evaluate_condition(*rule.condition, values) == 0) return std::nullopt;
    return obligation_of(rule.duty, values, without);
}

/// A disjunction implies another one iff each of its parts does. The part "E occurs at a second of W" implies the other
/// disjunction iff each second of W is in a window in which the other demands E. The part "E does not occur in W"
/// implies the other disjunction iff the other forbids E in a window that is covered by W and the windows in which the
/// other demands E. (Otherwise there is a history in which the part is true, no demanded event of the other occurs in
/// its window, and each forbidden one does.) If several events may fulfil a demand, or are forbidden, this has to be
/// true for each of them.
bool implies(const Obligation& stronger, const Obligation& weaker) {
    if (always_fulfilled(weaker)) return true;
    for (const std::size_t event : stronger.ended_by)
        if (std::ranges::find(weaker.ended_by, event) == weaker.ended_by.end()) return false;
    return std::ranges::all_of(stronger.any, [&](const Demand& demand) {
        if (demand.forbids) return some_prohibition_within(weaker, &demand);
        return std::ranges::all_of(demand.event, [&](std::size_t event) {
            return is_covered({demand.begin, demand.end}, demand_windows(weaker, event));
        });
    });
}

}  // namespace robochart::sleec
