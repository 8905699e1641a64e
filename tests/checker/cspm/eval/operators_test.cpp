// SPDX-License-Identifier: Apache-2.0
// Tests rarely used operators with small scripts. Comments give the argument for each verdict.
#include "tests/checker/cspm/outcomes.hpp"

namespace robochart::cspm::test {
namespace {

// The expected behaviour is that of the FDR manual, prioritisepo, and of UCS 20.2.
TEST(OperatorsTest, PrioritiseByAPartialOrder) {
    expect_outcomes(R"(external prioritisepo
channel a, b, c, d
All = {a, b, c, d}
P = a -> STOP [] b -> STOP [] c -> STOP [] d -> STOP
-- b lies below a, c below b: a and d are left, d is not in the order.
Chain = prioritisepo(P, All, {(a, b), (b, c)}, {a, d})
assert a -> STOP [] d -> STOP [FD= Chain
assert Chain [FD= a -> STOP [] d -> STOP
-- A tau prevents all but the maximal; DIV always has one.
Q = a -> STOP [] b -> STOP [] DIV
assert prioritisepo(Q, All, {}, {a}) :[has trace [T]]: <a>
assert prioritisepo(Q, All, {}, {a}) :[has trace [T]]: <b>
-- An event outside the prioritised ones is left alone by tau and by all others.
assert prioritisepo(Q, {a}, {}, {}) :[has trace [T]]: <b>
-- Termination has the rank of tau.
assert prioritisepo(SKIP [] b -> STOP, All, {}, {a}) :[has trace [T]]: <b>
assert prioritisepo(SKIP [] a -> STOP, All, {}, {a}) :[has trace [T]]: <a>
)",
                    "hhhfhfh");
    const auto fault = [](const std::string& order) {
        return process_failure("external prioritisepo\nchannel a, b, c\nX = prioritisepo(STOP, {a, b}, " + order +
                               ")\n");
    };
    EXPECT_EQ(fault("{(a, b), (b, a)}, {}"), "prioritisepo: the order is cyclic, a lies above itself");
    EXPECT_EQ(fault("{(a, b)}, {b}"), "prioritisepo: b is given as maximal, but lies below another event");
    EXPECT_EQ(fault("{(a, c)}, {}"), "prioritisepo: c is not among the prioritised events");
    EXPECT_EQ(fault("{}, {c}"), "prioritisepo: c is not among the prioritised events");
}

TEST(OperatorsTest, Buffer) {
    expect_outcomes(R"(channel in, out : {0, 1}
B = BUFFER(2, {(in.x, out.x) | x <- {0, 1}})
-- The buffer of capacity two, written out.
Spec(s) = (#s < 2 & in?x -> Spec(s ^ <x>)) [] (#s > 0 & out!head(s) -> Spec(tail(s)))
assert Spec(<>) [FD= B
assert B [FD= Spec(<>)
assert B :[has trace [T]]: <in.0, in.1, in.0>
)",
                    "hhf");
    const std::string channels = "channel a, b\n";
    EXPECT_EQ(process_failure(channels + "X = BUFFER(0, {(a, b)})\n"), "a buffer's capacity is at least 1, not 0");
    EXPECT_EQ(process_failure(channels + "X = BUFFER(1, {(a, a)})\n"), "the event a is given to a buffer twice");
    // We found no definition of how these buffers behave when they are full or empty, so the evaluator rejects them.
    EXPECT_EQ(process_failure(channels + "channel c\nX = WEAK_BUFFER(1, c, {(a, b)})\n"),
              "'WEAK_BUFFER' is not supported");
}

TEST(OperatorsTest, ClosuresOfRelations) {
    const std::string use = "let external mtransclose within ";
    EXPECT_EQ(value(use + "mtransclose({(1,2), (3,2), (4,5)}, {1..5})"), "{(1, 2), (1, 3), (4, 5)}");
    // The closure is not reflexive. Elements outside the set are removed, but paths may lead through them.
    EXPECT_EQ(value(use + "mtransclose({(1,2), (2,3)}, {1, 3, 9})"), "{(1, 3)}");
    EXPECT_EQ(value(use + "mtransclose({}, {1})"), "{}");
}

// P |\ A hides all events except A. loop(P) is P;loop(P).
TEST(OperatorsTest, ProjectAndLoop) {
    expect_outcomes(R"(external loop
channel a, b, c
P = a -> b -> c -> P
assert loop(b -> SKIP) [FD= P |\ {b}
assert P |\ {b} [FD= loop(b -> SKIP)
assert P |\ {} :[divergence free]
assert loop(SKIP) :[divergence free]
)",
                    "hhff");
}

// FDR manual, tau priority: on both sides, the events of the set wait for tau and tick.
TEST(OperatorsTest, TauPriority) {
    expect_outcomes(R"(channel tock
P = tock -> P
Q = DIV [] tock -> STOP
-- Q's taus come before tock.
assert STOP [T= Q
assert STOP [T= Q :[tau priority]: {tock}
assert STOP [T= Q :[tau priority over]: {tock}
-- Without a tau nothing changes.
assert STOP [T= P :[tau priority]: {tock}
-- Of Q as specification there is no tock left either.
assert Q [T= tock -> STOP
assert Q [T= tock -> STOP :[tau priority]: {tock}
-- The deadlock after tock is out of reach then.
assert Q :[deadlock free [F]]
assert Q :[deadlock free [F]] :[tau priority]: {tock}
)",
                    "fhhfhffh");
}

// In T, `has trace` means that a trace exists. In F and FD it is decided only if all interpretations agree, because the
// manual does not define it.
TEST(OperatorsTest, HasTraceInEachModel) {
    expect_outcomes(R"(channel a, b
P = a -> b -> STOP
-- Performed and never refused: it holds in all models. A trace is not the whole of a run.
assert P :[has trace [T]]: <a>
assert P :[has trace [F]]: <a>
assert P :[has trace [FD]]: <a, b>
assert P :[has trace]: <a, b>
-- Not performed: it fails in all.
assert P :[has trace [T]]: <b>
assert P :[has trace [F]]: <b>
assert P :[has trace [FD]]: <a, a>
-- b can be refused after a.
Q = a -> (b -> STOP |~| STOP)
assert Q :[has trace [T]]: <a, b>
assert Q :[has trace [F]]: <a, b>
assert Q :[has trace [FD]]: <a>
-- P may diverge beside a; that counts in FD.
assert DIV [] P :[has trace [F]]: <a, b>
assert DIV [] P :[has trace [FD]]: <a, b>
assert DIV [] P :[has trace [FD]]: <b>
)",
                    "hhhhfffh?hh??");
}

TEST(OperatorsTest, WhatTheManualDoesNotSayIsRefusedByName) {
    const std::string why = " is not supported: FDR's manual does not say what it does";
    EXPECT_EQ(process_failure("external deter\nX = deter(STOP)\n"), "deter" + why);
    const std::string channels = "channel a, x\n";
    for (const std::string name : {"trace_watchdog", "failure_watchdog"})
        EXPECT_EQ(process_failure("external " + name + "\n" + channels + "X = " + name + "(STOP, {a}, x)\n"),
                  name + why);
}

TEST(OperatorsTest, ModelsWithoutASupportAreRefusedByName) {
    for (const std::string model : {"R", "RD", "V", "VD"}) {
        const Reading reading("assert STOP [" + model + "= STOP\n");
        Session session(reading.script);
        EXPECT_THROW((void)session.check(*session.assertions()[0], {}), EvaluationError) << model;
    }
}

// Mistakes that users of FDR make. Each error has a place, which process_failure checks.
TEST(OperatorsTest, FaultsOfProcessesHaveAPlace) {
    EXPECT_EQ(process_failure("channel c : Int\nX = c?x -> X\n"), "the set Int is infinite");
    EXPECT_EQ(process_failure("channel c : Int\nX = c$x -> X\n"), "the set Int is infinite");
    EXPECT_EQ(process_failure("channel c : {0, 1}\nX = [] i : {0..2} @ c.i -> STOP\n"),
              "2 is not a value of its field in c.2 (the field's type is {0, 1})");
    EXPECT_EQ(process_failure("X = |~| i : {} @ STOP\n"), "|~| over an empty set");
    EXPECT_EQ(process_failure("channel c : {0..9}\nf(0) = 1\nX = c!f(3) -> STOP\n"), "no clause of 'f' matches (3)");
}

TEST(OperatorsTest, MapsWithOneKeyTwice) {
    EXPECT_EQ(value("mapFromList(<(1, 2), (1, 3)>)"), "(| 1 => 3 |)");
    EXPECT_EQ(value("mapUpdateMultiple((| 1 => 0, 2 => 5 |), <(1, 2), (1, 3)>)"), "(| 1 => 2, 2 => 5 |)");
}

TEST(OperatorsTest, InfiniteSequences) {
    EXPECT_EQ(value("head(tail(<x | x <- <0..>, x % 7 == 3>))"), "10");
    EXPECT_EQ(value("head(tail(tail(<(x, y) | x <- <1..>, y <- <x..3>>)))"), "(1, 3)");
    EXPECT_EQ(value("head(<y * y | y <- <x + 1 | x <- <4..>>>)"), "25");
    EXPECT_EQ(value("let n = 3 within head(<x * n | x <- <2..>>)"), "6");
    EXPECT_EQ(value("head(tail(<1> ^ <5..>))"), "5");
    EXPECT_EQ(value("head(<5..> ^ <1>)"), "5");
    EXPECT_EQ(value("elem(8, <2 * x | x <- <0..>>)"), "true");
    EXPECT_EQ(value("null(<0..>) or <0..> == <1>"), "false");
    EXPECT_EQ(value("let f(<x, y> ^ rest) = x + y + head(rest)\n f(_) = 0 within f(<1..>)"), "6");
    EXPECT_EQ(value("let f(<x, y>) = 1\n f(_) = 0 within f(<1..>)"), "0");
    EXPECT_EQ(value("#<0..>"), "error: the sequence <0..> is infinite");
    EXPECT_EQ(value("<x | x <- <0..>> == <0..>"), "error: two infinite sequences agree in their first 200000 elements");
    EXPECT_EQ(value("{x | x <- <0..>}"),
              "error: a generator over an infinite sequence, other than the first of a sequence comprehension, is not "
              "supported");
    EXPECT_EQ(value("<x | x <- <0..>, x < 0>"), "<...>");
    EXPECT_EQ(value("head(<x | x <- <0..>, x < 0>)"),
              "error: none of 200000 elements makes another one of the sequence");
}

// The rules are those of FDR (libcspm: the renamer and the desugarer).
TEST(OperatorsTest, WhereNondeterministicInputMayStand) {
    const std::string channels = "channel c : {0, 1}.{0, 1}\nchannel tock\n";
    EXPECT_EQ(process_failure(channels + "X = c?x$y -> STOP\n"), "a $ field stands before all ? and ! fields");
    EXPECT_EQ(process_failure(channels + "f(_) = 0\nTimed(f) { X = c$x!0 -> STOP }\n"),
              "$ is not allowed in a timed section");
    expect_outcomes(channels + R"(P = c$x?y -> STOP
assert |~| x : {0, 1} @ ([] y : {0, 1} @ c.x.y -> STOP) [FD= P
assert P [FD= |~| x : {0, 1} @ ([] y : {0, 1} @ c.x.y -> STOP)
)",
                    "hh");
}

// `[] e : S @ e -> P` offers the events of S. P may depend on the event, and two elements of S may be the same event.
TEST(OperatorsTest, ChoiceOverASetOfEvents) {
    expect_outcomes(R"(channel a : {0, 1}
channel b, c
P = [] e : {| a, b |} @ e -> (if member(e, {| a |}) then c -> P else STOP)
Q = a?_ -> c -> Q [] b -> STOP
assert P [FD= Q
assert Q [FD= P
Offer(s) = [] e : s @ e -> Offer(diff(s, {e}))
assert a.0 -> b -> STOP [] b -> a.0 -> STOP [FD= Offer({a.0, b})
assert Offer({a.0, b}) [FD= a.0 -> b -> STOP [] b -> a.0 -> STOP
assert Offer({}) [FD= STOP
assert STOP [FD= Offer({})
)",
                    "hhhhhh");
}

}  // namespace
}  // namespace robochart::cspm::test
