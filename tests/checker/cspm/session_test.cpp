// SPDX-License-Identifier: Apache-2.0
// Decides the assertions of whole scripts. Comments give the argument for each verdict.
#include "checker/cspm/session.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "checker/symbolic/stage.hpp"
#include "tests/checker/cspm/outcomes.hpp"

namespace robochart::cspm::test {
namespace {

TEST(SessionTest, RefinementInEachModel) {
    expect_outcomes(R"(channel a, b
P = a -> STOP [] b -> STOP
Q = a -> STOP |~| b -> STOP
-- Q's traces are P's; Q may refuse a, P may not; neither diverges.
assert P [T= Q
assert P [F= Q
assert Q [F= P
assert Q [FD= P
assert not P [F= Q
)",
                    "hfhhh");
}

// The 8 states of each operand of P give 8^6 states before the first event. P accepts all of h, or one event of d.
TEST(SessionTest, ChoicesOverInternalChoicesAreNotMultipliedOut) {
    const Reading reading(R"(channel h, d, x : {1..6}
P = [] e : {|h|} @ (e -> P |~| (|~| f : {|d|} @ f -> P))
ALL = h?i -> ALL
MOST = h?i:{2..6} -> MOST
DROPS = d.3 -> DROPS
assert P [F= ALL
assert P [FD= DROPS
assert P [T= MOST
assert P [F= MOST
assert P [FD= x.1 -> STOP
)");
    for (const std::optional<std::size_t> from_terms : {std::optional<std::size_t>(), std::optional<std::size_t>(0)}) {
        Session session(reading.script);
        session.set_packing({from_terms, std::nullopt, false});
        refine::Limits limits;
        limits.max_states = 2000;
        std::string found;
        for (const DeclPtr& assertion : session.assertions())
            found += outcome_letter(session.check(*assertion, limits).verdict.outcome);
        EXPECT_EQ(found, "hhhff") << (from_terms ? "packed" : "terms");
    }
}

TEST(SessionTest, Properties) {
    expect_outcomes(R"(channel a : {0..2}
P(n) = a.n -> P((n+1)%3)
L = a.0 -> L
-- P(0) goes round for ever with one event at a time.
assert P(0) :[deadlock free [F]]
assert P(0) :[deterministic [FD]]
-- Hiding all of L leaves a tau loop.
assert L \ {a.0} :[divergence free]
-- The trace 0,1 is P(0)'s, 0,2 is not.
assert P(0) :[has trace [T]]: <a.0, a.1>
assert P(0) :[has trace [T]]: <a.0, a.2>
assert a.0 -> STOP :[deadlock free]
)",
                    "hhfhff");
}

TEST(SessionTest, LetAndModulesAndInstances) {
    expect_outcomes(R"(module Cell(T)
  start = 0
exports
  channel put, get : T
  C = put?x -> get!x -> C
  Zero = get!start -> STOP
endmodule
instance Small = Cell({0,1})
-- A cell gives back what it was given.
assert let P = Small::put.0 -> Small::get.0 -> P
           R = Small::put.1 -> Small::get.1 -> R
       within P [] Small::put.1 -> Small::get.1 -> STOP [T= let n = 0 within Small::put.n -> Small::get.n -> STOP
assert Small::C :[has trace [T]]: <Small::put.1, Small::get.0>
assert Small::Zero :[has trace [T]]: <Small::get.0>
)",
                    "hfh");
}

std::vector<AssertionResult> results(const std::string& text, const refine::Limits& limits) {
    Reading reading(text);
    (void)check_types(reading.script, reading.diagnostics);
    EXPECT_TRUE(reading.ok()) << reading.report();
    Session session(reading.script);
    std::vector<AssertionResult> all;
    for (const DeclPtr& assertion : session.assertions()) all.push_back(session.check(*assertion, limits));
    return all;
}

// Five components with three hidden steps each have 4^5 states. If confluent taus are followed, one of them remains.
// The reduced form has a trace if and only if the whole system has it.
TEST(SessionTest, ATraceIsLookedForInTheReducedForm) {
    const std::string text = R"(channel step : {0..4}.{0..2}
channel done, other
C(i) = step.i.0 -> step.i.1 -> step.i.2 -> SKIP
System = ((||| i : {0..4} @ C(i)) ; (done -> STOP |~| done -> done -> STOP)) \ {|step|}
assert System :[has trace [T]]: <done, done>
assert System :[has trace [T]]: <done, other>
assert System :[has trace [F]]: <done>
assert System :[has trace [F]]: <done, done>
)";
    refine::Limits fewer_states;
    fewer_states.reduction = true;
    refine::Limits all_states;
    all_states.reduction = false;
    const std::vector<AssertionResult> reduced = results(text, fewer_states);
    const std::vector<AssertionResult> whole = results(text, all_states);
    using refine::Outcome;
    const std::vector<Outcome> expected{Outcome::holds, Outcome::fails, Outcome::holds, Outcome::inconclusive};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(reduced.at(i).verdict.outcome, expected[i]) << i;
        EXPECT_EQ(whole.at(i).verdict.outcome, expected[i]) << i;
        EXPECT_EQ(reduced.at(i).verdict.reason, whole.at(i).verdict.reason);
        EXPECT_LT(reduced.at(i).verdict.statistics.states, 30U) << i;
        EXPECT_GT(whole.at(i).verdict.statistics.states, 1000U) << i;
    }
    const auto& shown = reduced.at(1).verdict.counterexample.value();
    EXPECT_EQ(shown.steps.size(), whole.at(1).verdict.counterexample.value().steps.size()) << "the shortest run";
}

// A hidden step of a reader excludes the writer, so every proof that the step is confluent fails. Each failed proof
// examines thousands of states of the lock and the readers, so the search must stop trying.
TEST(SessionTest, AReductionWhoseProofsFailIsGivenUp) {
    const std::string text = R"(R = {1..8}
channel begin, read, end : R
channel beginWrite, write, endWrite
Lock(n, writing) = (not writing and n < 8) & begin?r -> Lock(n + 1, writing) [] n > 0 & end?r -> Lock(n - 1, writing)
  [] (n == 0 and not writing) & beginWrite -> Lock(n, true) [] writing & endWrite -> Lock(n, false)
Reader(r) = begin.r -> read.r -> end.r -> Reader(r)
Writer = beginWrite -> write -> endWrite -> Writer
Locking = {|begin, end, beginWrite, endWrite|}
Any = read?r -> Any [] write -> Any
assert Any [T= (((||| r : R @ Reader(r)) ||| Writer) [| Locking |] Lock(0, false)) \ Locking
)";
    refine::Limits limits;
    limits.reduction = true;
    const refine::Verdict verdict = results(text, limits).at(0).verdict;
    EXPECT_EQ(verdict.outcome, refine::Outcome::holds);
    EXPECT_EQ(verdict.statistics.states, 6563U);  // 3^8 states of the readers, and the writer before and after writing
    EXPECT_EQ(verdict.statistics.chased, 0U);
}

// Each initial event leads to different components. If the compiler decomposed the process, it would create several
// hundred components for a dozen states.
TEST(SessionTest, AProcessOfFewStatesIsNotTakenApart) {
    Reading reading(R"(channel a, b, c : {0..3}
channel stop
Small = a?x -> b?y -> c?z -> ((stop -> SKIP ||| stop -> SKIP) ; Small)
)");
    (void)check_types(reading.script, reading.diagnostics);
    ASSERT_TRUE(reading.ok()) << reading.report();
    Session session(reading.script);
    EXPECT_TRUE(session.system(build::name("Small"))->states_are_terms());
}

/// An instance is a copy of its module's declarations. The budget is polled while instances are created.
TEST(SessionTest, InstancesAreMadeWithinABudget) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    std::string text = "module M(n)\n x = n + 1\nexports\n y = x * 2\nendmodule\n";
    for (int i = 0; i < 200; ++i) text += "instance I" + std::to_string(i) + " = M(" + std::to_string(i) + ")\n";
    const Script script = read(sources, sources.add("s.csp", text), findings);
    ASSERT_TRUE(findings.ok());
    diagnostics::Budget budget;
    EXPECT_NO_THROW(Session(script, &budget));
    budget.interrupt();
    EXPECT_THROW(Session(script, &budget), diagnostics::LimitReached);
    findings.set_budget(&budget);
    EXPECT_THROW((void)check_types(script, findings), diagnostics::LimitReached);
}

/// P alone has a thousand states, but the whole process reaches only five of them. The limit applies to the states of
/// the check.
TEST(SessionTest, LargeComponentsWithinSmallChecksAreDecided) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const Script script =
        read(sources,
             sources.add("s.csp",
                         "channel a : {0..999}\nP(n) = a!n -> P((n + 1) % 1000)\n"
                         "Q(n) = n < 4 & a!n -> Q(n + 1)\nassert P(0) [|{|a|}|] Q(0) :[deadlock free]\n"),
             findings);
    ASSERT_TRUE(findings.ok());
    for (const std::uint64_t most : {std::uint64_t{20}, std::uint64_t{100'000}}) {
        Session session(script);
        refine::Limits limits;
        limits.max_states = most;
        EXPECT_EQ(session.check(*session.assertions().front(), limits).verdict.outcome, refine::Outcome::fails) << most;
    }
}

// In a timed section with zero durations, tock is always possible while an event waits, and timed_priority lets no time
// pass while a tau is possible (semantics 3.10).
TEST(SessionTest, TimedSections) {
    expect_outcomes(R"(channel a, b, tock
OneStep(_) = 0
USTOP = STOP
Timed(OneStep) {
  Wait = a -> SKIP
  Two = WAIT(2); a -> STOP
  Urgent = timed_priority((a -> b -> STOP) \ {a})
  Dead = timed_priority(a -> SKIP [] (WAIT(1); USTOP))
  Both = (a -> STOP) ||| (b -> STOP)
}
-- Time may pass before a.
assert Wait :[has trace [T]]: <tock, tock, a>
-- WAIT(2) lets a happen after two tocks only.
assert Two :[has trace [T]]: <tock, tock, a>
assert Two :[has trace [T]]: <tock, a>
-- The hidden a happens before time passes, then b waits.
assert Urgent :[has trace [T]]: <tock>
assert Urgent :[has trace [T]]: <b>
-- One unit passes, then WAIT's end, a tau, comes before time: nothing but a is left.
assert Dead :[has trace [T]]: <tock, tock>
assert Dead :[has trace [T]]: <tock, a>
-- Interleaved processes agree on tock: it does not resolve the choice of who goes first.
assert Both :[has trace [T]]: <tock, b, tock, a>
-- STOP lets time pass for ever.
assert Both :[deadlock free]
)",
                    "hhfhhfhhh");
}

TEST(SessionTest, LinkedParallelHidesTheLink) {
    expect_outcomes(R"(channel l, r : {0,1}
Copy = l?x -> r!x -> Copy
Two = Copy [r <-> l] Copy
Buffer(s) = (#s < 2 & l?x -> Buffer(s^<x>)) [] (#s > 0 & r!head(s) -> Buffer(tail(s)))
-- Two one-place cells in a chain are a two-place buffer.
assert Buffer(<>) [FD= Two
assert Two [FD= Buffer(<>)
)",
                    "hh");
}

TEST(SessionTest, RenamingIsRelational) {
    expect_outcomes(R"(channel a, b, c
P = (a -> STOP)[[ a <- b, a <- c ]]
assert P :[has trace [T]]: <b>
assert P :[has trace [T]]: <c>
assert P :[has trace [T]]: <a>
)",
                    "hhf");
}

// c$x chooses x internally. c?x leaves the choice to the environment.
TEST(SessionTest, NondeterministicInput) {
    expect_outcomes(R"(channel c : {0,1}
assert c?x -> STOP [F= c$x -> STOP
assert c$x -> STOP [F= c?x -> STOP
)",
                    "fh");
}

// R passes a lambda to its recursive call. The lambda stays the same value, so R is one state.
TEST(SessionTest, FunctionsAsArgumentsHaveOneIdentity) {
    expect_outcomes(R"(channel c : {0..3}
Q(k) = c.k -> Q(k)
R(f) = c.f(0) -> R(f)
assert Q(1) [FD= R(\ x @ 1)
assert R(\ x @ 1) :[deterministic [FD]]
)",
                    "hh");
}

TEST(SessionTest, UnusedValuesAreNotEvaluated) {
    EXPECT_EQ(value("let y = error(\"y\")\n f(a, b) = b within f(y, 2)"), "2");
    EXPECT_EQ(value("let y = 1/0 within 3"), "3");
    EXPECT_EQ(value("card({x | x <- {1..9}, x > 5}) + (if false then head(<>) else 0)"), "4");
    EXPECT_EQ(value("member(5, Int) and member(<1,2>, Seq({1..2})) and not member(0, {1..})"), "true");
}

TEST(SessionTest, ValuesPrintAsInFdr) {
    EXPECT_EQ(value("<(x, y) | x <- <1..2>, y <- <true>>"), "<(1, true), (2, true)>");
    EXPECT_EQ(value("Union({{1}, {3, 2}})"), "{1, 2, 3}");
    EXPECT_EQ(value("(-7) / 2 + (-7) % 2"), "-3");  // floor division: -4, remainder 1
    EXPECT_EQ(value("mapLookup(mapUpdate((| 1 => 2 |), 3, 4), 3)"), "4");
    EXPECT_EQ(value("let f(0) = 1\n f(n) = n * f(n-1) within f(20)"), "2432902008176640000");
}

TEST(SessionTest, FaultsAreNamed) {
    EXPECT_EQ(failure_of("x = 1/0\n", "x").message, "division by zero");
    EXPECT_EQ(failure_of("f(0) = 1\nx = f(1)\n", "x").message, "no clause of 'f' matches (1)");
    EXPECT_EQ(failure_of("g(n) = error(\"no \"^show(n))\nx = g(3)\n", "x").message, "error: no 3");
    EXPECT_GE(failure_of("g(n) = error(\"no\")\nx = g(3)\n", "x").stack, 2U);
    EXPECT_EQ(failure_of("x = y\n", "x").message, "'y' is not in scope");
    EXPECT_EQ(failure_of("x = x\n", "x").message, "'x' is defined by itself");
    EXPECT_EQ(failure_of("x = card(Int)\n", "x").message, "the set Int is infinite");
    EXPECT_EQ(failure_of("x = 9223372036854775807 + 1\n", "x").message, "the number does not fit in 64 bits");
    EXPECT_EQ(failure_of("x = diamond(STOP)\n", "x").message, "'diamond' must be declared transparent before use");
    EXPECT_EQ(failure_of("f(n) = 1 + f(n+1)\nx = f(0)\n", "x").message,
              "evaluation nests too deeply: runaway recursion?");
    EXPECT_EQ(failure_of("channel c : {0,1}\nx = c.2\n", "x").message,
              "2 is not a value of its field in c.2 (the field's type is {0, 1})");
}

// The first evaluation leaves values half evaluated, and the second evaluation encounters them.
TEST(SessionTest, AFaultIsTheSameWhenAskedAgain) {
    const Reading reading(R"(channel c : {0..1/0}
datatype D = A.{0..1/0}
x = c.0
y = card(D)
z = let v = 1/0 within v + v
)");
    ASSERT_TRUE(reading.ok()) << reading.report();
    Session session(reading.script);
    for (const char* name : {"x", "y", "z"})
        for (int time = 0; time < 2; ++time) {
            try {
                (void)session.evaluate(build::name(name));
                ADD_FAILURE() << name << " has a value";
            } catch (const EvaluationError& error) {
                EXPECT_STREQ(error.what(), "division by zero") << name;
            }
        }
}

// Each part chooses a hidden event about 100 times between two visible ones, so the parts together have more than
// 1,000,000 states. A compressed part has one state. The test delays the decision diagrams: on a slow machine they
// would answer before the search has enough states to compress the parts.
TEST(SessionTest, PartsAreCompressedIfManyStatesGiveNoAnswer) {
    const Reading reading(R"(channel h : {0..1}
channel a, b, c
Steps(n, k, most, e) = if n == most then e -> Steps(0, 0, most, e) else h?i -> Steps(n + 1, i, most, e)
Echo = h?i -> Echo
Part(most, e) = (Steps(0, 0, most, e) [| {|h|} |] Echo) \ {|h|}
Parts = Part(100, a) ||| Part(101, b) ||| Part(99, c)
Two = a -> Two [] b -> Two
Three = a -> Three [] b -> Three [] c -> Three
assert Three [FD= Parts
assert Two [T= Parts
)");
    Session session(reading.script);
    refine::Limits limits;
    limits.reduction = true;
    symbolic::DiagramStage late({.delay = std::chrono::hours(1)});
    limits.symbolic = &late;
    const auto assertions = session.assertions();
    const refine::Verdict holds = session.check(*assertions.at(0), limits).verdict;
    EXPECT_EQ(holds.outcome, refine::Outcome::holds) << holds.reason;
    EXPECT_EQ(holds.statistics.decided_by, refine::DecidedBy::compressed_parts);
    EXPECT_LT(holds.statistics.states, 10U);
    // The counterexample has its complete run: c happens after 99 hidden steps.
    const refine::Verdict fails = session.check(*assertions.at(1), limits).verdict;
    ASSERT_EQ(fails.outcome, refine::Outcome::fails) << fails.reason;
    EXPECT_EQ(fails.statistics.decided_by, refine::DecidedBy::search);
    EXPECT_EQ(fails.counterexample->steps.size(), 100U);
    limits.reduction = false;
    limits.max_states = 100'000;
    EXPECT_EQ(session.check(*assertions.at(0), limits).verdict.outcome, refine::Outcome::inconclusive);
}

TEST(SessionTest, RoboToolTimedAssertions) {
    const auto shared = shared_folder();
    if (shared.empty()) GTEST_SKIP() << "the folder of shared scripts is absent";
    const auto file = shared / "suite" / "robotool-csp-2026" / "timed" / "RC_simplified_assertions.csp";
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics found;
    Session session(read_file(sources, file.string(), found));
    ASSERT_TRUE(found.ok());
    // The script's authors state that model and specification are equal. A0 and A2 are the two directions in FD. A1 and
    // A3 state the same in tick-tock, through prioritisepo.
    for (const DeclPtr& assertion : session.assertions()) {
        if (assertion->assertion.model != Model::failures_divergences) continue;
        EXPECT_EQ(session.check(*assertion, {}).verdict.outcome, refine::Outcome::holds);
    }
    // Spec does not refine a process without events.
    const ExprPtr nothing = build::call("RUN", {build::set({})});
    const Decl wrong = *build::assert_refines(nothing, Model::failures_divergences, build::name("Spec"));
    EXPECT_EQ(session.check(wrong, {}).verdict.outcome, refine::Outcome::fails);
}

}  // namespace
// The memory has 12 * 12 * 12 vectors of values. In a compression around it, its variables stay separate components, so
// that none of these vectors becomes a term. The user reads only the first variable.
TEST(SessionCompression, KeepsIndependentPartsOfAnOperandApart) {
    const std::string memory =
        "channel get, set : {0..2}.{0..11}\nchannel stop, out\ntransparent dbisim\n"
        "M(i,x) = get!i!x -> M(i,x) [] set.i?y -> M(i,y) [] stop -> SKIP\n"
        "Memory = M(0,0) [| {stop} |] (M(1,0) [| {stop} |] M(2,0))\n"
        "User = get.0?x -> (if x == 3 then out -> User else set.0!((x + 1) % 5) -> User) [] stop -> SKIP\n"
        "Plain = (User [| {| get, set, stop |} |] Memory) \\ {| get, set |}\n"
        "Compressed = dbisim((User [| {| get, set, stop |} |] dbisim(Memory)) \\ {| get, set |})\n";
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const std::string text = memory + "assert Plain [FD= Compressed\nassert Compressed [FD= Plain\n";
    cspm::Session session(cspm::read(sources, sources.add("s.csp", text), findings));
    ASSERT_TRUE(findings.ok());
    (void)session.system(build::name("Compressed"));
    EXPECT_LT(session.terms().size(), 1000U);
    for (const cspm::DeclPtr& assertion : session.assertions())
        EXPECT_EQ(session.check(*assertion, {}).verdict.outcome, refine::Outcome::holds);
}

}  // namespace robochart::cspm::test
