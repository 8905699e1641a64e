// SPDX-License-Identifier: Apache-2.0
// Compares the code of RoboSim machines with the machines themselves (docs/conformance.md, "RoboSim"), for cycles of
// one and of two time units. docs/robosim.md contains the rules. For each kind of fault in the code of cycles, a model
// is written that kills it.
#include <gtest/gtest.h>

#include "conformance/check/conform.hpp"
#include "semantics/ir/query.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

using cpp_emit::Fault;

class RobosimModel : public tests::TemporaryFolder {
public:
    explicit RobosimModel(const std::string& text) { write("model.rst", text); }
};

/// Returns the outermost component: the module, the controller, or the machine S.
ir::ComponentRef whole_of(const test::Model& model) {
    if (!model.system.modules.empty()) return model.first_module();
    if (!model.system.controllers.empty()) return model.first_controller();
    return model.machine_named("S");
}

/// Checks the code of the outermost component, with this fault and with cycles of this length.
Result check(const std::string& text, std::uint32_t cycle, Fault fault = Fault::none, std::uint32_t site = 0) {
    const RobosimModel folder(text);
    test::Model model(folder.path());
    const ir::ComponentRef whole = whole_of(model);
    model.instantiation.constants[ir::constant_name(whole.package, whole.path, ir::cycle_length)] = {cycle, {}};
    Options options;
    options.flags = "-std=c++17 -O1 -w";
    options.generator.fault = fault;
    options.generator.fault_site = site;
    return conform(model.system, model.instantiation, whole, options, model.sources, model.diagnostics);
}

void expect_conforming(const std::string& text) {
    for (const std::uint32_t cycle : {1U, 2U}) {
        const Result result = check(text, cycle);
        EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason << " " << result.expected << text;
    }
}

/// Checks that the fault makes the code differ for at least one place of the fault.
void expect_killed(const std::string& text, std::uint32_t cycle, Fault fault) {
    ASSERT_EQ(check(text, cycle).outcome, Outcome::conforms) << text;
    bool killed = false;
    for (std::uint32_t site = 0; site < 4 && !killed; ++site)
        killed = check(text, cycle, fault, site).outcome == Outcome::differs;
    EXPECT_TRUE(killed) << "fault " << static_cast<int>(fault) << text;
}

/// The machine receives a value, stores it at a transition with `exec`, and sends it in the next cycle.
const char* const stored = R"(
enumeration Three { one two three }
stm S {
    cycleDef cycle == 1
    input context { event inp : Three }
    output context { event outp : Three }
    var x : Three
    initial i
    state A { }
    transition t0 { from i to A }
    transition t1 { from A to A exec condition $inp?x action $outp!x }
    transition t2 { from A to A exec condition not $inp action $outp!x }
}
)";

/// The second write of an output waits, so the cycle never ends.
const char* const twice = R"(
stm S {
    cycleDef cycle == 1
    input context { event again }
    output context { event e }
    initial i
    state A { }
    state B { }
    transition t0 { from i to A }
    transition t1 { from A to B condition $again action $e ; $e }
    transition t2 { from A to A exec condition not $again }
    transition t3 { from B to B exec }
}
)";

/// `since(C) == 1` never holds at the beginning of a cycle of two time units.
const char* const waiting = R"(
stm S {
    cycleDef cycle == 1
    clock C
    input context { }
    output context { event early }
    initial i
    state A { during exec }
    state E { }
    transition t0 { from i to A action #C }
    transition t1 { from A to E condition since(C) == 1 action $early }
    transition t2 { from A to E condition since(C) == 2 }
    transition t3 { from E to E exec }
}
)";

/// Either a during action ends the cycle, or the transition is taken before it does. After the end of the cycle, only
/// the next register counts.
const char* const moves = R"(
stm S {
    cycleDef cycle == 1
    input context { event go }
    output context { event b }
    initial i
    state A { during exec }
    state B { entry $b }
    transition t0 { from i to A }
    transition t1 { from A to B condition $go }
    transition t2 { from A to A exec condition not $go }
    transition t3 { from B to B exec }
}
)";

/// `exec` occurs between the statements of an action, and in an exit action.
const char* const actions = R"(
stm S {
    cycleDef cycle == 1
    input context { event go }
    output context { event a event b event c }
    initial i
    state A { exit $a ; exec ; $b }
    state B { entry $c ; exec ; $c }
    transition t0 { from i to A }
    transition t1 { from A to B condition $go action $c ; exec }
    transition t2 { from A to A condition not $go action exec }
    transition t3 { from B to A exec }
}
)";

/// A composite state that is left at a transition with `exec`.
const char* const nested = R"(
stm S {
    cycleDef cycle == 1
    input context { event stop event step }
    output context { event left event inner event outer }
    initial i
    state A {
        exit $outer
        initial j
        state X { exit $inner }
        state Y { exit $left }
        transition u0 { from j to X }
        transition u1 { from X to Y exec condition $step /\ not $stop }
        transition u2 { from Y to X exec condition $step /\ not $stop }
        transition u3 { from X to X exec condition not $step /\ not $stop }
        transition u4 { from Y to Y exec condition not $step /\ not $stop }
    }
    state E { }
    transition t0 { from i to A }
    transition t1 { from A to E exec condition $stop }
    transition t2 { from E to A exec condition $step }
    transition t3 { from E to E exec condition not $step }
}
)";

/// A variable of both contexts is changed from outside and by the machine.
const char* const registers = R"(
interface V { var v : boolean }
stm S {
    cycleDef cycle == 1
    input context { requires V event flip }
    output context { requires V event seen : boolean }
    initial i
    state A { }
    transition t0 { from i to A }
    transition t1 { from A to A condition $flip action $v = not $v ; $seen!$v ; exec }
    transition t2 { from A to A condition not $flip action $seen!$v ; exec }
}
)";

/// A machine that terminates in one of two ways, between which a junction chooses.
const char* const ends = R"(
stm S {
    cycleDef cycle == 1
    input context { event a event b }
    output context { event x event y }
    initial i
    state A { }
    junction k
    final f
    transition t0 { from i to A }
    transition t1 { from A to k exec condition $a }
    transition t2 { from A to A exec condition not $a }
    transition t3 { from k to f condition $b action $x }
    transition t4 { from k to A condition not $b action $y }
}
)";

/// Machines of two controllers communicate: one event connects machines of a controller, another connects the
/// controllers.
const char* const together = R"(
stm W {
    cycleDef cycle == 1
    input context { event tell : boolean }
    output context { event sig : boolean }
    var v : boolean
    initial i
    state A { }
    transition t0 { from i to A }
    transition t1 { from A to A condition $tell?v action $sig!v ; exec }
    transition t2 { from A to A condition not $tell action exec }
}
stm R {
    cycleDef cycle == 1
    input context { event sig : boolean }
    output context { event got }
    initial i
    state A { }
    transition t0 { from i to A }
    transition t1 { from A to A condition $sig action $got ; exec }
    transition t2 { from A to A condition not $sig action exec }
}
stm Q {
    cycleDef cycle == 1
    input context { event got }
    output context { event out }
    initial i
    state A { }
    transition t0 { from i to A }
    transition t1 { from A to A condition $got action $out ; exec }
    transition t2 { from A to A condition not $got action exec }
}
controller C {
    cycleDef cycle == 1
    event tell : boolean
    event got
    sref w = W
    sref r = R
    connection C on tell to w on tell
    connection w on sig to r on sig
    connection r on got to C on got
}
controller D {
    cycleDef cycle == 1
    event got
    event out
    sref q = Q
    connection D on got to q on got
    connection q on out to D on out
}
module M {
    cycleDef cycle == 1
    robotic platform P { event tell : boolean event out }
    cref c = C
    cref d = D
    connection P on tell to c on tell ( _async )
    connection c on got to d on got ( _async )
    connection d on out to P on out ( _async )
}
)";

/// Two machines read one input. One input and one output are not connected.
const char* const shared_input = R"(
stm A {
    cycleDef cycle == 1
    input context { event go event open }
    output context { event a event lost }
    initial i
    state X { }
    transition t0 { from i to X }
    transition t1 { from X to X condition $go /\ not $open action $lost ; $a ; exec }
    transition t2 { from X to X condition not $go \/ $open action exec }
}
stm B {
    cycleDef cycle == 1
    input context { event go }
    output context { event b }
    initial i
    state X { }
    transition t0 { from i to X }
    transition t1 { from X to X condition $go action $b ; exec }
    transition t2 { from X to X condition not $go action exec }
}
controller C {
    cycleDef cycle == 1
    event go
    event a
    event b
    sref x = A
    sref y = B
    connection C on go to x on go
    connection C on go to y on go
    connection x on a to C on a
    connection y on b to C on b
}
)";

/// Two machines call one operation in the same cycle. The second call waits forever.
const char* const both_call = R"(
interface Op { go(n : boolean) }
stm A {
    cycleDef cycle == 1
    input context { }
    output context { requires Op }
    initial i
    state B { entry $go(false) }
    transition t0 { from i to B }
    transition t1 { from B to B exec }
}
controller C {
    cycleDef cycle == 1
    requires Op
    sref a = A
    sref b = A
}
)";

TEST(Robosim, CompositionsConform) {
    for (const char* text : {together, shared_input, both_call}) expect_conforming(text);
    const Result stops = check(both_call, 1);
    ASSERT_TRUE(stops.deadlines);
    EXPECT_FALSE(stops.deadlines->holds);
    const Result runs = check(together, 1);
    ASSERT_TRUE(runs.deadlines);
    EXPECT_TRUE(runs.deadlines->holds);
}

TEST(Robosim, FaultsOfCompositionsAreKilled) {
    expect_killed(together, 1, Fault::buffer_kept);
    expect_killed(both_call, 1, Fault::cycle_output_again);
    expect_killed(shared_input, 1, Fault::event_kept);
    expect_killed(together, 1, Fault::send_dropped);
}

/// One machine changes the platform's variable, and another one reports it. It reports the value at the beginning of
/// the cycle, although the first machine may already have written another one.
const char* const platform_variable = R"(
interface V { var v : boolean = false }
stm Writer {
    cycleDef cycle == 1
    input context { event flip requires V }
    output context { event wrote : boolean requires V }
    initial i
    state A { }
    transition t0 { from i to A }
    transition t1 { from A to A condition $flip action $v = not $v ; $wrote!$v ; exec }
    transition t2 { from A to A condition not $flip action exec }
}
stm Reader {
    cycleDef cycle == 1
    input context { requires V }
    output context { event seen : boolean }
    initial i
    state A { }
    transition t0 { from i to A }
    transition t1 { from A to A action $seen!$v ; exec }
}
controller C {
    cycleDef cycle == 1
    requires V
    event flip
    event wrote : boolean
    sref w = Writer
    connection C on flip to w on flip
    connection w on wrote to C on wrote
}
controller D {
    cycleDef cycle == 1
    requires V
    event seen : boolean
    sref r = Reader
    connection r on seen to D on seen
}
module M {
    cycleDef cycle == 1
    robotic platform P { provides V event flip event wrote : boolean event seen : boolean }
    cref c = C
    cref d = D
    connection P on flip to c on flip ( _async )
    connection c on wrote to P on wrote ( _async )
    connection d on seen to P on seen ( _async )
}
)";

/// Two machines read a variable that the controller requires, and one of them writes it. The environment may write it,
/// too.
const char* const required_variable = R"(
interface V { var v : boolean }
stm Writer {
    cycleDef cycle == 1
    input context { event flip requires V }
    output context { requires V }
    initial i
    state A { }
    transition t0 { from i to A }
    transition t1 { from A to A condition $flip action $v = not $v ; exec }
    transition t2 { from A to A condition not $flip action exec }
}
stm Reader {
    cycleDef cycle == 1
    input context { requires V }
    output context { event seen : boolean }
    initial i
    state A { }
    transition t0 { from i to A }
    transition t1 { from A to A action $seen!$v ; exec }
}
controller C {
    cycleDef cycle == 1
    requires V
    event flip
    event seen : boolean
    sref w = Writer
    sref r = Reader
    connection C on flip to w on flip
    connection r on seen to C on seen
}
)";

/// Two machines write a record of their controller, each one part of it. Both may do so in the same cycle, because the
/// write is not an output of the controller.
const char* const controller_variable = R"(
datatype Pair { a : boolean b : boolean }
interface V { var p : Pair }
stm First {
    cycleDef cycle == 1
    input context { event one requires V }
    output context { requires V }
    initial i
    state A { }
    transition t0 { from i to A }
    transition t1 { from A to A condition $one action $p.a = not $p.a ; exec }
    transition t2 { from A to A condition not $one action exec }
}
stm Second {
    cycleDef cycle == 1
    input context { event two requires V }
    output context { requires V event seen : Pair }
    initial i
    state A { }
    transition t0 { from i to A }
    transition t1 { from A to A condition $two action $p.b = not $p.b ; $seen!$p ; exec }
    transition t2 { from A to A condition not $two action $seen!$p ; exec }
}
controller C {
    cycleDef cycle == 1
    uses V
    event one
    event two
    event seen : Pair
    sref x = First
    sref y = Second
    connection C on one to x on one
    connection C on two to y on two
    connection y on seen to C on seen
}
)";

/// Two machines write the platform's variable in the same cycle if both inputs are present. Then the second write waits
/// forever, because the variable is an output of the module.
const char* const both_write = R"(
interface V { var v : boolean }
stm A {
    cycleDef cycle == 1
    input context { event go }
    output context { requires V }
    initial i
    state B { }
    transition t0 { from i to B }
    transition t1 { from B to B condition $go action $v = true ; exec }
    transition t2 { from B to B condition not $go action exec }
}
controller C {
    cycleDef cycle == 1
    requires V
    event one
    event two
    sref x = A
    sref y = A
    connection C on one to x on go
    connection C on two to y on go
}
module M {
    cycleDef cycle == 1
    robotic platform P { var v : boolean event one event two }
    cref c = C
    connection P on one to c on one ( _async )
    connection P on two to c on two ( _async )
}
)";

/// The platform has no variable `v`: the controller reads arbitrary values and writes in vain, but at most once in a
/// cycle.
const char* const unconnected_variable = R"(
interface V { var v : boolean }
stm Reader {
    cycleDef cycle == 1
    input context { requires V }
    output context { event yes event no }
    initial i
    state A { }
    transition t0 { from i to A }
    transition t1 { from A to A condition $v action $yes ; exec }
    transition t2 { from A to A condition not $v action $no ; exec }
}
stm Writer {
    cycleDef cycle == 1
    input context { event first }
    output context { requires V event wrote }
    initial i
    state A { }
    transition t0 { from i to A }
    transition t1 { from A to A condition $first action $v = false ; $wrote ; exec }
    transition t2 { from A to A condition not $first action $v = true ; exec ; $v = false ; exec }
}
controller C {
    cycleDef cycle == 1
    requires V
    event first
    event yes
    event no
    event wrote
    sref r = Reader
    sref w = Writer
    connection C on first to w on first
    connection w on wrote to C on wrote
    connection r on yes to C on yes
    connection r on no to C on no
}
module M {
    cycleDef cycle == 1
    robotic platform P { event first event yes event no event wrote }
    cref c = C
    connection P on first to c on first ( _async )
    connection c on yes to P on yes ( _async )
    connection c on wrote to P on wrote ( _async )
    connection c on no to P on no ( _async )
}
)";

TEST(Robosim, SharedVariablesConform) {
    for (const char* text :
         {platform_variable, required_variable, controller_variable, both_write, unconnected_variable})
        expect_conforming(text);
    const Result stops = check(both_write, 1);
    ASSERT_TRUE(stops.deadlines);
    EXPECT_FALSE(stops.deadlines->holds);
    const Result runs = check(controller_variable, 1);
    ASSERT_TRUE(runs.deadlines);
    EXPECT_TRUE(runs.deadlines->holds);
}

TEST(Robosim, FaultsOfSharedVariablesAreKilled) {
    for (const char* text : {platform_variable, required_variable, controller_variable}) {
        expect_killed(text, 1, Fault::write_not_relayed);
        expect_killed(text, 2, Fault::write_not_relayed);
    }
    expect_killed(platform_variable, 1, Fault::cycle_read_late);
    expect_killed(required_variable, 2, Fault::cycle_read_late);
    expect_killed(platform_variable, 1, Fault::initial_lost);
    expect_killed(required_variable, 1, Fault::outside_write_late);
    expect_killed(required_variable, 1, Fault::outside_write_lost);
    expect_killed(both_write, 1, Fault::cycle_output_again);
    expect_killed(controller_variable, 1, Fault::part_not_assigned);
    expect_killed(unconnected_variable, 1, Fault::send_dropped);
}

TEST(Robosim, MachinesConform) {
    for (const char* text : {stored, twice, waiting, moves, actions, nested, registers, ends}) expect_conforming(text);
}

TEST(Robosim, ACycleThatCannotEndIsReported) {
    const Result result = check(twice, 1);
    ASSERT_TRUE(result.deadlines);
    EXPECT_FALSE(result.deadlines->holds);
    ASSERT_FALSE(result.deadlines->cycles.empty());
    EXPECT_EQ(result.deadlines->cycles.back().inputs, std::vector<std::string>{"again"});
    const Result good = check(stored, 1);
    ASSERT_TRUE(good.deadlines);
    EXPECT_TRUE(good.deadlines->holds);
}

TEST(Robosim, ALoopWithoutEndIsNotSchedulable) {
    const Result result = check(R"(
stm S {
    cycleDef cycle == 1
    input context { event go }
    output context { }
    initial i
    state A { }
    transition t0 { from i to A }
    transition t1 { from A to A condition $go }
    transition t2 { from A to A exec condition not $go }
}
)",
                                1);
    EXPECT_EQ(result.outcome, Outcome::not_schedulable);
}

TEST(Robosim, FaultsOfTheFrameAreKilled) {
    expect_killed(twice, 1, Fault::cycle_output_again);
    expect_killed(actions, 1, Fault::cycle_exec_dropped);
    expect_killed(moves, 1, Fault::cycle_moves_on);
    expect_killed(nested, 1, Fault::cycle_effect_early);
    expect_killed(stored, 1, Fault::cycle_store_late);
    expect_killed(registers, 1, Fault::event_kept);
    expect_killed(twice, 1, Fault::cycle_stop_hidden);
    expect_killed(waiting, 2, Fault::cycle_time_unit);
    expect_killed(twice, 1, Fault::cycle_end_early);
}

TEST(Robosim, FaultsOfTheBodyAreKilled) {
    expect_killed(nested, 1, Fault::children_not_exited);
    expect_killed(actions, 1, Fault::send_dropped);
    expect_killed(stored, 1, Fault::guard_negated);
    expect_killed(registers, 1, Fault::assignment_dropped);
    expect_killed(registers, 1, Fault::outside_write_late);
    expect_killed(ends, 1, Fault::wrong_target);
}

}  // namespace
}  // namespace robochart::conformance
