// SPDX-License-Identifier: Apache-2.0
// Tests models that random tests found. For each of them, the generated code once did not compile without warnings, or
// differed from its model.
#include <gtest/gtest.h>

#include "conformance/check/conform.hpp"
#include "tests/conformance/bench.hpp"
#include "tests/conformance/check/expect_conforming.hpp"

namespace robochart::conformance {
namespace {

/// Checks that the first module conforms, or the machine S if the model has no module.
void expect_conformance_of(const std::string& text) {
    const test::ModelFolder folder(text);
    test::Model model(folder.path());
    const ir::ComponentRef component = model.system.modules.empty() ? model.machine_named("S") : model.first_module();
    (void)test::expect_conforming(model, component);
}

std::string machine(const std::string& declarations, const std::string& body) {
    return "interface Calls { move(p : boolean) }\nstm S { requires Calls event e event out var x : boolean\n" +
           declarations + "\ninitial i transition t0 { from i to A }\n" + body + "\n}\n";
}

TEST(Regressions, AGuardThatIsAConditionalDoesNotReplaceItsTrigger) {
    expect_conformance_of(machine("",
                                  "state A { } state B { entry out }\n"
                                  "transition t1 { from A to B trigger e condition if x then true else x end }"));
}

TEST(Regressions, AConditionalDecidesAnIfThatWaits) {
    expect_conformance_of(
        machine("", "state A { entry if (if x then true else x end) then wait(1) else wait(2) end; out }"));
}

TEST(Regressions, AVariableOfRealsReceivesWholeNumbers) {
    expect_conformance_of(
        "stm S { event e : nat event f : int event s : Seq(nat) event o : real event big\n"
        "var x : real var all : Seq(real) initial i transition t0 { from i to A }\n"
        "state A { entry o ! x } state B { entry e ? x ; o ! x ; wait(1) } state C { entry s ? all ; big }\n"
        "transition t1 { from A to A trigger e ? x condition x > 0.5 }\n"
        "transition t2 { from A to B trigger f ? x condition x < 0.5 }\n"
        "transition t3 { from B to C }\n"
        "transition t4 { from C to A trigger f ? x condition all == < > } }\n");
}

TEST(Regressions, ValuesAreComparedWithThemselvesWithoutAWarning) {
    expect_conformance_of(machine("",
                                  "state A { entry x = (x == x) iff (x != x) } state B { entry out }\n"
                                  "transition t1 { from A to B condition x iff x }"));
}

TEST(Regressions, AnOperationMayBeCalledWhereNothingLeads) {
    expect_conformance_of(
        "operation op() { initial i state A { } final f transition t0 { from i to A }\n"
        "transition t1 { from A to f } }\n"
        "interface Ops { op() }\n"
        "controller C { opref r = op sref m = S }\n"
        "stm S { requires Ops initial i state A { exit op() } transition t0 { from i to A } }\n"
        "module M { robotic platform P { } cref c = C }\n");
}

TEST(Regressions, AWriteMayArriveAfterTheTriggerOfACallThatReadsIt) {
    expect_conformance_of(
        "interface Acts { go(v : nat) } interface Shared { var v : nat } interface Orders { event set : nat }\n"
        "interface Wire { event reported }\n"
        "stm Source { requires Shared uses Orders uses Wire var n : nat initial i state A { }\n"
        "transition t0 { from i to A } transition t1 { from A to A trigger set?n action v = n; reported; wait(1) } }\n"
        "stm Sink { requires Acts requires Shared uses Wire initial i state A { }\n"
        "transition t0 { from i to A } transition t1 { from A to A trigger reported action go(v); wait(1) } }\n"
        "controller C { requires Acts requires Shared uses Orders sref a = Source sref b = Sink\n"
        "connection C on set to a on set connection a on reported to b on reported }\n"
        "module M { robotic platform P { provides Acts uses Shared uses Orders } cref c = C\n"
        "connection P on set to c on set (_async) }\n");
}

TEST(Regressions, TheWatchOverADeadlineReadsAVariableThatNothingElseDoes) {
    expect_conformance_of(
        "interface V { var v : boolean }\n"
        "controller C { requires V event e : boolean sref m = S connection C on e to m on e }\n"
        "stm S { requires V event e : boolean initial i state A { }\n"
        "transition t0 { from i to A } transition t1 { from A to A trigger e?v <{2} condition not v }\n"
        "state B { } transition t2 { from A to B } }\n"
        "module M { robotic platform P { provides V event e : boolean } cref c = C connection P on e to c on e "
        "( _async ) }\n");
}

TEST(Regressions, AValueFromABufferThatNobodyReadsIsDropped) {
    expect_conformance_of(
        "interface D { var d : nat }\n"
        "controller B { event o : nat stm T { event o : nat initial j state Z { } transition t0 { from j to Z } }\n"
        "connection T on o to B on o }\n"
        "controller C { uses D event e : nat sref m = S connection C on e to m on e }\n"
        "stm S { requires D event e : nat initial i state A { }\n"
        "transition t0 { from i to A } transition t1 { from A to A trigger e?d } }\n"
        "module M { robotic platform P { } cref b = B cref c = C connection b on o to c on e ( _async ) }\n");
}

/// The guard is false immediately before the clock T is reset.
TEST(Regressions, ADeadlineBeginsAnewWhereAClockEndsItsGuard) {
    expect_conformance_of(machine("event g clock T",
                                  "state A { initial j state B { } transition u0 { from j to B }\n"
                                  "transition u1 { from B to B trigger e #T } }\n"
                                  "final f transition t1 { from A to f trigger g <{1} condition since(T) < 1 }"));
}

TEST(Regressions, ADeadlineBeginsAnewWhereAnActionEndsItsGuard) {
    expect_conformance_of(
        machine("event g",
                "state A { entry x = true initial j state B { entry wait(1) } transition u0 { from j to B }\n"
                "transition u1 { from B to B action x = false; out; x = true } }\n"
                "final f transition t1 { from A to f trigger g <{2} condition x }"));
}

/// A transition may leave the state before the during action repeats its call.
TEST(Regressions, ADuringActionWaitsToRepeatACall) {
    expect_conformance_of(
        machine("", "state A { during move(x); move(x) } state B { }\ntransition t1 { from A to B }"));
}

TEST(Regressions, ADuringActionWaitsToRepeatAWriteThatIsSeen) {
    expect_conformance_of(
        "interface V { var v : nat }\n"
        "controller C { requires V sref m = S }\n"
        "stm S { requires V initial i state A { during v = 1; v = 2 } state B { }\n"
        "transition t0 { from i to A } transition t1 { from A to B } }\n"
        "module M { robotic platform P { provides V } cref c = C }\n");
}

TEST(Regressions, AFunctionWithoutParametersHasOneValue) {
    expect_conformance_of("function two() : nat { postcondition result == 2 }\n" +
                          machine("", "state A { entry move(two() == 2) }"));
}

TEST(Regressions, AVariableOfLetNeedNotBeRead) {
    expect_conformance_of(machine("", "state A { entry move(let b == x @ true) }"));
}

TEST(Regressions, ANegatedNaturalNumberIsAnInteger) {
    expect_conformance_of(machine("const k : nat = 2 var z : int", "state A { entry z = -k; move(z == -2) }"));
}

/// The operation's own variable is read only inside the operation. The result is read only after the call.
TEST(Regressions, AnOperationComputesFromItsInitialValues) {
    expect_conformance_of(
        "interface V { var v : boolean } interface Ops { op() }\n"
        "operation op() { requires V var own : boolean = false initial i final f\n"
        "transition t { from i to f action v = own } }\n"
        "controller C { event out opref o = op sref m = S connection m on out to C on out }\n"
        "stm S { requires Ops uses V event out initial i state A { entry op(); if v then out end }\n"
        "transition t0 { from i to A } }\n"
        "module M { robotic platform P { event out } cref c = C connection c on out to P on out (_async) }\n");
}

/// Both forms of index select an entry. The second one selects it from a row.
TEST(Regressions, EntriesOfMatricesAreAssigned) {
    expect_conformance_of(
        "stm S { event e : matrix(boolean, 2, 2) event out : matrix(boolean, 2, 2) var m : matrix(boolean, 2, 2)\n"
        "initial i state A { } transition t0 { from i to A }\n"
        "transition t1 { from A to A trigger e?m action m[1, 2] = false; m[2, 1] = m[1, 1]; out!m } }\n");
}

/// In CSPM a string is a sequence of characters, so the empty string is printed as the empty sequence.
TEST(Regressions, TheEmptyStringIsTheEmptySequence) {
    expect_conformance_of(
        "stm S { event e : string event out : string var x : string initial i state A { } transition t0 { from i to A "
        "}\n"
        "transition t1 { from A to A trigger e?x action out!x } }\n");
}

/// Returns a module with a machine S. Its platform provides the variables in `shared` and sends e.
std::string with_platform(const std::string& shared, const std::string& before, const std::string& body) {
    return "record Spot { at : nat free : boolean }\n"
           "interface V { " +
           shared + " }\n" + before + "stm S { requires V event e : boolean\n" + body +
           " }\n"
           "module M { robotic platform P { provides V event e : boolean } cref c = C\n"
           "connection P on e to c on e (_async) }\n";
}

std::string machine_alone(const std::string& shared, const std::string& body) {
    return with_platform(
        shared, "controller C { requires V event e : boolean sref m = S connection C on e to m on e }\n", body);
}

/// The platform receives the whole variable, so it also uses the parts that the machine does not read.
TEST(Regressions, APartOfAVariableThatNothingReadsIsWritten) {
    expect_conformance_of(machine_alone(
        "var t : nat * boolean var s : Spot var q : Seq(boolean) = <true, true> var v : vector(boolean, 2)\n"
        "var m : matrix(boolean, 2, 2) var n : boolean * Spot var w : Seq(nat * boolean) = <(| 1, true |)>",
        "initial i state A { entry t[1] = 1; s.free = false; q[2] = false; v[1] = false; m[2, 1] = false;\n"
        "n[2].at = 1; w[1][2] = false } transition t0 { from i to A }"));
}

TEST(Regressions, PartsOfVariablesAreAssignedInEveryKindOfAction) {
    expect_conformance_of(with_platform(
        "var a : boolean * boolean var b : boolean * boolean var c : boolean * boolean var d : boolean * boolean var f "
        ": boolean",
        "interface Ops { op() }\n"
        "operation op() { requires V initial i final o transition t { from i to o action d[1] = false } }\n"
        "controller C { requires V event e : boolean opref o = op sref m = S connection C on e to m on e }\n",
        "requires Ops initial i state A { entry a[1] = false during b[1] = false exit c[1] = false }\n"
        "state B { entry op(); a[2] = false } transition t0 { from i to A }\n"
        "transition t1 { from A to B trigger e?f action b[2] = false } transition t2 { from B to A trigger e?f }"));
}

/// Some variables are read only by a deadline or a wait.
TEST(Regressions, DurationsReadVariables) {
    for (const std::string type : {"nat", "int"}) {
        const std::string shared = "var d : " + type;
        const std::string declared = "record R { a : " + type + " }\nfunction f(x : " + type + ") : " + type +
                                     " { postcondition result == x }\n";
        for (const std::string body :
             {"state A { entry wait(d) } transition t0 { from i to A }",
              "state A { entry wait(f(r.a)) } transition t0 { from i to A }",
              "state A { entry (wait(1)) <{ d + 1 } } transition t0 { from i to A }",
              "state A { entry (wait(0)) <{ if d > 0 then d else r.a end } } transition t0 { from i to A }",
              "state A { } transition t0 { from i to A } transition t1 { from A to A trigger e?x <{ d + 1 } }",
              "state A { } transition t0 { from i to A } transition t1 { from A to A trigger e?x <{ 1 + f(r.a) } "
              "condition x }"})
            expect_conformance_of(declared +
                                  machine_alone(shared, "var x : boolean var r : R initial i " + std::string(body)));
    }
}

/// The models have conditionals, implications and sums in every position at which the generator composes C++ text.
TEST(Regressions, LowPrecedenceOperandsAreParenthesised) {
    expect_conformance_of(
        "record R { a : nat f : boolean }\n"
        "stm S { event e : boolean event o : boolean var b : boolean var c : boolean var n : nat\n"
        "var q : Seq(nat) = <1> var r : R initial i state A { } state B { entry\n"
        "o!((if b then n else 1 end) in {0 to 1});\n"
        "o!(1 in {(if b then n else 1 end) to (if b then 2 else n end)});\n"
        "o!(n in [if b then n else 1 end, if b then 2 else n end]);\n"
        "o!(n in (if b then n else 0 end, if b then 2 else 1 end));\n"
        "o!(1 in {n + 0 to n + 1});\n"
        "o!(n in {if b then n else 1 end, 2});\n"
        "o!((if b then n else 1 end) + (if b then 1 else n end) == (if b then n else 1 end) * (if b then n else 1 "
        "end));\n"
        "o!((if b then n else 1 end) % (if b then 2 else 1 end) == (if b then n else 1 end) / (if b then 1 else 2 "
        "end));\n"
        "o!(- (if b then n else 1 end) < (if b then n else 1 end) - (if b then n else 1 end));\n"
        "o!(not (if b then c else true end));\n"
        "o!((if b then c else true end) /\\ (if b then true else c end) \\/ (if c then b else true end));\n"
        "o!((if b then c else true end) => (if b then true else c end));\n"
        "o!((if b then c else true end) iff (if b then true else c end));\n"
        "o!((if b then c else true end) == (if b then true else c end));\n"
        "o!(not (c => b) /\\ (c => b) \\/ (c iff b));\n"
        "o!((b => c) == (c => b));\n"
        "o!((if b then r else r end).f);\n"
        "o!((if b then q else <n, 1> end)[if b then 1 else 1 end] == 1);\n"
        "o!((if b then (if c then q else <> end) else <1> end) ^ <(if b then n else 1 end)> == <n>);\n"
        "o!(if (if b then c else true end) then (if b then c else false end) else (if b then true else c end) end);\n"
        "o!(let x == (if b then n else 1 end) @ (if b then x else n end) == 1);\n"
        "o!(exists x : nat | (if b then x == n else true end) @ (if b then x > 0 else x == n end));\n"
        "o!(forall x : nat | (if b then x == n else true end) @ (if b then x > 0 else x == n end));\n"
        "o!({x : nat | if b then x == n else true end @ if b then x else n end} == {n});\n"
        "o!(1 in (if b then {n} else {1} end));\n"
        "r = R (| a = if b then n else 1 end, f = if b then c else true end |);\n"
        "if (if b then c else true end) then n = (if b then n else 1 end) end; b = (if b then c else true end) }\n"
        "transition t0 { from i to A }\n"
        "transition t1 { from A to B trigger e?b condition if b then c else true end }\n"
        "transition t2 { from A to B trigger e?b condition (if b then c else true end) /\\ (c => b) }\n"
        "transition t3 { from A to B trigger e?b condition c => b action q = <n> }\n"
        "transition t4 { from B to A action c = b; n = 1; q = <1> } }\n");
}

/// The expressions contain commas outside parentheses.
TEST(Regressions, PreconditionsHoldAnyExpression) {
    expect_conformance_of(
        "interface Ops { op(n : nat) }\n"
        "operation op(n : nat) { precondition n in {0, 1, 2} precondition n in {x : nat | x == n @ x}\n"
        "precondition (lambda x : nat, y : nat @ x + y)(n, 0) == n\n"
        "initial i final f transition t { from i to f } }\n"
        "controller C { event out opref o = op sref m = S connection m on out to C on out }\n"
        "stm S { requires Ops event out initial i state A { entry op(1); out } transition t0 { from i to A } }\n"
        "module M { robotic platform P { event out } cref c = C connection c on out to P on out (_async) }\n");
}

/// The code names values as the model does, also in nested packages.
TEST(Regressions, LiteralsOfNestedPackages) {
    expect_conformance_of(
        "package a::b::c\nenumeration Mode { one two(boolean) }\n"
        "stm S { event e : Mode event out : Mode var x : Mode initial i state A { } transition t0 { from i to A }\n"
        "transition t1 { from A to A trigger e?x action out!x } }\n");
}

/// A nested namespace hides an outer namespace with the same name.
TEST(Regressions, APackageInsideAnotherIsCalledLikeTheRuntime) {
    expect_conformance_of("package a::robochart\n" + machine("clock T", "state A { entry wait(1) ; move(x) }"));
}

/// The code stores the states of operations in members with the operations' names.
TEST(Regressions, OperationsAreCalledLikeTypesOfTheCode) {
    const std::string body =
        " initial i state A { entry wait(1) } final f transition t { from i to A }\n"
        "transition u { from A to f } }\n";
    expect_conformance_of(
        "interface Ops { State(n : nat) Nat() Types() op() opFrame() }\n"
        "operation State(n : nat) {" +
        body + "operation Nat() {" + body + "operation Types() {" + body + "operation op() {" + body +
        "operation opFrame() {" + body +
        "stm S { requires Ops initial i state A { entry State(1); Nat(); Types(); op(); opFrame() }\n"
        "transition t0 { from i to A } }\n"
        "controller C { opref o = State opref n = Nat opref t = Types opref p = op opref q = opFrame sref s = S }\n"
        "module M { robotic platform P { } cref c = C }\n");
}

/// Types that occur only in calls of toolkit functions need distinct names. Without such names, one of two tuple types
/// once replaced the other.
TEST(Regressions, TuplesThatOnlyToolkitFunctionsNeed) {
    expect_conformance_of(
        "import relation_toolkit::*\n" +
        machine(
            "var v : Set(boolean) event go",
            "state A { entry v = second((|true, {}|)) ; v = rimage({}, {3}) ; v = ran({(|3, false|), (|0, true|)}) }\n"
            "transition t1 { from A to A trigger go }"));
}

}  // namespace
}  // namespace robochart::conformance
