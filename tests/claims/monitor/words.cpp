// SPDX-License-Identifier: Apache-2.0
#include "tests/claims/monitor/words.hpp"

#include <algorithm>
#include <optional>

namespace robochart::claims::testing {
namespace {

/// Returns the instant of each event, which is the number of tocks before it.
std::vector<int> times_of(const Trace& trace) {
    std::vector<int> result;
    int now = 0;
    for (const int event : trace) {
        result.push_back(now);
        if (event == tock) ++now;
    }
    return result;
}

int duration_of(const Trace& trace) {
    return static_cast<int>(std::ranges::count(trace, tock));
}

bool is_in(int event, const Set& set) {
    return set.contains(event);
}

/// Returns true if some pair of events, the first before the second, satisfies the predicate.
template <class Predicate>
bool some_pair(const Trace& trace, const Predicate& predicate) {
    for (std::size_t i = 0; i < trace.size(); ++i)
        for (std::size_t k = i + 1; k < trace.size(); ++k)
            if (predicate(i, k)) return true;
    return false;
}

}  // namespace

Bad never(Set events) {
    return
        [=](const Trace& trace) { return std::ranges::any_of(trace, [&](int event) { return is_in(event, events); }); };
}

Bad only_after(Set events, Set others) {
    return [=](const Trace& trace) {
        for (std::size_t i = 0; i < trace.size(); ++i) {
            const bool came = std::any_of(trace.begin(), trace.begin() + static_cast<std::ptrdiff_t>(i),
                                          [&](int event) { return is_in(event, others); });
            if (is_in(trace[i], events) && !came) return true;
        }
        return false;
    };
}

Bad only_within(Set events, Set others, int limit) {
    return [=](const Trace& trace) {
        const std::vector<int> times = times_of(trace);
        for (std::size_t k = 0; k < trace.size(); ++k) {
            if (!is_in(trace[k], events)) continue;
            bool supported = false;
            for (std::size_t i = 0; i < k; ++i)
                supported = supported || (is_in(trace[i], others) && times[k] - times[i] <= limit);
            if (!supported) return true;
        }
        return false;
    };
}

Bad leads_within(Set events, Set others, int limit, Set exceptions) {
    return [=](const Trace& trace) {
        const std::vector<int> times = times_of(trace);
        for (std::size_t i = 0; i < trace.size(); ++i) {
            if (!is_in(trace[i], events) || duration_of(trace) - times[i] <= limit) continue;
            bool served = false;
            for (std::size_t k = i + 1; k < trace.size(); ++k)
                served = served ||
                         ((is_in(trace[k], others) || is_in(trace[k], exceptions)) && times[k] - times[i] <= limit);
            if (!served) return true;
        }
        return false;
    };
}

bool answer_missing(const Trace& trace, const Set& events, const Set& others, const Set& exceptions) {
    for (std::size_t i = 0; i < trace.size(); ++i) {
        if (!is_in(trace[i], events)) continue;
        const bool served = std::any_of(trace.begin() + static_cast<std::ptrdiff_t>(i) + 1, trace.end(),
                                        [&](int event) { return is_in(event, others) || is_in(event, exceptions); });
        if (!served) return true;
    }
    return false;
}

Bad leads_before(Set events, Set others, Set end) {
    return [=](const Trace& trace) {
        for (std::size_t i = 0; i < trace.size(); ++i) {
            if (!is_in(trace[i], events)) continue;
            for (std::size_t k = i + 1; k < trace.size() && !is_in(trace[k], others); ++k)
                if (is_in(trace[k], end)) return true;
        }
        return false;
    };
}

Bad at_least(Set events, Set others, int limit, Set exceptions) {
    return [=](const Trace& trace) {
        const std::vector<int> times = times_of(trace);
        return some_pair(trace, [&](std::size_t i, std::size_t k) {
            if (!is_in(trace[i], others) || !is_in(trace[k], events) || times[k] - times[i] >= limit) return false;
            return std::none_of(trace.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                trace.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                                [&](int event) { return is_in(event, exceptions); });
        });
    };
}

Bad at_most(Set events, int count) {
    return [=](const Trace& trace) {
        return std::ranges::count_if(trace, [&](int event) { return is_in(event, events); }) > count;
    };
}

Bad at_most_in(Set events, int count, int window) {
    return [=](const Trace& trace) {
        const std::vector<int> all = times_of(trace);
        std::vector<int> times;
        for (std::size_t i = 0; i < trace.size(); ++i)
            if (is_in(trace[i], events)) times.push_back(all[i]);
        const auto more = static_cast<std::size_t>(count);
        for (std::size_t i = 0; i + more < times.size(); ++i)
            if (times[i + more] - times[i] <= window) return true;
        return false;
    };
}

Bad every(Set events, int limit) {
    return [=](const Trace& trace) {
        int since = 0;
        for (const int event : trace) {
            if (event == tock && ++since > limit) return true;
            if (is_in(event, events)) since = 0;
        }
        return false;
    };
}

Bad before(Set first, Bad body) {
    return [=](const Trace& trace) {
        return body(Trace(trace.begin(), std::ranges::find_if(trace, [&](int event) { return is_in(event, first); })));
    };
}

Bad after(Set first, Bad body) {
    return after_until(std::move(first), {}, std::move(body));
}

Bad after_until(Set first, Set last, Bad body) {
    return [=](const Trace& trace) {
        bool inside = false;
        Trace segment;
        for (const int event : trace) {
            if (inside && !is_in(event, last)) {
                segment.push_back(event);
                if (body(segment)) return true;
                continue;
            }
            segment.clear();
            inside = is_in(event, first);
        }
        return false;
    };
}

Bad at_most_after_each(Set first, Set events, int count) {
    return [=](const Trace& trace) {
        std::optional<int> found;
        for (const int event : trace) {
            if (is_in(event, first)) found = 0;
            if (found && is_in(event, events)) ++*found;
            if (found && *found > count) return true;
        }
        return false;
    };
}

Bad for_after(Set first, int limit, Bad body) {
    return [=](const Trace& trace) {
        const std::vector<int> times = times_of(trace);
        bool inside = false;
        Trace segment;
        int youngest = 0;
        for (std::size_t i = 0; i < trace.size(); ++i) {
            if (trace[i] == tock && times[i] + 1 - youngest > limit) inside = false;
            if (inside) {
                segment.push_back(trace[i]);
                if (body(segment)) return true;
            }
            if (!is_in(trace[i], first)) continue;
            youngest = times[i];
            if (!inside) segment.clear();
            inside = true;
        }
        return false;
    };
}

}  // namespace robochart::claims::testing
