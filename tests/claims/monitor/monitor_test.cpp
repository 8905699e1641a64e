// SPDX-License-Identifier: Apache-2.0
// Compares the monitors of claims with the definitions in words.hpp, on all traces up to a length.
#include "claims/monitor/monitor.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <optional>
#include <random>
#include <string>

#include "tests/claims/monitor/words.hpp"

namespace robochart::claims::testing {
namespace {

constexpr int channels = 3;

Events events_of(const Set& set) {
    Events result;
    for (const int channel : set) result.any.emplace_back().channels = {static_cast<std::size_t>(channel)};
    return result;
}

/// A claim, and the definition of its words.
struct Pair {
    CheckedClaim claim;
    Bad bad;
    std::string name;
};

std::string text_of(const Trace& trace) {
    std::string result;
    for (const int event : trace)
        result += event == tock ? std::string("t") : std::string(1, static_cast<char>('a' + event));
    return result;
}

/// Visits all traces up to this length, and stops at a broken claim. Counts the traces on which monitor and definition
/// differ.
class Comparison {
public:
    explicit Comparison(const Pair& pair) : pair_(pair), monitor_(pair.claim) {}

    std::size_t differences(std::size_t length) {
        walk(monitor_.begin(), length);
        return differences_;
    }
    [[nodiscard]] const std::string& first() const { return first_; }
    [[nodiscard]] std::size_t traces() const { return traces_; }
    [[nodiscard]] std::size_t broken() const { return broken_; }

private:
    void walk(const MonitorState& state, std::size_t left) {
        for (int event = tock; left > 0 && event < channels; ++event) {
            MonitorState next = state;
            if (event == tock)
                monitor_.tock(next);
            else
                monitor_.observe(next, Occurrence{static_cast<std::size_t>(event), {}});
            trace_.push_back(event);
            ++traces_;
            const bool broken = next.verdict == Verdict::broken;
            if (broken) ++broken_;
            if (broken != pair_.bad(trace_) && ++differences_ == 1) first_ = text_of(trace_);
            if (!broken) walk(next, left - 1);
            trace_.pop_back();
        }
    }

    const Pair& pair_;
    Monitor monitor_;
    Trace trace_;
    std::size_t differences_ = 0, traces_ = 0, broken_ = 0;
    std::string first_;
};

class Draws {
public:
    explicit Draws(std::uint32_t seed) : random_(seed) {}
    int below(int limit) { return static_cast<int>(random_() % static_cast<std::uint32_t>(limit)); }
    /// Returns a set with an event.
    Set set() {
        Set result;
        while (result.empty())
            for (int channel = 0; channel < channels; ++channel)
                if (below(2) == 0) result.insert(channel);
        return result;
    }
    Set set_or_none() { return below(2) == 0 ? Set{} : set(); }

private:
    std::mt19937 random_;
};

/// Draws a body, and returns its definition.
Bad draw_body(Draws& draws, CheckedBody& body) {
    constexpr std::array kinds{BodyKind::never,        BodyKind::only_after,   BodyKind::only_within,
                               BodyKind::leads_within, BodyKind::leads_before, BodyKind::at_least,
                               BodyKind::at_most,      BodyKind::every};
    body.kind = kinds[static_cast<std::size_t>(draws.below(static_cast<int>(kinds.size())))];
    const Set events = draws.set(), others = draws.set();
    const int limit = draws.below(4);
    body.events = events_of(events);
    switch (body.kind) {
        case BodyKind::never:
            return never(events);
        case BodyKind::only_after:
            body.others = events_of(others);
            return only_after(events, others);
        case BodyKind::only_within:
            body.others = events_of(others);
            body.units = limit;
            return only_within(events, others, limit);
        case BodyKind::leads_within: {
            const Set exceptions = draws.set_or_none();
            body.others = events_of(others);
            body.exceptions = events_of(exceptions);
            body.units = limit;
            return leads_within(events, others, limit, exceptions);
        }
        case BodyKind::leads_before: {
            const Set end = draws.set();
            body.others = events_of(others);
            body.exceptions = events_of(end);
            return leads_before(events, others, end);
        }
        case BodyKind::at_least: {
            const Set exceptions = draws.set_or_none();
            body.others = events_of(others);
            body.exceptions = events_of(exceptions);
            body.units = limit + 1;
            return at_least(events, others, limit + 1, exceptions);
        }
        case BodyKind::at_most:
            body.count = 1 + draws.below(2);
            if (draws.below(2) == 0) return at_most(events, static_cast<int>(body.count));
            body.units = limit;
            return at_most_in(events, static_cast<int>(body.count), limit);
        case BodyKind::every:
            body.units = limit;
            return every(events, limit);
        case BodyKind::leads:
        case BodyKind::possible:
        case BodyKind::always:
        case BodyKind::for_at_least:
        case BodyKind::for_at_most:
        case BodyKind::can_take:
            break;
    }
    return {};
}

Pair draw_pair(Draws& draws) {
    Pair pair;
    for (const char* name : {"a", "b", "c"}) pair.claim.component.channels.push_back({name, ChannelKind::input, {}});
    const Bad body = draw_body(draws, pair.claim.body);
    constexpr std::array kinds{ScopeKind::whole,       ScopeKind::before,     ScopeKind::after,
                               ScopeKind::after_until, ScopeKind::after_each, ScopeKind::for_after};
    CheckedScope& scope = pair.claim.scope;
    scope.kind = kinds[static_cast<std::size_t>(draws.below(static_cast<int>(kinds.size())))];
    const Set first = draws.set(), last = draws.set();
    if (scope.kind != ScopeKind::whole) scope.first = events_of(first);
    const bool counts = pair.claim.body.kind == BodyKind::at_most && !pair.claim.body.units;
    if (scope.kind == ScopeKind::after_each && pair.claim.body.kind == BodyKind::at_most && !counts)
        scope.kind = ScopeKind::whole;
    switch (scope.kind) {
        case ScopeKind::whole:
            scope.first = {};
            pair.bad = body;
            break;
        case ScopeKind::before:
            pair.bad = before(first, body);
            break;
        case ScopeKind::after:
            pair.bad = after(first, body);
            break;
        case ScopeKind::after_until:
            scope.last = events_of(last);
            pair.bad = after_until(first, last, body);
            break;
        case ScopeKind::after_each: {
            Set counted;
            for (const EventMatch& match : pair.claim.body.events.any)
                counted.insert(static_cast<int>(match.channels.front()));
            pair.bad = counts ? at_most_after_each(first, counted, static_cast<int>(pair.claim.body.count))
                              : after_until(first, first, body);
            break;
        }
        case ScopeKind::for_after:
            scope.units = draws.below(3);
            pair.bad = for_after(first, static_cast<int>(scope.units), body);
            break;
        case ScopeKind::during:  // tested in facts_test.cpp
        case ScopeKind::cycle:
            break;
    }
    pair.name =
        std::to_string(static_cast<int>(scope.kind)) + "/" + std::to_string(static_cast<int>(pair.claim.body.kind));
    return pair;
}

TEST(Monitor, AgreesWithTheWordsOnAllTraces) {
    constexpr std::size_t length = 6;
    Draws draws(38);
    std::size_t traces = 0, broken = 0;
    for (int i = 0; i < 2000; ++i) {
        const Pair pair = draw_pair(draws);
        Comparison comparison(pair);
        EXPECT_EQ(comparison.differences(i % 20 == 0 ? length : length - 1), 0U)
            << "scope/body " << pair.name << ", first on " << comparison.first();
        traces += comparison.traces();
        broken += comparison.broken();
    }
    EXPECT_GT(traces, 500'000U);
    EXPECT_GT(broken, 100'000U);
}

/// Visits every trace up to a length, whether or not the claim is broken.
void all_traces(std::size_t length, Trace& trace, const std::function<void(const Trace&)>& visit) {
    visit(trace);
    for (int event = tock; length > 0 && event < channels; ++event) {
        trace.push_back(event);
        all_traces(length - 1, trace, visit);
        trace.pop_back();
    }
}

/// Returns true if the trace or a prefix breaks the body.
bool broken_before(const Bad& bad, const Trace& trace) {
    for (std::size_t length = 0; length <= trace.size(); ++length)
        if (bad(Trace(trace.begin(), trace.begin() + static_cast<std::ptrdiff_t>(length)))) return true;
    return false;
}

TEST(Monitor, TheEndBreaksWhatIsOwed) {
    Draws draws(39);
    for (int i = 0; i < 60; ++i) {
        CheckedClaim claim;
        const bool limited = i % 2 == 0;
        const Set events = draws.set(), others = draws.set(), exceptions = draws.set_or_none();
        claim.body.kind = BodyKind::leads_within;
        claim.body.events = events_of(events);
        claim.body.others = events_of(others);
        claim.body.exceptions = events_of(exceptions);
        claim.body.units = 2;
        if (!limited) claim.body.kind = BodyKind::leads;
        const Bad bad = leads_within(events, others, 2, exceptions);
        const Monitor monitor(claim);
        Trace trace;
        all_traces(5, trace, [&](const Trace& run) {
            MonitorState state = monitor.begin();
            for (const int event : run) {
                if (event == tock)
                    monitor.tock(state);
                else
                    monitor.observe(state, Occurrence{static_cast<std::size_t>(event), {}});
            }
            ASSERT_EQ(state.verdict == Verdict::broken, limited && broken_before(bad, run)) << text_of(run);
            if (state.verdict == Verdict::broken) return;
            EXPECT_EQ(monitor.owes(state), answer_missing(run, events, others, exceptions)) << text_of(run);
            monitor.end(state);
            EXPECT_EQ(state.verdict == Verdict::broken, answer_missing(run, events, others, exceptions))
                << text_of(run);
        });
    }
}

}  // namespace
}  // namespace robochart::claims::testing
