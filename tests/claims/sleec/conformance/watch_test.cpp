// SPDX-License-Identifier: Apache-2.0
// Tests the conformance of components to a rule. The components were written by hand, and the verdicts follow from
// docs/rules-language.md.
#include <gtest/gtest.h>

#include <numeric>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/printer.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "claims/sleec/conformance/endless.hpp"
#include "claims/sleec/conformance/watch.hpp"
#include "tests/claims/sleec/support.hpp"

namespace robochart::sleec {
namespace {

using testing::Read;
using testing::with_definitions;

/// A component whose process is C. Its channels are the events and measures of with_definitions(). Inputs and outputs
/// are treated alike.
const std::string channels = R"(
datatype Way = in | out
datatype Load = low | mid | high
channel tock
channel Go, Stop, Halt, Alarm, Help : Way
channel near, safe : Way.Bool
channel level : Way.{0..9}
channel load : Way.Load
channel Walk : Way.{0..3}
channel shown : Bool.Bool
Wait(n, P) = if n == 0 then P else tock -> Wait(n - 1, P)
)";

Linking linking() {
    Linking result;
    for (const char* event : {"Go", "Stop", "Halt", "Alarm", "Help"}) result.events.emplace_back(event);
    for (const char* measure : {"near", "safe", "level"}) result.measures.push_back(LinkedMeasure{measure, {}});
    result.measures.push_back(LinkedMeasure{"load", {"low", "mid", "high"}});
    return result;
}

/// Returns "obeyed", "broken" or "waits for ever", followed by ", never asked" if the rule never applies to the
/// component.
std::string judged(const std::string& rule, const std::string& component, const Linking& linked = linking(),
                   Readings readings = Readings::one_value) {
    Read read(with_definitions("R " + rule));
    if (!read.checked_too().checked) return read.report();
    const Watch watch(*read.checked, 0, linked, cspm::build::name("C"), readings);
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    cspm::Script script = cspm::read(sources, sources.add("c.csp", channels + component), diagnostics);
    for (const cspm::DeclPtr& declaration : watch.declarations()) script.decls.push_back(declaration);
    std::vector<std::size_t> ways;
    for (std::size_t i = 0; i < watch.ways().size(); ++i)
        if (watch.ways()[i].obligation < watch.obligations().size()) ways.push_back(i);
    script.decls.push_back(watch.obeyed_assertion());
    script.decls.push_back(watch.never_asked_assertion(ways));
    const std::string text = cspm::print(script);
    const cspm::Script again = cspm::read(sources, sources.add("whole.csp", text), diagnostics);
    (void)cspm::check_types(again, diagnostics);
    if (!diagnostics.ok()) return diagnostics::render_text(sources, diagnostics) + text;
    EXPECT_TRUE(cspm::equal(script, again)) << text;
    cspm::Session session(script);
    const auto holds = [&](std::size_t i) {
        return session.check(*session.assertions()[i], {}).verdict.outcome == refine::Outcome::holds;
    };
    if (holds(0) && watch.has_demand_without_limit()) {
        const auto system = session.system(watch.waiting_process());
        if (endless_run(*system, session.event_table().intern(Watch::waiting), [](std::size_t) {}))
            return "waits for ever";
    }
    return std::string(holds(0) ? "obeyed" : "broken") + (holds(1) ? ", never asked" : "");
}

TEST(SleecWatch, DeadlinesAreInclusive) {
    const auto after = [](int n) {
        return "C = Go.in -> Wait(" + std::to_string(n) + ", Stop.out -> C) [] tock -> C\n";
    };
    EXPECT_EQ(judged("when Go then Stop within 2 seconds", after(2)), "obeyed");
    EXPECT_EQ(judged("when Go then Stop within 2 seconds", after(3)), "broken");
    EXPECT_EQ(judged("when Go then not Stop within 2 seconds", after(2)), "broken");
    EXPECT_EQ(judged("when Go then not Stop within 2 seconds", after(3)), "obeyed");
    EXPECT_EQ(judged("Stop at least 3 seconds after Go", after(3)), "obeyed");
    EXPECT_EQ(judged("Stop at least 3 seconds after Go", after(2)), "broken");
    EXPECT_EQ(judged("when Go then Stop within [2, 3] seconds", after(2)), "obeyed");
    EXPECT_EQ(judged("when Go then Stop within [2, 3] seconds", after(1)), "broken");
}

TEST(SleecWatch, AComponentThatEndsOwesItsDuties) {
    EXPECT_EQ(judged("when Go then Stop within 2 seconds", "C = Go.in -> SKIP"), "broken");
    EXPECT_EQ(judged("when Go then not Stop within 2 seconds", "C = Go.in -> SKIP"), "obeyed");
}

TEST(SleecWatch, ARuleMayNeverAsk) {
    EXPECT_EQ(judged("when Halt then Stop within 2 seconds", "C = Go.in -> C [] tock -> C"), "obeyed, never asked");
    EXPECT_EQ(judged("when Go and level > 12 then Stop within 2 seconds", "C = tock -> level.in?x -> Go.in -> C"),
              "obeyed, never asked")
        << "it reads the level first, which goes to 9";
}

/// An active rule does not block its trigger, and each trigger opens a duty.
TEST(SleecWatch, EveryTriggerCounts) {
    const std::string twice = "C = Go.in -> tock -> Go.in -> tock -> tock -> tock -> Stop.out -> C\n";
    EXPECT_EQ(judged("when Go then Stop within 3 seconds", twice), "broken") << "the first waits 4 seconds";
    EXPECT_EQ(judged("when Go then Stop within 4 seconds", twice), "obeyed") << "one Stop fulfils both";
    EXPECT_EQ(judged("when Go then not Stop within 3 seconds", twice), "broken") << "the second forbids it";
    EXPECT_EQ(judged("when Go then Go within 1 seconds", "C = Go.in -> tock -> C"), "obeyed");
    EXPECT_EQ(judged("when Go then Go within 0 seconds", "C = Go.in -> tock -> C"), "broken") << "not by itself";
}

TEST(SleecWatch, MeasuresAreThoseOfTheInstant) {
    const std::string rule = "when Go and near then Stop within 0 seconds";
    EXPECT_EQ(judged(rule, "C = near.in?x -> Go.in -> (if x then Stop.out -> tock -> C else tock -> C)"), "obeyed");
    EXPECT_EQ(judged(rule, "C = Go.in -> near.in?x -> (if x then Stop.out -> tock -> C else tock -> C)"), "obeyed")
        << "read behind the trigger, at the same instant";
    EXPECT_EQ(judged(rule, "C = Go.in -> near.in?x -> (if x then tock -> C else Stop.out -> tock -> C)"), "broken");
    EXPECT_EQ(judged(rule, "C = near.in?x -> tock -> Go.in -> (if x then Stop.out -> tock -> C else tock -> C)"),
              "broken")
        << "the reading is a second old";
    EXPECT_EQ(judged(rule, "C = Go.in -> tock -> C"), "broken") << "it does not look";
    EXPECT_EQ(judged(rule, "C = Go.in -> Stop.out -> tock -> C"), "obeyed") << "it need not look";
}

/// The first Go is answered, because near is true. Before the second Go at the same instant, near becomes false.
TEST(SleecWatch, AMeasureHasOneValueAtAnInstant) {
    const std::string rule = "when Go and near then Stop within 0 seconds";
    const std::string twice =
        "C = Go.in -> near.in?x -> (if x then Stop.out -> C1 else C1)\n"
        "C1 = Go.in -> near.in?x -> (if x then Stop.out -> tock -> C else tock -> C)";
    EXPECT_EQ(judged(rule, twice), "obeyed");
    EXPECT_EQ(judged(rule, twice, linking(), Readings::any), "broken");
    const std::string forbids = "when Go and near then not Stop within 0 seconds";
    EXPECT_EQ(judged(forbids, "C = Go.in -> Stop.out -> near.in.false -> tock -> C"), "obeyed")
        << "the value is known in the end";
    EXPECT_EQ(judged(forbids, "C = Go.in -> Stop.out -> near.in?x -> tock -> C"), "broken");
    EXPECT_EQ(judged(forbids, "C = Go.in -> near.in.true -> Stop.out -> tock -> C"), "broken");
}

/// A response without a limit occurs eventually if and only if no infinite run omits it.
TEST(SleecWatch, WithoutLimit) {
    const std::string rule = "when Go then Stop";
    EXPECT_EQ(judged(rule, "C = Go.in -> Wait(7, Stop.out -> tock -> C) [] tock -> C"), "obeyed");
    EXPECT_EQ(judged(rule, "C = Go.in -> D\nD = tock -> D |~| Stop.out -> C"), "waits for ever");
    EXPECT_EQ(judged(rule, "C = Go.in -> SKIP"), "waits for ever") << "time goes on when it has ended";
    EXPECT_EQ(judged(rule, "C = Go.in -> D\nD = Go.in -> D [] Stop.out -> tock -> C"), "obeyed")
        << "events without end at one instant are no history";
    EXPECT_EQ(judged(rule, "C = tock -> C [] Stop.out -> C"), "obeyed, never asked");
    EXPECT_EQ(judged("when Go then Stop unless near",
                     "C = Go.in -> near.in?x -> (if x then D else Stop.out -> C)\n"
                     "D = tock -> D"),
              "obeyed");
    EXPECT_EQ(judged("when Go then Stop unless near",
                     "C = Go.in -> near.in?x -> (if x then Stop.out -> C else D)\n"
                     "D = tock -> D"),
              "waits for ever");
    EXPECT_EQ(judged("when Go then Stop within 1 seconds otherwise Alarm",
                     "C = Go.in -> tock -> tock -> D\n"
                     "D = Halt.in -> tock -> D"),
              "waits for ever");
    EXPECT_EQ(judged("when Go then not Stop", "C = Go.in -> D\nD = tock -> D"), "obeyed");
    EXPECT_EQ(judged("when Go then not Stop", "C = Go.in -> Wait(3, Stop.out -> C)"), "broken");
}

TEST(SleecWatch, NumbersAndScalesByTheirClasses) {
    const std::string reading = "C = level.in?x -> Go.in -> (if x > 3 then Stop.out -> tock -> C else tock -> C)";
    EXPECT_EQ(judged("when Go and level > 3 then Stop within 0 seconds", reading), "obeyed");
    EXPECT_EQ(judged("when Go and level >= 3 then Stop within 0 seconds", reading), "broken");
    EXPECT_EQ(judged("when Go and level > 4 and level < 6 then Stop within 0 seconds", reading), "obeyed");
    EXPECT_EQ(judged("when Go and load >= mid then Stop within 0 seconds",
                     "C = load.in?x -> Go.in -> (if x == low then tock -> C else Stop.out -> tock -> C)"),
              "obeyed");
    EXPECT_EQ(judged("when Go and load >= mid then Stop within 0 seconds",
                     "C = load.in?x -> Go.in -> (if x == high then Stop.out -> tock -> C else tock -> C)"),
              "broken");
}

/// The machine shows on a channel that `in A` is true. The event itself may leave A.
TEST(SleecWatch, StatesAreThoseBeforeTheTrigger) {
    Linking states = linking();
    states.measures.push_back(LinkedMeasure{"shown", {}, 1, 2});
    const std::string rule = "when Go and in A then Stop within 0 seconds";
    EXPECT_EQ(judged(rule, "C = shown!true!true -> Go.in -> shown!true!false -> tock -> C", states), "broken");
    EXPECT_EQ(judged(rule, "C = shown!true!true -> Go.in -> shown!true!false -> Stop.out -> tock -> C", states),
              "obeyed");
    EXPECT_EQ(judged(rule, "C = shown!true!false -> Go.in -> shown!true!true -> tock -> tock -> C", states),
              "obeyed, never asked");
    EXPECT_EQ(judged(rule, "C = shown!false!true -> tock -> tock -> D\nD = Go.in -> tock -> D", states), "broken")
        << "a state holds while time passes";
    EXPECT_EQ(judged("when Go then Stop within 0 seconds unless in A",
                     "C = shown!true!true -> Go.in -> shown!true!false -> tock -> C", states),
              "obeyed, never asked");
}

TEST(SleecWatch, EventsWithValues) {
    const auto walked = [](const std::string& rule, const std::string& component) {
        Linking linked = linking();
        linked.events.clear();
        // Go comes first, then Stop with each of its values in order, then the other events
        linked.events.emplace_back("Go");
        for (const char* value : {"1", "3"})
            linked.events.push_back(LinkedEvent({std::string("Walk.out.") + value},
                                                {cspm::build::dot({cspm::build::name("Walk"), cspm::build::name("out"),
                                                                   cspm::build::number(value[0] - '0')})}));
        linked.events.push_back(LinkedEvent({}, {}));  // a value that the instantiation does not contain
        for (const char* event : {"Halt", "Alarm", "Help"}) linked.events.emplace_back(event);
        return judged(rule, component, linked);
    };
    EXPECT_EQ(walked("when Stop(1) then Stop(3) within 1 seconds", "C = Walk.out.1 -> tock -> Walk.out.3 -> C"),
              "obeyed");
    EXPECT_EQ(walked("when Stop(1) then Stop(3) within 1 seconds", "C = Walk.out.1 -> tock -> Walk.out.1 -> C"),
              "broken");
    EXPECT_EQ(walked("when Go then Stop(1) within 1 seconds unless Alarm\nS when Stop(3) then Halt",
                     "C = Go.in -> tock -> Walk.out.3 -> tock -> tock -> C"),
              "broken");
    EXPECT_EQ(walked("when Go then Stop(_) within 1 seconds\nS when Stop(1) then Stop(3)",
                     "C = Go.in -> tock -> Walk.out.3 -> tock -> tock -> C"),
              "obeyed");
    EXPECT_EQ(walked("when Go then not Stop(_) within 1 seconds\nS when Stop(1) then Stop(3)",
                     "C = Go.in -> tock -> Walk.out.3 -> tock -> tock -> C"),
              "broken");
    EXPECT_EQ(walked("when Go then not Stop(1) within 1 seconds\nS when Stop(1) then Stop(3)",
                     "C = Go.in -> tock -> Walk.out.3 -> tock -> tock -> C"),
              "obeyed");
}

TEST(SleecWatch, AMeasureThatTheComponentLacksMayBeAnything) {
    Linking none = linking();
    none.measures[0].reset();
    EXPECT_EQ(judged("when Go and near then Stop within 0 seconds", "C = Go.in -> tock -> C", none), "broken");
    EXPECT_EQ(judged("when Go and near then Stop within 0 seconds", "C = Go.in -> Stop.out -> tock -> C", none),
              "obeyed");
}

TEST(SleecWatch, AlternativesInTheirWindows) {
    const std::string rule = "when Go then Stop within 2 seconds otherwise Alarm within 1 seconds";
    const auto alarm = [](int n) {
        return "C = Go.in -> Wait(" + std::to_string(n) + ", Alarm.out -> tock -> tock -> tock -> tock -> C)\n";
    };
    EXPECT_EQ(judged(rule, alarm(1)), "broken") << "too soon: Stop was still possible";
    EXPECT_EQ(judged(rule, alarm(2)), "obeyed");
    EXPECT_EQ(judged(rule, alarm(3)), "obeyed");
    EXPECT_EQ(judged(rule, alarm(4)), "broken");
    const std::string forbids = "when Go then Stop within 2 seconds otherwise not Alarm within 1 seconds";
    EXPECT_EQ(judged(forbids, alarm(3)), "broken");
    EXPECT_EQ(judged(forbids, alarm(4)), "obeyed");
    EXPECT_EQ(judged(forbids, "C = Go.in -> tock -> tock -> Alarm.out -> Stop.out -> tock -> tock -> C"), "obeyed");
    EXPECT_EQ(judged(forbids, "C = Go.in -> tock -> tock -> Alarm.out -> tock -> tock -> C"), "broken");
}

TEST(SleecWatch, DefeatersAndEventsThatEndADuty) {
    EXPECT_EQ(judged("when Go then Stop within 1 seconds unless Halt", "C = Go.in -> Halt.in -> Wait(3, C)"), "obeyed");
    EXPECT_EQ(judged("when Go then Stop within 1 seconds unless Halt", "C = Halt.in -> Go.in -> Wait(3, C)"), "broken");
    EXPECT_EQ(judged("when Go then Stop within 1 seconds unless near then Alarm within 1 seconds",
                     "C = near.in?x -> Go.in -> (if x then Alarm.out -> Wait(2, C) else Stop.out -> Wait(2, C))"),
              "obeyed");
}

}  // namespace
}  // namespace robochart::sleec
