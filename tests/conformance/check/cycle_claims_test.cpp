// SPDX-License-Identifier: Apache-2.0
// Tests claims about control cycles. They are decided for the model in cycles, which allows every order, and for the
// generated code.
#include "conformance/check/cycle_claims.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/diagnostics/render.hpp"
#include "claims/checks/check.hpp"
#include "claims/syntax/reader.hpp"
#include "conformance/check/conform.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

using testing::HasSubstr;

constexpr const char* head = R"(package robot
interface Motion { go() halt() reverse() brake() }
stm M {
	requires Motion
	event obstacle event estop event reset
	clock T
	initial start
)";

/// A stop leads out of a composite state. In the code, an inner transition may come before it.
constexpr const char* nested = R"(
	state Operating {
		initial j
		state Driving { }
		state Held { entry halt() }
		state Back { entry reverse() }
		transition begin { from j to Driving }
		transition met { from Driving to Held trigger obstacle #T }
		transition late { from Held to Back condition since(T) >= 2 }
	}
	state Emergency { entry brake() }
	transition begin { from start to Operating }
	transition stop { from Operating to Emergency trigger estop }
	transition resume { from Emergency to Operating trigger reset }
})";

/// A machine without nested states, in which stop is the first transition of each state. A reset waits for the next
/// cycle.
constexpr const char* flat = R"(
	state Driving { }
	state Held { entry halt() }
	state Emergency { entry brake() }
	transition begin { from start to Driving }
	transition stop1 { from Driving to Emergency trigger estop #T }
	transition stop2 { from Held to Emergency trigger estop #T }
	transition stop3 { from Emergency to Emergency trigger estop #T }
	transition met { from Driving to Held trigger obstacle }
	transition resume { from Emergency to Driving trigger reset condition since(T) >= 1 }
})";

std::string word(const CycleAnswer& answer) {
    if (answer.outcome == Outcome::conforms) return "holds";
    return answer.outcome == Outcome::differs ? "fails" : "inconclusive: " + answer.reason;
}

/// The order of events in a cycle, and a fault of the code that ignores this order.
struct Order {
    bool first = false, drops = false;
    std::optional<std::uint32_t> ignored_at = std::nullopt;  ///< where the code ignores the order
};

Result result_of(const std::string& machine, const std::vector<std::string>& claims, const Order& order = {}) {
    const test::ModelFolder folder(std::string(head) + machine);
    test::Model model(folder.path());
    std::string text;
    for (std::size_t i = 0; i < claims.size(); ++i) text += "claim C" + std::to_string(i) + " : " + claims[i] + "\n";
    diagnostics::Diagnostics found;
    const auto file = std::make_shared<const claims::ClaimFile>(
        claims::read(model.sources, model.sources.add("m.claims", text), found));
    const claims::CheckedClaims checked =
        claims::check_claims({file}, {model.system, {"robot"}, {}}, model.sources, found);
    EXPECT_TRUE(found.ok()) << diagnostics::render_text(model.sources, found);
    Options options;
    options.claims = std::make_shared<const CycleClaims>(CycleClaims{checked.claims, checked.unit, true});
    const ir::ComponentRef component = model.machine_named("M");
    const std::vector<ir::Event>& events = model.system.machines[component.definition].events;
    const auto estop =
        static_cast<std::uint32_t>(std::ranges::find(events, "estop", &ir::Event::name) - events.begin());
    if (order.first) options.generator.order.first[component.definition] = {ir::EventId{estop}};
    const auto number = [&](const char* name) {
        return static_cast<std::uint32_t>(std::ranges::find(events, name, &ir::Event::name) - events.begin());
    };
    if (order.drops) options.generator.order.drops = {{"estop", "reset", number("estop"), number("reset")}};
    if (order.ignored_at) {
        options.generator.fault = cpp_emit::Fault::order_ignored;
        options.generator.fault_site = *order.ignored_at;
    }
    Result result = conform(model.system, model.instantiation, component, options, model.sources, found);
    EXPECT_TRUE(!result.api_difference || order.ignored_at) << "dispatch differs from step";
    return result;
}

std::vector<CycleAnswers> answers_to(const std::string& machine, const std::vector<std::string>& claims,
                                     const Order& order = {}) {
    const Result result = result_of(machine, claims, order);
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    EXPECT_EQ(result.claims.size(), claims.size());
    return result.claims;
}

/// A claim with its answers for the model in cycles and for the code.
struct Row {
    const char* claim;
    const char* model;
    const char* code;
};

void expect_answers(const std::string& machine, const std::vector<Row>& rows, const Order& order = {}) {
    std::vector<std::string> claims;
    for (const Row& row : rows) claims.emplace_back(row.claim);
    const std::vector<CycleAnswers> answers = answers_to(machine, claims, order);
    for (std::size_t i = 0; i < answers.size(); ++i) {
        EXPECT_EQ(word(answers[i].model), rows[i].model) << rows[i].claim << "\n" << answers[i].model.reason;
        EXPECT_EQ(word(answers[i].code), rows[i].code) << rows[i].claim << "\n" << answers[i].code.reason;
    }
}

TEST(CycleClaims, OfANestedStop) {
    expect_answers(nested, {
                               // There are two counterexamples. With obstacle and estop in one cycle, the robot halts
                               // and then brakes. With estop in a cycle in which the timeout is due, it reverses and
                               // then brakes.
                               {"in a cycle with estop, any call but brake only after brake", "fails", "fails"},
                               // with estop and reset, it brakes and returns to Operating
                               {"in a cycle with estop, always in Emergency", "fails", "fails"},
                               {"in a cycle with estop, always in Emergency or in Operating", "holds", "holds"},
                               {"in a cycle with estop, at most 2 any call", "fails", "fails"},
                               {"in a cycle with estop, at most 3 any call", "holds", "holds"},  // reverse, brake, halt
                               {"in a cycle with obstacle, never go", "holds", "holds"},
                               // if estop comes in Emergency, it is ignored, so nothing brakes
                               {"raised estop leads to brake within 0 units", "fails", "fails"},
                           });
}

TEST(CycleClaims, HoldByTheOrderOfTheCodeAlone) {
    expect_answers(flat, {
                             {"in a cycle with estop, any call but brake only after brake", "fails", "holds"},
                             {"in a cycle with estop, always in Emergency", "holds", "holds"},
                             {"raised estop leads to brake within 0 units", "holds", "holds"},
                         });
}

/// With only estop raised, a timeout that is due comes first. The run shows its cycles, and the answer shows what broke
/// the claim.
TEST(CycleClaims, AreShownInCycles) {
    const auto answers = answers_to(nested, {"in a cycle with estop, any call but brake only after brake"});
    ASSERT_EQ(answers.size(), 1U);
    const CycleAnswer& code = answers[0].code;
    ASSERT_FALSE(code.cycles.empty());
    EXPECT_THAT(code.cycles.back().inputs, testing::Contains("estop"));
    EXPECT_THAT(code.reason, HasSubstr("and no brake came before"));
}

/// If estop and reset come in one cycle, estop ends the scope before reset begins it, for any order in which the
/// registers are read. Then the robot brakes in the new scope.
TEST(CycleClaims, RaisedEventsAreSimultaneous) {
    expect_answers(nested, {{"after raised reset until raised estop, never brake", "fails", "fails"},
                            {"after raised reset until raised estop, never halt", "fails", "fails"},
                            {"after raised estop until raised reset, never brake", "fails", "fails"}});
}

constexpr const char* brakes_first = "in a cycle with estop, any call but brake only after brake";
constexpr const char* stops = "in a cycle with estop, always in Emergency";

/// Code with a declared order conforms. The order changes the answers to the claims about the code.
TEST(CycleClaims, AreTurnedByAnOrder) {
    expect_answers(nested, {{brakes_first, "fails", "fails"}, {stops, "fails", "fails"}});
    expect_answers(nested, {{brakes_first, "fails", "holds"}, {stops, "fails", "fails"}}, {.first = true});
    expect_answers(nested, {{brakes_first, "fails", "fails"}, {stops, "holds", "holds"}}, {.drops = true});
    expect_answers(nested, {{brakes_first, "fails", "holds"}, {stops, "holds", "holds"}},
                   {.first = true, .drops = true});
}

/// Without the order, a cycle with reset may end in Emergency, if reset is taken first, and then estop. A dropped reset
/// does not count as raised, neither for the model nor for the code.
TEST(CycleClaims, DoNotCountWhatIsDropped) {
    const char* const resumes = "in a cycle with reset, always in Operating";
    expect_answers(nested, {{resumes, "fails", "fails"}});
    expect_answers(nested, {{resumes, "holds", "holds"}}, {.drops = true});
}

/// Code may ignore the order in the transitions, in the cycle, or in `dispatch`. In each case, it differs from the
/// model under the filter, or violates a claim.
TEST(CycleClaims, KillCodeThatIgnoresTheOrder) {
    for (const std::uint32_t place : {0U, 1U, 2U}) {
        const Result result =
            result_of(nested, {brakes_first, stops}, {.first = true, .drops = true, .ignored_at = place});
        const bool broken = std::ranges::any_of(
            result.claims, [](const CycleAnswers& claim) { return claim.code.outcome == Outcome::differs; });
        EXPECT_TRUE(broken || result.outcome == Outcome::differs) << place;
    }
}

}  // namespace
}  // namespace robochart::conformance
