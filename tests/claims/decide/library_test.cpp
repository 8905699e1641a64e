// SPDX-License-Identifier: Apache-2.0
// The processes of claims against processes of the same meaning that are written by hand in CSP.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "claims/decide/automaton.hpp"
#include "claims/decide/decision.hpp"

namespace robochart::claims {
namespace {

namespace build = cspm::build;

/// Each process lets everything happen that breaks nothing yet. All: the events with tock. SKIP: the component may end.
const char* const library = R"(channel a, b, c, tock
All = {a, b, c, tock}

RUNS(All) = ([] e : All @ e -> RUNS(All)) [] SKIP
NEVER(All, X) = ([] e : diff(All, X) @ e -> NEVER(All, X)) [] SKIP
ONLYAFTER(All, X, B) = ([] e : diff(All, X) @ e -> if member(e, B) then RUNS(All) else ONLYAFTER(All, X, B)) [] SKIP
FORAFTER(All, A, X, D) = ([] e : All @ e -> if member(e, A) then HELD(All, A, X, D, D) else FORAFTER(All, A, X, D)) [] SKIP
HELD(All, A, X, D, n) = ([] e : diff(All, X) @ e ->
	if member(e, A) then HELD(All, A, X, D, D)
	else if e != tock then HELD(All, A, X, D, n)
	else if n == 0 then FORAFTER(All, A, X, D) else HELD(All, A, X, D, n - 1)) [] SKIP
WITHIN(All, A, B, D, G) = ([] e : All @ e -> if member(e, A) then DUE(All, A, B, D, G, D) else WITHIN(All, A, B, D, G)) [] SKIP
DUE(All, A, B, D, G, n) =
	(if n == 0 then STOP else tock -> DUE(All, A, B, D, G, n - 1))
	[] ([] e : diff(All, {tock}) @ e ->
		if member(e, union(B, G)) then (if member(e, A) then DUE(All, A, B, D, G, D) else WITHIN(All, A, B, D, G))
		else DUE(All, A, B, D, G, n))
ORDER(All, A, B, Z) = ([] e : All @ e -> if member(e, A) then OWES(All, A, B, Z) else ORDER(All, A, B, Z)) [] SKIP
OWES(All, A, B, Z) = ([] e : diff(All, diff(Z, B)) @ e ->
	if member(e, B) then (if member(e, A) then OWES(All, A, B, Z) else ORDER(All, A, B, Z)) else OWES(All, A, B, Z)) [] SKIP
ATMOST(All, X, n) = ([] e : (if n == 0 then diff(All, X) else All) @ e -> ATMOST(All, X, if member(e, X) then n - 1 else n)) [] SKIP
WINDOWED(All, X, N, D, ages) =
	([] e : (if length(ages) == N then diff(All, X) else All) @ e ->
		if e == tock then WINDOWED(All, X, N, D, < age + 1 | age <- ages, age < D >)
		else if member(e, X) then WINDOWED(All, X, N, D, <0> ^ ages) else WINDOWED(All, X, N, D, ages)) [] SKIP
EVERYN(All, X, D, n) = (if n == 0 then STOP else tock -> EVERYN(All, X, D, n - 1))
	[] ([] e : diff(All, {tock}) @ e -> if member(e, X) then EVERYN(All, X, D, D) else EVERYN(All, X, D, n))
SUPPORT(All, X, B, D, left) = ([] e : (if left < 0 then diff(All, X) else All) @ e ->
	if member(e, B) then SUPPORT(All, X, B, D, D)
	else if e == tock then SUPPORT(All, X, B, D, if left < 0 then left else left - 1)
	else SUPPORT(All, X, B, D, left)) [] SKIP
SCOPE(All, S, Z, Body) = ([] e : All @ e -> if member(e, S) then INSCOPE(All, S, Z, Body) else SCOPE(All, S, Z, Body)) [] SKIP
INSCOPE(All, S, Z, Body) = Body /\ ([] z : Z @ z -> if member(z, S) then INSCOPE(All, S, Z, Body) else SCOPE(All, S, Z, Body))
FIRSTLY(All, Z, Body) = Body /\ ([] z : Z @ z -> RUNS(All))
)";

const std::vector<std::string> names{"a", "b", "c"};

/// A set of events, for the claim and for the process.
struct Drawn {
    Events events;
    std::string text;
};

class Draws {
public:
    explicit Draws(std::uint32_t seed) : random_(seed) {}
    int below(int limit) { return static_cast<int>(random_() % static_cast<std::uint32_t>(limit)); }
    Drawn set() {
        Drawn result;
        const int chosen = 1 + below(7);
        for (std::size_t i = 0; i < names.size(); ++i) {
            if ((chosen >> i) % 2 == 0) continue;
            result.events.any.push_back({{i}, std::nullopt, "", {}});
            result.text += (result.text.empty() ? "" : ", ") + names[i];
        }
        result.text = "{" + result.text + "}";
        return result;
    }

private:
    std::mt19937 random_;
};

/// The claim's body, and the process over `all`.
std::string draw_body(Draws& draws, CheckedBody& body, const std::string& all) {
    const Drawn x = draws.set(), y = draws.set(), z = draws.set();
    const int limit = draws.below(3);
    const std::string number = std::to_string(limit);
    body.events = x.events;
    switch (draws.below(8)) {
        case 0:
            body.kind = BodyKind::never;
            return "NEVER(" + all + ", " + x.text + ")";
        case 1:
            body.kind = BodyKind::only_after;
            body.others = y.events;
            return "ONLYAFTER(" + all + ", " + x.text + ", " + y.text + ")";
        case 2:
            body.kind = BodyKind::only_within;
            body.others = y.events;
            body.units = limit;
            return "SUPPORT(" + all + ", " + x.text + ", " + y.text + ", " + number + ", -1)";
        case 3:
            body.kind = BodyKind::leads_within;
            body.others = y.events;
            body.exceptions = z.events;
            body.units = limit;
            return "WITHIN(" + all + ", " + x.text + ", " + y.text + ", " + number + ", " + z.text + ")";
        case 4:
            body.kind = BodyKind::leads_before;
            body.others = y.events;
            body.exceptions = z.events;
            return "ORDER(" + all + ", " + x.text + ", " + y.text + ", " + z.text + ")";
        case 5:
            body.kind = BodyKind::at_least;
            body.others = y.events;
            body.units = limit + 1;
            return "FORAFTER(" + all + ", " + y.text + ", " + x.text + ", " + number + ")";
        case 6:
            body.kind = BodyKind::at_most;
            body.count = 1 + draws.below(2);
            if (draws.below(2) == 0) return "ATMOST(" + all + ", " + x.text + ", " + std::to_string(body.count) + ")";
            body.units = limit;
            return "WINDOWED(" + all + ", " + x.text + ", " + std::to_string(body.count) + ", " + number + ", <>)";
        default:
            body.kind = BodyKind::every;
            body.units = limit;
            return "EVERYN(" + all + ", " + x.text + ", " + number + ", " + number + ")";
    }
}

/// The claim, and its process.
std::string draw_claim(Draws& draws, CheckedClaim& claim) {
    for (const std::string& name : names) claim.component.channels.push_back({name, ChannelKind::input, {}});
    const Drawn first = draws.set(), last = draws.set();
    switch (draws.below(4)) {
        case 0:
            return draw_body(draws, claim.body, "All");
        case 1:
            claim.scope = {ScopeKind::before, first.events, {}, 0};
            return "FIRSTLY(All, " + first.text + ", " + draw_body(draws, claim.body, "diff(All, " + first.text + ")") +
                   ")";
        case 2:
            claim.scope = {ScopeKind::after, first.events, {}, 0};
            return "SCOPE(All, " + first.text + ", {}, " + draw_body(draws, claim.body, "All") + ")";
        default:
            claim.scope = {ScopeKind::after_until, first.events, last.events, 0};
            return "SCOPE(All, " + first.text + ", " + last.text + ", " +
                   draw_body(draws, claim.body, "diff(All, " + last.text + ")") + ")";
    }
}

TEST(ClaimProcesses, HaveTheTracesOfTheLibrary) {
    std::vector<Letter> letters;
    for (std::size_t i = 0; i < names.size(); ++i)
        letters.push_back({{i, {}}, names[i], build::name(names[i]), names[i]});
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    cspm::Script script = cspm::read(sources, sources.add("library.csp", library), diagnostics);
    ASSERT_TRUE(diagnostics.ok());
    script.decls.push_back(shared_channels());
    Draws draws(7);
    std::vector<std::pair<cspm::DeclPtr, std::string>> assertions;
    for (std::size_t number = 0; number < 400; ++number) {
        CheckedClaim claim;
        const std::string text = draw_claim(draws, claim);
        const Automaton automaton = make_automaton(claim, letters, nullptr);
        const Decision decision = decide_by_processes(claim, letters, automaton, number, build::stop(), {});
        script.decls.insert(script.decls.end(), decision.declarations.begin(), decision.declarations.end());
        const std::string name = "L" + std::to_string(number);
        const cspm::Script one = cspm::read(sources, sources.add(name, name + " = " + text + "\n"), diagnostics);
        script.decls.push_back(one.decls.front());
        const cspm::ExprPtr monitor = decision.holds->assertion.specification;
        for (const cspm::DeclPtr& assertion :
             {build::assert_refines(monitor, cspm::Model::traces, build::name(name)),
              build::assert_refines(build::name(name), cspm::Model::traces, monitor)}) {
            script.decls.push_back(assertion);
            assertions.emplace_back(assertion, text);
        }
    }
    ASSERT_TRUE(diagnostics.ok());
    cspm::Session session(script);
    for (const auto& [assertion, text] : assertions)
        EXPECT_EQ(session.check(*assertion, {}).verdict.outcome, refine::Outcome::holds) << text;
}

}  // namespace
}  // namespace robochart::claims
