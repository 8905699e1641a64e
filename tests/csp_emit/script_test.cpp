// SPDX-License-Identifier: Apache-2.0
// Tests the structure of generated scripts: they parse to the same tree and use RoboTool's names. If the generator
// rejects an element, it names it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "csp_emit/base/rules.hpp"
#include "csp_emit/passes/liveness.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "tests/csp_emit/fixture.hpp"
#include "tests/semantics/sample_systems/sample_systems.hpp"
#include "tests/shared_folder.hpp"
#include "tests/source_folder.hpp"

namespace robochart::csp_emit::script_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::load_model;
using ::testing::Not;
using testing::project;

/// Checks that the script's text parses to the same tree, and returns the text.
std::string print_checked(testing::Model& model, Time time) {
    const Emission emission = model.emit(time, true);
    EXPECT_TRUE(model.diagnostics.ok()) << model.messages();
    const std::string text = cspm::print(emission.script);
    const auto source = model.sources.add("printed.csp", text);
    const cspm::Script again = cspm::read(model.sources, source, model.diagnostics);
    EXPECT_TRUE(model.diagnostics.ok()) << model.messages();
    EXPECT_TRUE(equal(emission.script, again));
    cspm::check_types(again, model.diagnostics);
    EXPECT_TRUE(model.diagnostics.ok()) << model.messages();
    if (std::getenv("ROBOCHART_SHOW") != nullptr) std::cout << text;
    return text;
}

TEST(Script, HandBuiltAggregationReadsBackEqual) {
    testing::Model m;
    m.system = ir::samples::aggregation();
    m.instantiation = ir::instantiate_system(m.system, {}, m.diagnostics);
    print_checked(m, Time::untimed);
    print_checked(m, Time::timed);
}

TEST(Script, CorpusReadsBackEqual) {
    for (const char* name : {"aggregation", "swarm_taxis"}) {
        const auto m = project(tests::source_folder().string() + "/corpus/" + name);
        ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
        print_checked(*m, Time::untimed);
        print_checked(*m, Time::timed);
    }
}

TEST(Script, SharedRoboToolModelsReadBackEqual) {
    const std::string shared = robochart::tests::shared_folder().string() + "/suite/robotool-csp-2026";
    const auto m = project(shared);
    if (m->system.machines.empty()) GTEST_SKIP() << "no shared models at " << shared;
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    print_checked(*m, Time::timed);
}

TEST(Script, UsesRoboToolsNames) {
    const auto m = project(tests::source_folder().string() + "/corpus/aggregation");
    const std::string text = print_checked(*m, Time::timed);
    for (const char* part : {"module aggregation", "module OP_MoveClockwise", "module AggregationFSM", "module stm_ref",
                             "instance ctrl_ref = AggregationController__(0)", "channel seeWall : InOut",
                             "MoveClockwiseCall : core_real.core_real", "set_linearSpeed, set_EXT_linearSpeed",
                             "sem__events", "D__(id__)", "VS_O__(id__)", "real_scale = 100"})
        EXPECT_THAT(text, HasSubstr(part));
}

TEST(Script, ParametersAvoidNamesOfEvents) {
    // A parameter with the name of a channel would be a pattern that matches only this channel.
    const auto m = load_model(R"(
        stm S {
            event v_x
            var x : nat
            initial i
            state A { entry x = x + 1 ; v_x ; if x == 1 then v_x else skip end }
            transition t0 { from i to A }
        })");
    const std::string text = print_checked(*m, Time::untimed);
    EXPECT_THAT(text, HasSubstr("(v_x_2)"));
    EXPECT_THAT(text, Not(HasSubstr("(v_x)")));
}

TEST(Script, ParametersAvoidNamesOfBlocks) {
    const auto m = load_model(R"(
        stm S {
            event a
            var x : nat var y : nat
            initial i
            state A { entry x = x + 1 ; y = x + y ; a ; if x == y then a else skip end ; a }
            transition t0 { from i to A }
        })",
                              "csp Block csp-begin\nchannel v_x\ndatatype Kind = v_y | other\ncsp-end");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    EXPECT_THAT(print_checked(*m, Time::untimed), HasSubstr("(v_x_2, v_y_2)"));
    EXPECT_EQ(testing::decide_with(*m, Time::untimed, "assert S::D__(0) [FD= S::a.out -> S::a.out -> S::a.out -> STOP"),
              std::vector<std::string>{"holds"});
}

TEST(Script, VariablesThatNothingReadsAreNotKept) {
    const auto m = load_model("stm S { var x : nat initial i state A { entry x = 2 } transition t0 { from i to A } }");
    EXPECT_THAT(print_checked(*m, Time::untimed), Not(HasSubstr("v_x")));
}

TEST(Script, ValuesThatDoNotMatterAnyMoreAreDropped) {
    // In B and after it, x is overwritten before it is read. In A, the guard reads x.
    const auto m = load_model(R"(
        stm S {
            event a : nat
            var x : nat
            initial i
            state A { }
            state B { }
            transition t0 { from i to A action x = 1 }
            transition t1 { from A to B trigger a ? x condition x > 0 }
            transition t2 { from A to B condition x == 2 }
            transition t3 { from B to A trigger a ? x }
        })");
    const std::string text = print_checked(*m, Time::untimed);
    EXPECT_THAT(text, HasSubstr("A__(v_x) ="));
    EXPECT_THAT(text, HasSubstr("B__ ="));
}

// Every call of an operation with a large variable refers to its default by name, so the table of 49 zeros occurs only
// once.
TEST(Script, LargeDefaultsAreWrittenOnce) {
    const auto m = load_model(R"(
        interface Ops { walk() }
        operation walk() {
            var m : matrix(nat, 7, 7)
            event a : nat
            initial i
            final f
            state W { entry a ! (m[1, 1]) }
            transition t0 { from i to W }
            transition t1 { from W to f condition m[1, 1] == 0 }
        }
        controller C {
            opref w = walk
            event a : nat
            stm S {
                event a : nat
                requires Ops
                initial i
                state A { during walk() ; walk() }
                transition t0 { from i to A }
            }
            connection S on a to C on a
        })");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    const std::string text = print_checked(*m, Time::untimed);
    std::size_t rows = 0;
    for (auto at = text.find("(0,0,0,0,0,0,0)"); at != std::string::npos; at = text.find("(0,0,0,0,0,0,0)", at + 1))
        ++rows;
    EXPECT_EQ(rows % 7, 0U);
    EXPECT_THAT(text, HasSubstr("default_0__ ="));
    EXPECT_LE(rows, 2U * 7U);
    EXPECT_EQ(testing::decide_with(*m, Time::untimed, "assert C::a.out.0 -> C::a.out.0 -> STOP [T= C::D__(0)"),
              std::vector<std::string>{"holds"});
}

TEST(Liveness, GoesBackwardsAlongCalls) {
    namespace b = cspm::build;
    // P passes x to Q as y, Q passes y on to R, and R outputs it. No function reads z.
    FamilyCalls calls;
    std::vector<Function> family{
        {"P", {}, b::prefix(b::name("a"), calls.add_call("Q", {{"y", b::name("x")}, {"z", b::name("x")}}))},
        {"Q", {}, b::prefix(b::name("a"), calls.add_call("R", {{"z", b::number(3)}}))},
        {"R", {}, b::prefix(b::name("c"), {b::output(b::name("y"))}, calls.add_call("P", {{"x", b::name("y")}}))}};
    auto initial = calls.add_call("P", {{"x", b::number(1)}, {"y", b::number(2)}});
    EXPECT_THAT(find_parameters(family, initial, calls, {{"x", "y", "z"}, {}, {}, {}, {}, {}}), IsEmpty());
    EXPECT_THAT(family[0].parameters, ElementsAre("x"));
    EXPECT_THAT(family[1].parameters, ElementsAre("y"));
    EXPECT_THAT(family[2].parameters, ElementsAre("y"));
    EXPECT_EQ(cspm::print(initial), "P(1)");
    EXPECT_EQ(cspm::print(family[0].body), "a -> Q(x)");
    EXPECT_EQ(cspm::print(family[1].body), "a -> R(y)");
}

TEST(Liveness, WhatNoCallGivesIsReported) {
    namespace b = cspm::build;
    FamilyCalls calls;
    std::vector<Function> family{{"P", {}, b::prefix(b::name("c"), {b::output(b::name("x"))}, b::stop())}};
    auto initial = calls.add_call("P", {});
    EXPECT_THAT(find_parameters(family, initial, calls, {{"x"}, {}, {}, {}, {}, {}}), ElementsAre("x"));
}

TEST(Liveness, ClocksThatACallDoesNotSpeakOfCountOnWithTime) {
    namespace b = cspm::build;
    FamilyCalls calls;
    std::vector<Function> family{
        {"P", {}, b::prefix(b::name("tock"), calls.add_call("Q", {}, true))},
        {"Q", {}, b::guard(b::binary(cspm::ExprKind::equal, b::name("c"), b::name("n")), calls.add_call("P", {}))}};
    auto initial = calls.add_call("P", {{"c", b::number(0)}, {"n", b::number(2)}});
    const cspm::ExprPtr step = b::call("clock_step", {b::name("c"), b::number(3)});
    (void)find_parameters(family, initial, calls, {{"c", "n"}, {{"c", step}}, {}, {}, {}, {}});
    EXPECT_EQ(cspm::print(family[0].body), "tock -> Q(clock_step(c, 3), n)");
    EXPECT_EQ(cspm::print(family[1].body), "c == n & P(c, n)");
}

// O is called from A and from B. x is read after the call from A, but not after the call from B, so the latter need not
// pass x.
TEST(Liveness, ASharedFunctionTakesFromEachCallOnlyWhatIsReadBehindIt) {
    namespace b = cspm::build;
    const auto there = [](int place) { return b::sequence({b::number(place)}); };
    const cspm::ExprPtr from_a = there(0);
    const cspm::ExprPtr from_b = there(1);
    const cspm::ExprPtr first = b::binary(cspm::ExprKind::equal, b::call("front", {b::name("r")}), b::number(0));
    FamilyCalls calls;
    std::vector<Function> family{
        {"A", {}, b::prefix(b::name("a"), calls.add_call("O", {{"r", from_a}}))},
        {"B", {}, b::prefix(b::name("b"), calls.add_call("O", {{"r", from_b}}))},
        {"O", {}, b::prefix(b::name("o"), calls.add_call("End", {}))},
        {"End", {}, b::if_(first, calls.add_call("BehindA", {}), calls.add_call("BehindB", {}))},
        {"BehindA", {}, b::prefix(b::name("c"), {b::output(b::name("x"))}, calls.add_call("B", {}))},
        {"BehindB", {}, calls.add_call("A", {{"x", b::number(5)}})}};
    auto initial = calls.add_call("A", {{"x", b::number(4)}});
    const Candidates candidates{
        {"x", "r"}, {},  {},
        {},         "r", {{from_a.get(), {"BehindA", b::sequence({})}}, {from_b.get(), {"BehindB", b::sequence({})}}}};
    EXPECT_THAT(find_parameters(family, initial, calls, candidates), IsEmpty());
    EXPECT_EQ(cspm::print(family[0].body), "a -> O(x, <0>)");
    EXPECT_THAT(family[1].parameters, IsEmpty());
    fill_unneeded(family, calls, {{"x", b::number(0)}, {"r", b::number(0)}});
    EXPECT_EQ(cspm::print(family[1].body), "b -> O(0, <1>)");
}

TEST(Files, DefinitionsAndAssertionsThatIncludeThem) {
    const auto m = load_model("stm S { initial i state A { } transition t0 { from i to A } }");
    const Emission emission = m->emit(Time::timed, true);
    const auto written = files(emission, Time::timed, "model");
    ASSERT_EQ(written.size(), 2U);
    EXPECT_EQ(written[0].path, "csp-gen/timed/model.csp");
    EXPECT_EQ(written[1].path, "csp-gen/timed/model_assertions.csp");
    EXPECT_THAT(written[0].text, HasSubstr("module S"));
    EXPECT_THAT(written[0].text, Not(HasSubstr("\nassert")));
    EXPECT_THAT(written[0].text, HasSubstr("the assertions are in model_assertions.csp"));
    EXPECT_THAT(written[1].text, HasSubstr("`refines model_assertions.csp`"));
    EXPECT_THAT(written[1].text, HasSubstr("include \"model.csp\""));
    EXPECT_THAT(written[1].text, HasSubstr("assert S::D__(0) :[divergence free]"));
}

/// A user who opens the file in another tool finds the claims by name and the blocks with their comments.
TEST(Files, KeepNamesOfClaimsAndCommentsOfBlocks) {
    const auto m = testing::model_of(
        {{"m/s.rct", "stm S { event a initial i state A { } transition t0 { from i to A } }"},
         {"m/s.assertions",
          "untimed assertion Rests : S equals P\n"
          "untimed csp P csp-begin\n  -- P does nothing\n  P = STOP -- at all\ncsp-end\n"
          "untimed csp Instantiations csp-begin\n  -- small numbers\n  nametype core_nat = {0..1}\ncsp-end\n"}});
    const auto written = files(m->emit(Time::untimed), Time::untimed, "s");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    EXPECT_THAT(written[0].text, HasSubstr("-- small numbers\nnametype core_nat = {0..1}\n"));
    EXPECT_THAT(written[1].text, HasSubstr("-- P does nothing\n-- at all\nP = STOP\n"));
    EXPECT_THAT(written[1].text, HasSubstr("\n\n-- Rests [untimed] S equals P, m/s.assertions:1\n"
                                           "assert P [FD= S::D__(0)\nassert S::D__(0) [FD= P\n"));
}

TEST(Provenance, TellsEventsAndPlacesInTheModelsWords) {
    const auto m = load_model(R"(
        stm S {
            event a : nat
            var x : nat
            initial i
            state A { entry x = x + 1 ; a ! x }
            transition t0 { from i to A }
            transition t1 { from A to A trigger a ? x condition x > 0 }
            transition t2 { from A to A condition x == 2 }
        })");
    const Provenance provenance = m->emit(Time::untimed).provenance;
    EXPECT_EQ(provenance.events.at("S::a.in").kind, MeaningKind::trigger);
    EXPECT_EQ(provenance.events.at("S::a.in").types.size(), 1U);
    EXPECT_EQ(provenance.events.at("S::internal__.S::TID_t0").text, "t0: i -> A");
    EXPECT_EQ(provenance.events.at("S::A::entered").kind, MeaningKind::entered);
    EXPECT_EQ(provenance.definitions.at("S::A__").text, "in A");
    EXPECT_THAT(provenance.definitions.at("S::A__").parameters, ElementsAre("x"));
}

// The script defines a machine only once. A module with the same name, a machine whose name has the same ending, and
// the instances of the machine have distinct names.
TEST(Provenance, IsThereForEveryPlaceOfAMachine) {
    const auto m = load_model(R"(
        module M {
            robotic platform R { event b }
            cref SS = C
            connection R on b to SS on b (_async)
        }
        controller C {
            event b
            sref S1 = S
            connection C on b to S1 on a
        }
        stm S {
            event a
            initial i
            state A { }
            transition t0 { from i to A }
            transition t1 { from A to A trigger a }
        })");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    const Emission emission = m->emit(Time::timed);
    const Provenance& provenance = emission.provenance;
    for (const std::string path : {"S", "C::S1", "M::SS::S1"}) {
        EXPECT_EQ(provenance.events.at(path + "::a.in").text, "input a");
        EXPECT_EQ(provenance.events.at(path + "::internal__." + path + "::TID_t0").text, "t0: i -> A");
        EXPECT_EQ(provenance.events.at(path + "::A::entered").kind, MeaningKind::entered);
        EXPECT_EQ(provenance.definitions.at(path + "::A__").text, "in A");
    }
    EXPECT_EQ(testing::decide_with(*m, Time::timed, "assert M::D__(0) [T= M::b.in -> M::b.in -> STOP"),
              std::vector<std::string>{"holds"});
}

/// Adds the channels of modules, by their qualified names.
void collect_channels(const std::vector<cspm::DeclPtr>& decls, const std::string& path, std::vector<std::string>& out) {
    for (const cspm::DeclPtr& decl : decls) {
        const std::string inside = decl->kind == cspm::DeclKind::module ? path + decl->names.front() + "::" : path;
        if (decl->kind == cspm::DeclKind::channel && !path.empty())
            for (const std::string& name : decl->names) out.push_back(path + name);
        collect_channels(decl->decls, inside, out);
        collect_channels(decl->exports, inside, out);
    }
}

// A counterexample can show only events with a description, so every event of a component has provenance.
TEST(Provenance, HasAMeaningForEveryChannelOfEveryComponent) {
    const auto m = load_model(R"(
        interface V { var v : nat }
        interface O { op(n : nat) far(n : nat) }
        robotic platform P { provides V provides O event out : nat }
        module M {
            robotic platform R { provides V provides O event out : nat event e }
            cref C1 = C
            connection C1 on out to R on out (_async)
            connection R on e to C1 on e (_async)
        }
        controller C {
            requires V requires O event out : nat event e
            sref S1 = S sref S2 = S
            connection S1 on a to S2 on b
            connection S1 on out to C on out
            connection C on e to S1 on e
        }
        stm S {
            requires V requires O event a : nat event b : nat event out : nat event e clock T var x : nat
            initial i
            junction j
            state A {
                entry x = x + 1 ; a ! x
                during far(x)
                exit v = 1
                initial i
                state B { entry wait(1) }
                transition t0 { from i to B }
            }
            final f
            transition t0 { from i to A }
            transition t1 { from A to j trigger b ? x condition x > 0 }
            transition t2 { from j to A condition since(T) > 2 action # T ; out ! x }
            transition t3 { from j to f condition since(T) <= 2 }
        })");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    for (const bool memories : {false, true})
        for (const Time time : {Time::untimed, Time::timed}) {
            Options options;
            options.share_modules = false;  // no sharing, so that every instance has its channels
            if (memories) options.states_of_a_process = 0;
            const Emission emission = emit(m->system, m->instantiation, time, options, m->sources, m->diagnostics);
            std::vector<std::string> channels;
            collect_channels(emission.definitions.decls, "", channels);
            EXPECT_GT(channels.size(), 40U);
            for (const std::string& channel : channels) {
                const auto known = emission.provenance.events.lower_bound(channel);
                const bool there = known != emission.provenance.events.end() && known->first.rfind(channel, 0) == 0;
                EXPECT_TRUE(there) << channel;
            }
        }
}

TEST(Rules, ConstantsWithoutAValueAreRefused) {
    const auto m = load_model("stm S { const c:real = 1 / 0 initial i state A { } transition t0 { from i to A } }");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    (void)m->emit(Time::untimed);
    EXPECT_THAT(m->codes(), ::testing::Contains("RC-C01"));
}

/// Returns a system with an operation that uses an event and a variable of its caller.
ir::System calling_system() {
    ir::System system = ir::samples::aggregation();
    ir::Event tick;
    tick.name = "tick";
    system.machines[0].events.push_back(tick);
    ir::Variable height;
    height.name = "height";
    height.type = ir::samples::CoreTypes{}.nat;
    height.scope = ir::VariableScope::required;
    system.machines[0].variables.push_back(height);
    return system;
}

TEST(Rules, WhatAnOperationNeedsItsCallerMustHave) {
    testing::Model m;
    m.system = calling_system();
    m.instantiation = ir::instantiate_system(m.system, {}, m.diagnostics);
    (void)m.emit(Time::untimed);
    EXPECT_THAT(m.codes(), ::testing::Contains("RC-C03"));
    EXPECT_THAT(m.messages(), HasSubstr("operation MoveClockwise needs the event tick"));
    EXPECT_THAT(m.messages(), HasSubstr("operation MoveClockwise needs the variable height"));
}

TEST(Rules, RecursiveCallsAreRefused) {
    testing::Model m;
    m.system = ir::samples::aggregation();
    // Replaces the action of MoveClockwise by a call of itself.
    ir::Stmt call;
    call.kind = ir::StmtKind::call;
    call.operation = ir::OperationId{0};
    call.args = m.system.machines[2].nodes[1].entry->args;
    m.system.machines[0].nodes[1].entry = std::make_shared<const ir::Stmt>(call);
    m.instantiation = ir::instantiate_system(m.system, {}, m.diagnostics);
    (void)m.emit(Time::untimed);
    EXPECT_THAT(m.codes(), ::testing::Contains("RC-C02"));
}

TEST(Rules, TooManyCombinationsOfDuringActionsAreRefused) {
    std::string actions = "a";
    for (int i = 0; i < 14; ++i) actions += " ; a";
    std::string inner = "state L { during " + actions + " }";
    std::string name = "L";
    for (const char* outer : {"C1", "C2", "C3"}) {
        inner = "state " + std::string(outer) + " { during " + actions + " initial i " + inner +
                " transition t { from i to " + name + " } }";
        name = outer;
    }
    const auto m = load_model("stm S { event a initial i " + inner + " transition t { from i to C3 } }");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    (void)m->emit(Time::untimed);
    EXPECT_THAT(m->codes(), ElementsAre("RC-C06"));
}

// The two elements of each pair would have the same name in CSPM. Both are used, and their behaviours stay distinct.
TEST(Rules, NamesThatTwoElementsWouldShareGetANumber) {
    const auto m = load_model(R"(
        type K
        function a(p : nat) : nat { postcondition result == p }
        interface V { var x : nat }
        interface O { go() }
        interface E { event K : K event a event set_x : nat event goCall }
        stm S {
            uses E requires V requires O var y : K
            initial i state a { } state S { }
            transition t { from i to a }
            transition u { from a to S trigger K ? y action set_x ! 1 ; goCall ; go() ; x = a(2) ; a }
        })");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    EXPECT_EQ(testing::check_equivalence(*m, Time::untimed, "Alone", "Spec", R"(
        Alone = S::VS__(0) [| {| S::set_EXT_x |} |] SKIP
        Spec = S::a_2::entered -> S::K.in?x -> S::set_x_1.out.1 -> S::goCall_1.out -> S::goCall -> S::set_x.2 ->
               S::a.out -> S::S::entered -> STOP)"),
              "holds");
    std::set<std::string> renamed;
    for (const auto& finding : m->diagnostics.sorted_findings())
        if (finding.rule == &rules::name_of_another) renamed.insert(finding.arguments[0] + " " + finding.arguments[1]);
    EXPECT_THAT(renamed,
                ::testing::UnorderedElementsAre("K K_1", "a a_1", "a a_2", "set_x set_x_1", "goCall goCall_1"));
}

TEST(Rules, NamesOfCspmGetANumber) {
    const auto m = load_model(R"(
        stm member {
            event union const c:nat = 1
            initial i
            state within { entry union }
            transition t0 { from i to within }
            transition t1 { from within to within condition 1 in {c} }
        }
        controller C { event out sref part = member connection part on union to C on out })",
                              "assertion A1 : C is deadlock-free with constant c of C::part set to 2");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    const std::string text = print_checked(*m, Time::untimed);
    EXPECT_THAT(m->codes(), ElementsAre("RC-C04", "RC-C04", "RC-C04", "RC-C04"));
    for (const char* part :
         {"module member_1", "module within_1", "channel union_1", "channel out_1", "const_member_1_c"})
        EXPECT_THAT(text, HasSubstr(part));
}

/// Names of types and functions start with the name of their package. If that name has no letter, no numeric suffix
/// makes it a valid CSPM name.
TEST(Rules, PackagesWithoutALetterGetAnotherName) {
    for (const auto& [package, expected] :
         {std::pair("_", "name_1"), std::pair("__", "name_1"), std::pair("_1", "name_1"), std::pair("_x", "x_1")}) {
        const auto m = load_model("package " + std::string(package) + R"(
            enumeration Mode { one two }
            function f(x : nat) : Mode { }
            stm S { event e : Mode initial i state A { entry e!f(1) } transition t0 { from i to A } })");
        ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
        const std::string text = print_checked(*m, Time::untimed), name = expected;
        for (const std::string& part : {"datatype " + name + "_Mode = " + name + "_Mode_one | " + name + "_Mode_two",
                                        name + "_f(", "module " + name})
            EXPECT_THAT(text, HasSubstr(part)) << package;
    }
}

TEST(Rules, NamesThatOnlyTheLibraryUsesAreKeptInsideComponents) {
    const auto m = load_model(
        "package P stm S { event inter initial i state head { entry inter } "
        "transition t0 { from i to head } }");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    EXPECT_THAT(print_checked(*m, Time::timed), HasSubstr("channel inter"));
    EXPECT_THAT(m->codes(), ElementsAre());
}

TEST(Rules, TableIsInOrder) {
    std::string last;
    for (const diagnostics::Rule* rule : rules::all) {
        EXPECT_LT(last, rule->code);
        last = rule->code;
    }
}

TEST(Assertions, EachPropertyHasItsForm) {
    const auto m = load_model(
        "stm S { initial i state A { } final f transition t0 { from i to A } transition t1 { from A to f } }",
        R"(
        untimed assertion A1 : S is deadlock-free
        timed assertion A2 : S is deadlock-free
        timed assertion A3 : S is timelock-free
        untimed assertion A4 : S terminates
        untimed assertion A5 : S does not terminate
        untimed assertion A6 : S::A is reachable in S
        untimed assertion A7 : S::A is not reachable in S
        untimed assertion A8 : S refines S in the traces model
        timed assertion A9 : S refines S in the tick-tock model
        untimed assertion B2 : S is not equal to S in the failures model
        untimed assertion B3 : S is deadlock-free in the failures model
        untimed assertion B1 : S is not deterministic
    )");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    std::string text;
    for (const Time time : {Time::untimed, Time::timed}) {
        for (const Obligation& obligation : m->emit(time).obligations) {
            text += obligation.title + "\n";
            cspm::Script script;
            script.decls = obligation.preparation;
            script.decls.insert(script.decls.end(), obligation.assertions.begin(), obligation.assertions.end());
            text += obligation.assertions.empty() ? obligation.reason + "\n" : cspm::print(script);
        }
    }
    for (const char* part :
         {"assert S::D__(0) :[deadlock free]\n", "assert not S::D__(0) :[deadlock free]\n",
          "assert S::D__(0) ; RUN({r__}) :[deadlock free]\n", "assert STOP [T= (S::D__(0) ; r__ -> STOP) |\\ {r__}\n",
          "assert not SKIP [T= S::VS__(0) |\\ {| S::A::entered |}\n",
          "assert SKIP [T= S::VS__(0) |\\ {| S::A::entered |}\n", "assert S::D__(0) [T= S::D__(0)\n",
          "assert MS_A9::TT(S::D__(0)) [T= MS_A9::TT(S::D__(0))\n", "instance MS_A9 = model_shifting(",
          "assert not S::D__(0) [F= S::D__(0)\nassert not S::D__(0) [F= S::D__(0)\n",
          "S::D__(0) :[deadlock free [F]]\n", "assert not S::D__(0) :[deterministic]\n",
          "S::D__(0)[[ tock <- tock, tock <- tock' ]]",
          "assert RUN({tock}) ||| CHAOS(diff(Events, {| tock |})) [F= S::D__(0)\n", "A2 [timed] S is deadlock-free"})
        EXPECT_THAT(text, HasSubstr(part));
}

TEST(CspBlocks, AreSplicedAndInstantiationsReplaceTheGeneratedOnes) {
    const auto m = load_model(
        "stm S { const c : nat event n : nat initial i state A { entry n ! c } transition t0 { from i to A } }",
        R"(
        csp Instantiations csp-begin
            nametype core_nat = {0..5}
            const_S_c = 4
        csp-end
        csp Spec csp-begin
            Spec = S::n.out.4 -> STOP
        csp-end
        untimed assertion A : S equals Spec
    )");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    const std::string text = print_checked(*m, Time::untimed);
    EXPECT_THAT(text, HasSubstr("const_S_c = 4"));
    EXPECT_THAT(text, Not(HasSubstr("const_S_c = 0")));
    EXPECT_THAT(text, HasSubstr("Spec = S::n.out.4 -> STOP"));
    EXPECT_THAT(text, HasSubstr("assert Spec [FD= S::D__(0, const_S_c)"));
}

TEST(CspBlocks, SyntaxErrorsPointIntoTheAssertionsFile) {
    const auto m = load_model("stm S { initial i state A { } transition t0 { from i to A } }",
                              "csp Spec csp-begin\nSpec = = STOP\ncsp-end\n");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    (void)m->emit(Time::untimed);
    EXPECT_THAT(m->messages(), HasSubstr("model.assertions:2"));
}

}  // namespace
}  // namespace robochart::csp_emit::script_test
