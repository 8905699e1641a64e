// SPDX-License-Identifier: Apache-2.0
// Draws random claims, and gives for each claim a process that was written by hand in CSP.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "claims/checks/checked.hpp"

namespace robochart::claims::testing {

/// A channel of the claim's component, with the text of its events in the script.
struct NamedChannel {
    std::size_t channel = 0;
    std::string text;
};

/// Each process allows every event that does not yet break the claim. All contains the events and tock. SKIP means that
/// the component may terminate.
inline const char* const library = R"(RUNS(All) = ([] e : All @ e -> RUNS(All)) [] SKIP
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

/// A set of events, as the claim and as the process need it.
struct Drawn {
    Events events;
    std::string text;
};

class Draws {
public:
    Draws(std::uint32_t seed, std::vector<NamedChannel> channels) : random_(seed), channels_(std::move(channels)) {}
    int below(int limit) { return static_cast<int>(random_() % static_cast<std::uint32_t>(limit)); }
    Drawn set() {
        Drawn result;
        const int chosen = 1 + below((1 << channels_.size()) - 1);
        for (std::size_t i = 0; i < channels_.size(); ++i) {
            if ((chosen >> i) % 2 == 0) continue;
            result.events.any.emplace_back().channels = {channels_[i].channel};
            result.text += (result.text.empty() ? "" : ", ") + channels_[i].text;
        }
        result.text = "{| " + result.text + " |}";
        return result;
    }

    /// Returns the set of all events, with tock.
    [[nodiscard]] std::string all() const {
        std::string result;
        for (const NamedChannel& channel : channels_) result += channel.text + ", ";
        return "{| " + result + "tock |}";
    }

private:
    std::mt19937 random_;
    std::vector<NamedChannel> channels_;
};

/// Draws the claim's body, and returns the process over `all`.
inline std::string draw_body(Draws& draws, CheckedBody& body, const std::string& all) {
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

/// Draws the scope and the body of the claim, and returns its process.
inline std::string draw_claim(Draws& draws, CheckedClaim& claim) {
    const std::string all = draws.all();
    const Drawn first = draws.set(), last = draws.set();
    switch (draws.below(4)) {
        case 0:
            return draw_body(draws, claim.body, all);
        case 1:
            claim.scope = {ScopeKind::before, first.events, {}, 0, std::nullopt};
            return "FIRSTLY(" + all + ", " + first.text + ", " +
                   draw_body(draws, claim.body, "diff(" + all + ", " + first.text + ")") + ")";
        case 2:
            claim.scope = {ScopeKind::after, first.events, {}, 0, std::nullopt};
            return "SCOPE(" + all + ", " + first.text + ", {}, " + draw_body(draws, claim.body, all) + ")";
        default:
            claim.scope = {ScopeKind::after_until, first.events, last.events, 0, std::nullopt};
            return "SCOPE(" + all + ", " + first.text + ", " + last.text + ", " +
                   draw_body(draws, claim.body, "diff(" + all + ", " + last.text + ")") + ")";
    }
}

}  // namespace robochart::claims::testing
