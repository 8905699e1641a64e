// SPDX-License-Identifier: Apache-2.0
// Tests representative values (docs/conformance.md): for which types a few values represent all, and which values are
// chosen. Faults found with all values are also found with the representatives.
#include "conformance/model/representatives.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "conformance/check/conform.hpp"
#include "cpp_emit/plan/resolve_component.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

using cpp_emit::Fault;

/// A machine that passes records on.
constexpr const char* forward = R"(
datatype Scan { a : real b : real c : real d : real e : real f : real }
enumeration Kind { near far }
interface Out { show(one : Scan, two : Scan, k : Kind) }
stm Forward {
    requires Out
    event scan : Scan
    event answer : Scan
    event again
    var last : Scan
    var none : Scan
    initial i
    state Idle { }
    state Busy { }
    transition t0 { from i to Idle }
    transition t1 { from Idle to Busy trigger scan?last action show(last, none, Kind::near); wait(1) }
    transition t3 { from Busy to Idle trigger again action answer!last; wait(1) }
}
)";

/// A machine that extracts records from other records and stores them in others. It tests the fields that are not
/// records.
constexpr const char* unpack = R"(
datatype Scan { a : real b : real c : real d : real e : real f : real }
enumeration Kind { near far }
datatype Message { kind : Kind scan : Scan }
stm Unpack {
    event message : Message
    event answer : Scan
    event forward : Message
    var m : Message
    initial i
    state Idle { }
    transition t0 { from i to Idle }
    transition t1 { from Idle to Idle trigger message?m condition m.kind == Kind::far action answer!(m.scan); wait(1) }
    transition t2 { from Idle to Idle trigger message?m condition m.kind == Kind::near
                    action forward!Message (| kind = Kind::far, scan = m.scan |); wait(1) }
}
)";

ir::InstantiationOptions two_numbers() {
    ir::InstantiationOptions options;
    for (const char* const kind : {"nat", "int", "real"}) options.ranges[kind] = {0, 1};
    return options;
}

Representatives choose_for_text(const std::string& text) {
    const test::ModelFolder folder(text);
    test::Model model(folder.path());
    const auto component = cpp_emit::resolve_component(
        model.system, model.instantiation, model.machine_named(model.system.machines.front().name), model.diagnostics);
    return choose_representatives(model.system, model.instantiation, *component);
}

Result check_text(const std::string& text, Fault fault = Fault::none, const ir::InstantiationOptions& values = {}) {
    const test::ModelFolder folder(text);
    test::Model model(folder.path(), values);
    Options options;
    options.generator.fault = fault;
    options.walks.cycles = 0;
    diagnostics::Diagnostics found;
    return conform(model.system, model.instantiation, model.machine_named(model.system.machines.front().name), options,
                   model.sources, found);
}

TEST(Representatives, AreTheDefaultAndTwoThatDifferInEveryPart) {
    const Representatives few = choose_for_text(forward);
    ASSERT_EQ(few.types.size(), 1U);
    EXPECT_EQ(few.types[0].name, "Scan");
    EXPECT_EQ(few.types[0].values, 3U);
    const std::vector<ir::Value>& values = few.instantiation.representatives.at(few.types[0].type.index);
    ASSERT_EQ(values.size(), 3U);
    for (std::size_t part = 0; part < 6; ++part)
        EXPECT_NE(values[0].parts[part], values[1].parts[part]) << "the first two are not the default";
    std::set<ir::Value> parts(values[0].parts.begin(), values[0].parts.end());
    EXPECT_EQ(parts.size(), 5U) << "as many as there are reals";
}

TEST(Representatives, AreNotUsedWhereAllCanBeExplored) {
    const test::ModelFolder folder(forward);
    test::Model model(folder.path(), two_numbers());
    const auto component = cpp_emit::resolve_component(model.system, model.instantiation,
                                                       model.machine_named("Forward"), model.diagnostics);
    EXPECT_TRUE(choose_representatives(model.system, model.instantiation, *component).types.empty());
}

/// Returns a machine that receives a block of 15 reals. The action or condition reads the block.
std::string with_block(const std::string& action) {
    return "stm S { event block : matrix(real, 3, 5) event answer : matrix(real, 3, 5) var b : matrix(real, 3, 5)\n"
           "var c : matrix(real, 3, 5) initial i state A { } transition t0 { from i to A }\n"
           "transition t1 { from A to A trigger block?b " +
           action + " } }\n";
}

TEST(Representatives, OnlyOfWhatNothingDependsOn) {
    EXPECT_EQ(choose_for_text(with_block("action answer!b")).types.size(), 1U);
    EXPECT_EQ(choose_for_text(with_block("action c = b; wait(1); answer!c")).types.size(), 1U);
    for (const char* const depends :
         {"condition b == c action answer!b", "action answer!(b + c)",
          "action answer!(if b[1, 1] > 0 then b else c end)", "action b[1, 1] = 0; answer!b",
          "condition exists x : matrix(real, 3, 5) @ x == b action answer!b"})
        EXPECT_TRUE(choose_for_text(with_block(depends)).types.empty()) << depends;
}

/// A comparison of messages also compares the scans in them. A test of one field does not.
TEST(Representatives, AreNotPartsOfWhatIsCompared) {
    const auto text = [](const char* condition) {
        return fmt::format(
            "record R {{ a : real b : real c : real d : real e : real f : real }}\n"
            "record P {{ scan : R near : boolean }}\n"
            "stm S {{ event all : P event one : R event answer : R event same var p : P var q : P var s : Set(P)\n"
            "var x : R initial i state A {{ }} transition t0 {{ from i to A }}\n"
            "transition t1 {{ from A to A trigger all?p condition {} action same; q = p }}\n"
            "transition t2 {{ from A to A trigger one?x action answer!x }} }}\n",
            condition);
    };
    EXPECT_FALSE(choose_for_text(text("p.near")).types.empty());
    EXPECT_FALSE(choose_for_text(text("p.near == q.near")).types.empty());
    for (const char* const compared : {"p == q", "not (p != q)", "s == {}", "p in s", "(|p, q|) == (|q, p|)"})
        EXPECT_TRUE(choose_for_text(text(compared)).types.empty()) << compared;
}

/// The representatives include the constants to which variables are initialised.
TEST(Representatives, HaveTheValuesFromTheStart) {
    const std::string text =
        "datatype R { a : real b : real c : real d : real e : real f : real }\n"
        "stm S { const k : R = R (| a = 1, b = 1, c = 1, d = 1, e = 1, f = 1 |) event in1 : R event answer : R var v : "
        "R\n"
        "initial i state A { } transition t0 { from i to A }\n"
        "transition t1 { from A to A trigger in1?v action answer!v; wait(1); v = k } }\n";
    const Representatives few = choose_for_text(text);
    ASSERT_EQ(few.types.size(), 1U);
    EXPECT_EQ(few.types[0].values, 4U);
}

/// Numbers are represented too, if a literal makes their carrier large.
TEST(Representatives, OfNumbers) {
    const std::string text =
        "stm S { event given1 : real event answer : real var v : real initial i state A { } transition t0 { from i to "
        "A "
        "}\n"
        "transition t1 { from A to A trigger given1?v action answer!v; wait(1); v = 9000 } }\n";
    const Representatives few = choose_for_text(text);
    ASSERT_EQ(few.types.size(), 1U);
    EXPECT_EQ(few.types[0].name, "real");
    EXPECT_EQ(few.instantiation.real, (std::vector<std::int64_t>{-2, -1, 0, 1, 9000})) << "1 is a literal too";
    const Result result = check_text(text);
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
}

TEST(FewValues, ConformWhereAllDo) {
    const Result few = check_text(forward);
    EXPECT_EQ(few.outcome, Outcome::conforms) << few.reason;
    ASSERT_EQ(few.represented.size(), 1U);
    EXPECT_EQ(few.represented[0].type, "Scan");
    const Result all = check_text(forward, Fault::none, two_numbers());
    EXPECT_EQ(all.outcome, Outcome::conforms) << all.reason;
    EXPECT_TRUE(all.represented.empty());
    EXPECT_LT(few.code_states, all.code_states);
}

TEST(FewValues, RepresentPartsOfInspectedRecords) {
    const Result result = check_text(unpack);
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    ASSERT_EQ(result.represented.size(), 1U);
    EXPECT_EQ(result.represented[0].type, "Scan");
    EXPECT_EQ(check_text(unpack, Fault::field_dropped).outcome, Outcome::differs);
}

TEST(FewValues, FindTheFaultsThatAllFind) {
    int found = 0;
    for (const Fault fault : {Fault::value_not_stored, Fault::fields_lost, Fault::wrong_output,
                              Fault::assignment_dropped, Fault::send_dropped, Fault::argument_swapped,
                              Fault::wrong_input, Fault::guard_dropped, Fault::wait_dropped}) {
        const Result few = check_text(forward, fault);
        const Result all = check_text(forward, fault, two_numbers());
        EXPECT_EQ(few.outcome, all.outcome) << static_cast<int>(fault) << " " << few.reason << " | " << all.reason;
        found += all.outcome == Outcome::differs ? 1 : 0;
    }
    EXPECT_GE(found, 5);
}

/// The model may output either of two records, and so may the code. With two names, a wrong record could by chance be
/// equal to the right one. When the next cycle begins, the model may still send x or y, and it reads two more records,
/// so four names are needed.
TEST(FewValues, AreMoreIfTheModelChoosesBetweenValues) {
    const std::string text =
        "datatype R { a : real b : real c : real d : real e : real f : real }\n"
        "stm S { event one : R event two : R event answer : R var x : R var y : R\n"
        "initial i state A { } state B { } junction j transition t0 { from i to A }\n"
        "transition t1 { from A to B trigger one?x } transition t2 { from B to j trigger two?y }\n"
        "transition t3 { from j to A action wait(1); answer!x } transition t4 { from j to A action wait(1); answer!y } "
        "}\n";
    const Result result = check_text(text);
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    ASSERT_EQ(result.represented.size(), 1U);
    EXPECT_EQ(result.represented[0].values, 6U) << "the initial value and five names";
}

}  // namespace
}  // namespace robochart::conformance
