// SPDX-License-Identifier: Apache-2.0
// Compares controllers and modules with hand-written CSPM (semantics 3.7 to 3.10).
#include <gtest/gtest.h>

#include "tests/csp_emit/fixture.hpp"
#include "tests/source_folder.hpp"

namespace robochart::csp_emit::composition_test {
namespace {

using testing::check_equivalence;
using testing::decide_with;
using testing::load_model;

std::string check_same_process(const std::string& rct, Time time, const std::string& process,
                               const std::string& definitions) {
    const auto m = load_model(rct);
    if (!m->diagnostics.ok()) return m->messages();
    return check_equivalence(*m, time, process, "Spec", definitions);
}

/// Two machines: P sends `out`, and Q receives it.
const char* const pair = R"(
controller C {
    event r
    stm P {
        event o : nat
        event lost
        initial i
        state A { entry o ! 2 ; lost }
        final f
        transition t0 { from i to A }
        transition t1 { from A to f }
    }
    stm Q {
        event e : nat
        event r
        var x : nat
        initial i
        state A { }
        final f
        transition t0 { from i to A }
        transition t1 { from A to f trigger e ? x condition x > 1 action r }
    }
    connection P on o to Q on e
    connection Q on r to C on r
}
)";

TEST(Controllers, MachinesMeetAndTerminateTogether) {
    // The connected events and the unconnected event `lost` are hidden. Both machines share one terminate.
    EXPECT_EQ(check_same_process(pair, Time::untimed, "C::D__(0)", "Spec = C::r.out -> C::terminate -> SKIP"), "holds");
}

TEST(Controllers, ConnectedEventsAreUrgent) {
    EXPECT_EQ(check_same_process(pair, Time::timed, "C::D__(0)", R"(
        Spec = C::r.out -> End [] tock -> Spec
        End = C::terminate -> SKIP [] tock -> End)"),
              "holds");
}

const char* const called_while_waiting = R"(
interface Events { event a event c event d }
interface Shared { var x : nat }
interface Calls { put() }
operation put() {
    requires Shared
    uses Events
    initial i
    final f
    transition t { from i to f action a ; x = 1 }
}
stm S {
    uses Events
    uses Shared
    requires Calls
    initial i
    state A { during put() }
    state B { }
    transition t0 { from i to A }
    transition t1 { from A to B trigger c condition x == 0 action d }
}
controller C {
    uses Events
    opref put_ref = put
    sref s = S
    connection C on c to s on c
    connection s on a to C on a
    connection s on d to C on d
}
)";

// Semantics 3.4, During, and 3.8: the operation's steps are steps of the during action, and a transition may interrupt
// it before each of them.
TEST(Controller, OperationsCalledFromDuringActionsMayBeTooLate) {
    EXPECT_EQ(check_same_process(called_while_waiting, Time::untimed, "C::D__(0)", R"(
        Cut = C::c.in -> C::d.out -> STOP
        Spec = C::a.out -> (Cut [> STOP) [] Cut)"),
              "holds");
}

const char* const operations = R"(
interface V { var x : nat }
interface O { count(by : nat) ask() }
operation count(by : nat) {
    requires V
    event tick
    precondition by > 0
    initial i
    state A { entry x = x + by }
    final f
    transition t0 { from i to A }
    transition t1 { from A to f trigger tick }
}
controller C {
    event tick
    requires O
    uses V
    opref count_ref = count
    stm S {
        requires O
        requires V
        event tick
        initial i
        state A { entry count(1) ; ask() }
        state B { entry count(0) }
        transition t0 { from i to A }
        transition t1 { from A to B trigger tick }
    }
    connection C on tick to S on tick
}
)";

TEST(Operations, DefinedOnesRunInTheirCallersPlaceAndBlockOnAFalsePrecondition) {
    EXPECT_EQ(check_same_process(operations, Time::untimed, "C::D__(0)",
                                 "Spec = C::tick.in -> C::askCall -> C::tick.in -> STOP"),
              "holds");
}

// An operation that the machine never calls does not bound the machine's clock, because the machine does not have the
// operation's constants.
TEST(Operations, ThatAreNotCalledDoNotBoundTheClocksOfAMachine) {
    const auto m = testing::load_model(R"(
        interface Ops { op() other() }
        operation op() { initial i final f transition t0 { from i to f } }
        operation other() { const c : nat = 1 clock T initial i state A { } final f transition t0 { from i to A }
                            transition t1 { from A to f condition since(T) >= c } }
        controller C { event e opref o = op opref p = other
            stm S { requires Ops event e clock T initial i state A { entry op() } state B { }
                    transition t0 { from i to A } transition t1 { from A to B trigger e condition since(T) >= 1 } }
            connection C on e to S on e })");
    EXPECT_EQ(testing::check_equivalence(*m, Time::timed, "C::D__(0)", "Spec", R"(
        Spec = tock -> After
        After = C::e.in -> Done [] tock -> After
        Done = tock -> Done)"),
              "holds")
        << m->messages();
}

/// W writes x once, and R outputs the value that it reads.
const char* const shared = R"(
interface V { var x : nat }
controller C {
    var x : nat
    event o : nat
    event go
    stm W {
        requires V
        initial i
        state A { entry x = 1 }
        transition t0 { from i to A }
    }
    stm R {
        requires V
        event o : nat
        event go
        initial i
        state A { }
        transition t0 { from i to A }
        transition t1 { from A to A trigger go action o ! x }
    }
    connection R on o to C on o
    connection C on go to R on go
}
)";

// R's copy is 0 until the hidden write reaches it. R reads x in one step and outputs the value in a later one.
TEST(Memory, ReadersMaySeeStaleValuesUntilTheWriteIsPropagated) {
    EXPECT_EQ(check_same_process(shared, Time::untimed, "C::D__(0)", R"(
        Spec = (C::go.in -> Reading) [> New
        Reading = Saying |~| C::o.out.1 -> New
        Saying = (C::o.out.0 -> Spec) [> (C::o.out.0 -> New)
        New = C::go.in -> C::o.out.1 -> New)"),
              "holds");
}

TEST(Memory, WritesArePropagatedBeforeTimePasses) {
    EXPECT_EQ(check_same_process(shared, Time::timed, "C::D__(0)", R"(
        Spec = (C::go.in -> Reading) [> New
        Reading = Saying |~| One
        Saying = (C::o.out.0 -> Spec) [> Zero
        Zero = C::o.out.0 -> New [] tock -> Zero
        One = C::o.out.1 -> New [] tock -> One
        New = C::go.in -> One [] tock -> New)"),
              "holds");
}

/// A platform variable with an initial value. The machine writes it at the start and reads it at every `go`.
const char* const platform = R"(
interface V { var y : nat = 1 }
interface E { event go event o : nat }
module M {
    robotic platform RP { provides V uses E }
    controller C {
        requires V
        uses E
        stm S {
            requires V
            uses E
            initial i
            state A { }
            transition t0 { from i to A }
            transition t1 { from A to A trigger go action o ! y }
        }
        connection C on go to S on go
        connection S on o to C on o
    }
    connection RP on go to C on go ( _async )
    connection C on o to RP on o ( _async )
}
)";

TEST(Memory, ThePlatformsInitialValuesArePropagatedLikeWrites) {
    EXPECT_EQ(check_same_process(platform, Time::timed, "M::D__(0)", R"(
        Spec = (M::go.in -> Reading) [> New
        Reading = Saying |~| One
        Saying = (M::o.out.0 -> Spec) [> Zero
        Zero = M::o.out.0 -> New [] tock -> Zero
        One = M::o.out.1 -> New [] tock -> One
        New = M::go.in -> One [] tock -> New)"),
              "holds");
}

/// The platform sees a write of a variable that it provides immediately.
const char* const provided = R"(
interface V { var y : nat }
interface E { event go }
module M {
    robotic platform RP { provides V uses E }
    controller C {
        requires V
        uses E
        stm S {
            requires V
            uses E
            initial i
            state A { }
            final f
            transition t0 { from i to A }
            transition t1 { from A to f trigger go action y = 2 }
        }
        connection C on go to S on go
    }
    connection RP on go to C on go ( _async )
}
)";

TEST(Modules, WritesOfProvidedVariablesAreVisibleAndUrgentAndTerminationIsHidden) {
    EXPECT_EQ(check_same_process(provided, Time::timed, "M::D__(0)", R"(
        Spec = M::go.in -> M::set_y.2 -> SKIP [] tock -> Spec)"),
              "holds");
}

const char* const asynchronous = R"(
interface E { event p event q : nat }
module M {
    robotic platform RP { uses E }
    controller A {
        uses E
        event b : nat
        stm S {
            uses E
            event b : nat
            initial i
            state X { }
            transition t0 { from i to X }
            transition t1 { from X to X trigger p action b ! 1 ; b ! 2 }
        }
        connection A on p to S on p
        connection S on b to A on b
    }
    controller B {
        uses E
        event b : nat
        event go
        stm S {
            uses E
            event b : nat
            var x : nat
            initial i
            state X { }
            transition t0 { from i to X }
            transition t1 { from X to X trigger b ? x action q ! x }
        }
        connection B on b to S on b
        connection S on q to B on q
    }
    connection RP on p to A on p ( _async )
    connection A on b to B on b ( _async )
    connection B on q to RP on q ( _async )
}
)";

TEST(Modules, AsynchronousBuffersAreOverwrittenByTheNewest) {
    const auto m = load_model(asynchronous);
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    const auto results = decide_with(*m, Time::untimed, R"(
        assert M::D__(0) :[has trace [T]]: <M::p.in, M::q.out.1, M::q.out.2>
        assert M::D__(0) :[has trace [T]]: <M::p.in, M::q.out.2, M::p.in, M::q.out.1>
        assert not M::D__(0) :[has trace [T]]: <M::p.in, M::q.out.2, M::q.out.1>
        assert not M::D__(0) :[has trace [T]]: <M::p.in, M::q.out.1, M::q.out.1>
        assert M::D__(0) :[divergence free]
        assert M::D__(0) :[deadlock free]
    )");
    EXPECT_EQ(results, std::vector<std::string>(6, "holds"));
}

/// The reason of each claim is stated in corpus/*/*.assertions.
TEST(Corpus, EveryClaimHolds) {
    for (const char* name : {"aggregation", "swarm_taxis"}) {
        for (const Time time : {Time::untimed, Time::timed}) {
            const auto m = testing::project(tests::source_folder().string() + "/corpus/" + name);
            ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
            const auto results = testing::decide_script(m->emit(time).script);
            ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
            EXPECT_GE(results.size(), 8U);
            EXPECT_EQ(results, std::vector<std::string>(results.size(), "holds")) << name;
        }
    }
}

}  // namespace
}  // namespace robochart::csp_emit::composition_test
