// SPDX-License-Identifier: Apache-2.0
// Compares monitors with the checker, for every history over two events and seconds. The monitor must report a violated
// rule if and only if the history can violate the process of the rule in the checker (claims/sleec/conformance).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <set>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/lts/graph.hpp"
#include "claims/sleec/conformance/watch.hpp"
#include "claims/sleec/monitor/rule_monitor.hpp"
#include "claims/sleec/syntax/printer.hpp"
#include "tests/claims/sleec/random/naive_rules.hpp"
#include "tests/claims/sleec/support.hpp"
#include "tests/rounds.hpp"

namespace robochart::sleec {
namespace {

using testing::Read;
using testing::with_definitions;

/// The graph of a rule's process, composed with a process that can perform any event.
class RuleProcess {
public:
    explicit RuleProcess(const CheckedRules& rules) {
        Linking linking;
        std::string events = "tock";
        for (const Event& event : rules.file->events) {
            linking.events.emplace_back(event.name.text);
            events += ", " + event.name.text;
        }
        linking.measures.resize(rules.measures.size());
        const Watch watch(rules, 0, linking, cspm::build::name("Anything"));
        diagnostics::SourceManager sources;
        diagnostics::Diagnostics diagnostics;
        cspm::Script script = cspm::read(
            sources,
            sources.add("c.csp", "channel " + events + "\nAnything = [] x : {" + events + "} @ x -> Anything\n"),
            diagnostics);
        for (const cspm::DeclPtr& declaration : watch.declarations()) script.decls.push_back(declaration);
        session_.emplace(script);
        const auto system = session_->system(watch.checked_process());
        graph_ = lts::explore(*system, [](std::size_t) {}).graph;
    }

    using States = std::set<lts::StateIndex>;
    /// Returns the states after an event. Internal steps of the rule's process may precede and follow the event.
    States after(const States& before, const std::string& event) {
        const auto number = session_->event_table().intern(event);
        States result;
        for (const lts::StateIndex state : closed(before))
            for (const lts::Edge& edge : graph_.edges(state))
                if (edge.event == number) result.insert(edge.target);
        return result;
    }
    bool broken(const States& states) {
        const States all = closed(states);
        return std::ranges::any_of(all, [&](lts::StateIndex state) {
            const auto edges = graph_.edges(state);
            return std::ranges::any_of(edges, [&](const lts::Edge& edge) {
                return session_->event_table().name(edge.event) == "sleec_broken";
            });
        });
    }

private:
    States closed(States states) {
        std::vector<lts::StateIndex> waiting(states.begin(), states.end());
        while (!waiting.empty()) {
            const lts::StateIndex state = waiting.back();
            waiting.pop_back();
            for (const lts::Edge& edge : graph_.edges(state)) {
                const bool own =
                    edge.event == process::tau || session_->event_table().name(edge.event).starts_with("sleec_asked");
                if (own && states.insert(edge.target).second) waiting.push_back(edge.target);
            }
        }
        return states;
    }

    std::optional<cspm::Session> session_;
    lts::Graph graph_;
};

struct Step {
    const char* name;
    std::optional<std::size_t> event;
};
constexpr std::array<Step, 3> steps{Step{"Go", 0}, Step{"Stop", 1}, Step{"tock", std::nullopt}};

/// The states of the monitor and of the process after a history.
struct Place {
    RuleMonitor monitor;
    RuleProcess::States states;
    std::string history;
    int length = 0;
};

std::string key(const Place& place) {
    std::string text;
    for (const auto& [obligation, progress] : place.monitor.open_duties()) {
        for (const Demand& demand : obligation.any)
            text += std::to_string(*demand.event.begin()) + (demand.forbids ? "-" : "+") +
                    std::to_string(demand.begin) + "." + std::to_string(demand.end) + " ";
        text += std::to_string(progress.elapsed) + "." + std::to_string(progress.broken) + "; ";
    }
    for (const lts::StateIndex state : place.states) text += std::to_string(state) + " ";
    return text;
}

/// Compares both for all histories. If several histories lead both to the same states, only one is continued, because
/// their continuations agree. Returns the length of the longest history that was needed.
int compare(const CheckedRules& rules) {
    RuleProcess process(rules);
    std::vector<Place> waiting{{RuleMonitor(rules, WithoutLimit::eventually), {0}, "", 0}};
    std::set<std::string> known{key(waiting.front())};
    for (std::size_t at = 0; at < waiting.size() && !::testing::Test::HasFailure(); ++at)
        for (const Step& step : steps) {
            Place next = waiting[at];
            if (step.event)
                next.monitor.observe_event(*step.event, {0, 0, 0, 0});
            else
                next.monitor.end_second();
            next.states = process.after(next.states, step.name);
            next.history += std::string(step.name) + " ";
            ++next.length;
            const bool violated = !next.monitor.take_violations().empty();
            EXPECT_EQ(violated, process.broken(next.states)) << next.history;
            if (!violated && known.insert(key(next)).second) waiting.push_back(std::move(next));
        }
    return waiting.back().length;
}

/// The comparison covers histories of every length, including twelve steps.
TEST(RuleMonitor, AgreesWithTheCheckerOnAllHistories) {
    for (const char* rule : {
             "when Go then Stop within 2 seconds",
             "when Go then not Stop within 2 seconds",
             "when Go then Stop within [1, 2] seconds",
             "when Go then Stop within 1 seconds otherwise not Stop within 2 seconds",
             "when Go then not Stop within 1 seconds otherwise Stop within 2 seconds",
             "when Go then Go within 3 seconds",
             "when Go then not Stop",
             "when Go then Stop within 0 seconds otherwise Go within 1 seconds",
             "when Go then Stop within 2 seconds unless Go",
         }) {
        SCOPED_TRACE(rule);
        Read read(with_definitions(std::string("R ") + rule));
        ASSERT_TRUE(read.checked_too().checked) << read.report();
        EXPECT_GT(compare(*read.checked), 0);
    }
}

/// Returns a random rule without conditions on measures.
CheckedRules plain_rule(std::uint64_t seed) {
    for (;; seed += 1000) {
        std::mt19937_64 random(seed);
        for (testing::NaiveRule& rule : testing::random_rules(random)) {
            rule.condition.reset();
            rule.response.defeaters.clear();
            Read read(testing::text_of({rule}));
            if (read.checked_too().checked) return *read.checked;
        }
    }
}

/// After a violation, monitor and process restart: with several open duties, they may not follow the same one.
TEST(RuleMonitor, AgreesWithTheCheckerOnRandomHistories) {
    std::uint64_t broken = 0, compared = 0;
    for (std::uint64_t seed = 1; seed <= tests::rounds(40) && !HasFailure(); ++seed) {
        const CheckedRules rules = plain_rule(seed);
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + print(*rules.rules[0].written));
        std::unique_ptr<RuleProcess> process;
        try {
            process = std::make_unique<RuleProcess>(rules);
        } catch (const NotDecided&) {
            continue;  // nested prohibitions are not supported
        }
        ++compared;
        std::mt19937_64 random(seed);
        const std::size_t events = rules.events.size();
        std::optional<RuleMonitor> monitor(std::in_place, rules, WithoutLimit::eventually);
        RuleProcess::States states{0};
        const MeasureReadings values(rules.measures.size(), 0);
        for (int step = 0; step < 2000 && !HasFailure(); ++step) {
            const std::size_t drawn = random() % (2 * events);
            if (drawn < events)
                monitor->observe_event(drawn, values);
            else
                monitor->end_second();
            states = process->after(states, drawn < events ? rules.event_name(drawn) : "tock");
            const bool violated = !monitor->take_violations().empty();
            ASSERT_EQ(violated, process->broken(states)) << "step " << step;
            if (!violated) continue;
            ++broken;
            monitor.emplace(rules, WithoutLimit::eventually);
            states = {0};
        }
    }
    EXPECT_GT(broken, 100U);
    EXPECT_GT(compared, tests::rounds(40) / 2);
}

TEST(RuleMonitor, SaysWhatWasBroken) {
    Read read(
        with_definitions("A when Go and near then Stop within 2 seconds\nB when Halt then not Stop within 1 seconds"));
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    RuleMonitor monitor(*read.checked, WithoutLimit::eventually);
    monitor.observe_event(0, {0, 0, 0, 0});
    for (int i = 0; i < 4; ++i) monitor.end_second();
    EXPECT_TRUE(monitor.take_violations().empty()) << "nobody is near";
    monitor.observe_event(0, {1, 0, 0, 0});
    monitor.end_second();
    monitor.observe_event(2, {0, 0, 0, 0});
    monitor.end_second();
    monitor.observe_event(1, {0, 0, 0, 0});
    const std::vector<Violation> found = monitor.take_violations();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].rule, 1U);
    EXPECT_EQ(found[0].began, 5);
    EXPECT_EQ(found[0].second, 6);
    EXPECT_EQ(found[0].event, 1U);
    monitor.observe_event(0, {1, 0, 0, 0});
    for (int i = 0; i < 3; ++i) monitor.end_second();
    const std::vector<Violation> late = monitor.take_violations();
    ASSERT_EQ(late.size(), 1U);
    EXPECT_EQ(late[0].rule, 0U);
    EXPECT_EQ(late[0].second, 8);
    EXPECT_FALSE(late[0].event);
}

TEST(RuleMonitor, LeavesOpenWhatDependsOnAValueThatIsNotKnown) {
    Read read(with_definitions(
        "A when Go and near then Stop within 2 seconds\nB when Go and (near or not near) then Stop within 1 seconds"));
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    RuleMonitor monitor(*read.checked, WithoutLimit::eventually);
    monitor.observe_event(0, {std::nullopt, std::nullopt, std::nullopt, std::nullopt});
    EXPECT_EQ(monitor.open_triggers(), std::vector<std::size_t>{0}) << "B asks for the same whatever near is";
    for (int i = 0; i < 3; ++i) monitor.end_second();
    const std::vector<Violation> found = monitor.take_violations();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].rule, 1U);
}

}  // namespace
}  // namespace robochart::sleec
