// SPDX-License-Identifier: Apache-2.0
// Compares monitors of claims about states and variables with the definitions in words.hpp, on all traces up to a
// length.
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <random>
#include <string>

#include "claims/monitor/monitor.hpp"
#include "tests/claims/monitor/words.hpp"

namespace robochart::claims::testing::facts {
namespace {

/// The events of a trace besides tock: two events, and the beginnings and ends of two facts. `while` reads the second
/// fact.
enum Step : int { a, b, begins, ends, scope_begins, scope_ends, steps };
constexpr std::size_t fact = 0, of_scope = 1;

struct Truth {
    bool fact = false, scope = false;
    /// Returns whether the step is possible: a fact that holds can only end, and one that does not hold can only begin.
    [[nodiscard]] bool allows(int step) const {
        return !((step == begins && fact) || (step == ends && !fact) || (step == scope_begins && scope) ||
                 (step == scope_ends && !scope));
    }
    void follow(int step) {
        if (step == begins || step == ends) fact = step == begins;
        if (step == scope_begins || step == scope_ends) scope = step == scope_begins;
    }
};

Condition condition_on(std::size_t number) {
    Condition result;
    result.operand = Operand::fact;
    result.index = number;
    return result;
}

Events events_of(const Set& set) {
    Events result;
    for (const int event : set) {
        EventMatch match;
        if (event == a || event == b) match.channels = {static_cast<std::size_t>(event)};
        if (event == begins || event == ends) match.change = event == begins ? Change::begins : Change::ends;
        match.fact = fact;
        result.any.push_back(match);
    }
    return result;
}

CheckedClaim claim_with_facts() {
    CheckedClaim claim;
    for (const char* name : {"a", "b"}) claim.component.channels.push_back({name, ChannelKind::input, {}});
    claim.facts.resize(2);
    return claim;
}

/// Visits all traces up to a length. After each step on a trace that has not yet broken the claim, compares the monitor
/// with the definition.
class Walk {
public:
    Walk(const CheckedClaim& claim, const Bad& bad) : monitor_(claim), bad_(bad) {}

    std::size_t differences(std::size_t length) {
        MonitorState state = monitor_.begin();
        monitor_.observe(state, std::vector<FactValue>{{fact, false}, {of_scope, false}});
        walk(state, {}, length);
        return differences_;
    }
    [[nodiscard]] std::size_t broken() const { return broken_; }
    [[nodiscard]] const std::string& first() const { return first_; }

private:
    void follow(MonitorState& state, int step) const {
        switch (step) {
            case tock:
                return monitor_.tock(state);
            case a:
            case b:
                return monitor_.observe(state, Occurrence{static_cast<std::size_t>(step), {}});
            default:
                break;
        }
        const bool scope = step == scope_begins || step == scope_ends;
        const bool holds = step == begins || step == scope_begins;
        monitor_.observe(state, std::vector<FactValue>{{scope ? of_scope : fact, holds}});
    }
    void walk(const MonitorState& state, const Truth& truth, std::size_t left) {
        for (int step = tock; left > 0 && step < steps; ++step) {
            if (!truth.allows(step)) continue;
            MonitorState next = state;
            Truth later = truth;
            follow(next, step);
            later.follow(step);
            trace_.push_back(step);
            const bool broken = next.verdict == Verdict::broken;
            if (broken) ++broken_;
            if (broken != bad_(trace_) && ++differences_ == 1)
                for (const int event : trace_) first_ += std::to_string(event) + " ";
            if (!broken) walk(next, later, left - 1);
            trace_.pop_back();
        }
    }

    Monitor monitor_;
    const Bad& bad_;
    Trace trace_;
    std::size_t differences_ = 0, broken_ = 0;
    std::string first_;
};

/// True if the trace breaks the body in some period in which the fact of the scope holds.
Bad during(const Bad& body) {
    return after_until({scope_begins}, {scope_ends}, body);
}

TEST(FactMonitor, EventsAndChangesInAScopeOfWhile) {
    std::mt19937 random(21);
    const auto below = [&](int limit) { return static_cast<int>(random() % static_cast<std::uint32_t>(limit)); };
    const auto draw = [&] {
        Set result;
        while (result.empty())
            for (const int event : {a, b, begins, ends})
                if (below(3) == 0) result.insert(event);
        return result;
    };
    std::size_t broken = 0;
    for (int i = 0; i < 120; ++i) {
        CheckedClaim claim = claim_with_facts();
        const Set events = draw(), others = draw();
        const int limit = below(2);
        claim.body.events = events_of(events);
        claim.body.others = events_of(others);
        claim.body.units = limit;
        Bad body;
        switch (i % 4) {
            case 0:
                claim.body.kind = BodyKind::never;
                body = never(events);
                break;
            case 1:
                claim.body.kind = BodyKind::leads_within;
                body = leads_within(events, others, limit, {});
                break;
            case 2:
                claim.body.kind = BodyKind::only_within;
                body = only_within(events, others, limit);
                break;
            default:
                claim.body.kind = BodyKind::at_most;
                claim.body.units.reset();
                claim.body.count = 1;
                body = at_most(events, 1);
                break;
        }
        const bool scoped = i % 3 != 0;
        if (scoped) {
            claim.scope.kind = ScopeKind::during;
            claim.scope.condition = condition_on(of_scope);
        }
        const Bad bad = scoped ? during(body) : body;
        Walk walk(claim, bad);
        EXPECT_EQ(walk.differences(5), 0U) << i << ", first on " << walk.first();
        broken += walk.broken();
    }
    EXPECT_GT(broken, 10'000U);
}

/// Tests `always`, `for at least` and `for at most`, with and without `while`, by the definitions of these words.
TEST(FactMonitor, ConditionsAndStays) {
    for (const BodyKind kind : {BodyKind::always, BodyKind::for_at_least, BodyKind::for_at_most})
        for (const int limit : {0, 1, 2})
            for (const bool scoped : {false, true}) {
                CheckedClaim claim = claim_with_facts();
                claim.body.kind = kind;
                claim.body.condition = condition_on(fact);
                claim.body.units = limit;
                if (scoped) {
                    claim.scope.kind = ScopeKind::during;
                    claim.scope.condition = condition_on(of_scope);
                }
                const Bad bad = [=](const Trace& trace) {
                    Truth truth;
                    int now = 0, begun = 0;
                    for (const int step : trace) {
                        const bool inside = !scoped || truth.scope;
                        if (step == begins) begun = now;
                        if (step == tock) ++now;
                        if (inside && step == tock && kind == BodyKind::always && !truth.fact) return true;
                        if (inside && step == tock && kind == BodyKind::for_at_most && truth.fact &&
                            now - begun > limit)
                            return true;
                        if (inside && step == ends && kind == BodyKind::for_at_least && now - begun < limit)
                            return true;
                        truth.follow(step);
                    }
                    return false;
                };
                Walk walk(claim, bad);
                EXPECT_EQ(walk.differences(6), 0U)
                    << static_cast<int>(kind) << " " << limit << " " << scoped << ", first on " << walk.first();
                const bool may_break = kind != BodyKind::for_at_least || limit > 0;
                EXPECT_EQ(walk.broken() > 0, may_break);
            }
}

/// A fact is unknown until a machine shows it. Until then, no stay and no scope begins, and a tock breaks `always`.
TEST(FactMonitor, UnknownFacts) {
    CheckedClaim claim = claim_with_facts();
    claim.body.kind = BodyKind::for_at_least;
    claim.body.condition = condition_on(fact);
    claim.body.units = 2;
    const Monitor monitor(claim);
    MonitorState state = monitor.begin();
    monitor.observe(state, std::vector<FactValue>{{fact, true}});
    EXPECT_EQ(state.stay, 2);
    CheckedClaim always = claim_with_facts();
    always.body.kind = BodyKind::always;
    always.body.condition = condition_on(fact);
    MonitorState unknown = Monitor(always).begin();
    Monitor(always).tock(unknown);
    EXPECT_EQ(unknown.verdict, Verdict::broken);
}

}  // namespace
}  // namespace robochart::claims::testing::facts
