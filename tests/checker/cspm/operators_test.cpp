// The operators that scripts use rarely, on small scripts; the argument for each verdict stands beside it.
#include "tests/checker/cspm/outcomes.hpp"

namespace robochart::cspm::test {
namespace {

// FDR manual, prioritisepo; UCS 20.2.
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
    EXPECT_EQ(fault("{(a, b), (b, a)}, {}"), "prioritisepo: the order is cyclic, b lies above itself");
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
    // What these do when full or empty is not written down where we could find it.
    EXPECT_EQ(process_failure(channels + "channel c\nX = WEAK_BUFFER(1, c, {(a, b)})\n"),
              "'WEAK_BUFFER' is not supported");
}

TEST(OperatorsTest, ClosuresOfRelations) {
    const std::string use = "let external mtransclose within ";
    EXPECT_EQ(value(use + "mtransclose({(1,2), (3,2), (4,5)}, {1..5})"), "{(1, 2), (1, 3), (4, 5)}");
    // Not reflexive; members outside the set are left out, and lead on.
    EXPECT_EQ(value(use + "mtransclose({(1,2), (2,3)}, {1, 3, 9})"), "{(1, 3)}");
    EXPECT_EQ(value(use + "mtransclose({}, {1})"), "{}");
}

// P |\ A hides all but A; loop(P) is P;loop(P).
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

// FDR manual, tau priority: on both sides the events of the set wait for tau and tick.
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

}  // namespace
}  // namespace robochart::cspm::test
