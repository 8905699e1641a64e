// SPDX-License-Identifier: Apache-2.0
// Tests preconditions of functions (semantics 3.5). Wherever an expression may occur, the code checks the precondition
// as the model does, and waits if the model waits. Each row conforms, although the precondition is false in some of its
// runs. Code that does not check the precondition (Fault::function_precondition_dropped) does not conform.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "conformance/check/conform.hpp"
#include "tests/conformance/bench.hpp"
#include "tests/conformance/check/expect_conforming.hpp"

namespace robochart::conformance {
namespace {

struct Position {
    const char* name;
    const char* body;  ///< body of the machine, in which % stands for the expression
};

/// `x` is the last received value. `go` leads from A to B, and `stop` leads back.
const char* const two_states = "state A { } state B { } transition back { from B to A trigger stop }";

const Position positions[] = {
    {"Assignment", "2 transition t1 { from A to B trigger go action y = % ; act(y) }"},
    {"PartOfAnAssignment", "2 transition t1 { from A to B trigger go action r = <1, 2> ; r[%] = 0 ; act(r[1]) }"},
    {"ValueOfAPart", "2 transition t1 { from A to B trigger go action r = <1, 2> ; r[2] = % ; act(r[2]) }"},
    {"Output", "2 transition t1 { from A to B trigger go action tell!(%) }"},
    {"PlatformCall", "2 transition t1 { from A to B trigger go action act(%) }"},
    {"OperationCall", "2 transition t1 { from A to B trigger go action op(%) ; act(1) }"},
    {"Guard", "2 transition t1 { from A to B trigger go condition % >= 0 action act(1) }"},
    {"GuardWithoutTrigger", "2 transition t1 { from A to B condition % >= 0 action act(1) }"},
    {"GuardUnderADeadline", "2 transition t1 { from A to B trigger go <{2} condition % >= 0 action act(1) }"},
    {"Junction",
     "2 junction J transition t1 { from A to J trigger go } transition t2 { from J to B condition % >= 0 action act(1) "
     "}"},
    {"InputStatement", "2 transition t1 { from A to B trigger go action in1[| % >= 0 |]?y ; act(y) }"},
    {"Wait", "2 transition t1 { from A to B trigger go action wait(%) ; act(1) }"},
    {"WaitInterval", "2 transition t1 { from A to B trigger go action wait([0, %]) ; act(1) }"},
    {"Deadline", "2 transition t1 { from A to B trigger go action wait(1) <{1 + %} ; act(1) }"},
    {"DeadlineOfWhatNeverWaits", "2 transition t1 { from A to B trigger go action (y = 1) <{%} ; act(1) }"},
    {"Conditional", "2 transition t1 { from A to B trigger go action if % > 1 then act(1) else act(2) end }"},
    {"ConditionalThatWaits",
     "2 transition t1 { from A to B trigger go action if % > 1 then wait(1) else wait(2) end ; act(2) }"},
    {"Entry",
     "state A { } state B { entry act(%) } transition t1 { from A to B trigger go }"
     "transition back { from B to A trigger stop }"},
    {"Exit",
     "state A { } state B { exit act(%) } transition t1 { from A to B trigger go }"
     "transition back { from B to A trigger stop }"},
    {"ExitOfAChild",
     "state A { } state B { initial j state C { exit y = % ; act(y) } transition u { from j to C }"
     "exit act(2) } transition t1 { from A to B trigger go } transition back { from B to A trigger stop }"},
    {"During",
     "state A { during y = % ; act(y) } state B { } transition t1 { from A to B trigger go }"
     "transition back { from B to A trigger stop }"},
    {"DuringCall",
     "state A { during act(%) } state B { } transition t1 { from A to B trigger go }"
     "transition back { from B to A trigger stop }"},
    {"InitialTransition",
     "state B { initial j state C { } transition u { from j to C action act(%) } } state A { }"
     "transition t1 { from A to B trigger go } transition back { from B to A trigger stop }"}};

struct Called {
    const char* name;
    const char* text;
};

std::ostream& operator<<(std::ostream& out, const Position& position) {
    return out << position.name;
}

std::ostream& operator<<(std::ostream& out, const Called& called) {
    return out << called.text;
}

/// Functions of the number x, which return x if x > 0. Otherwise x violates their precondition.
const Called functions[] = {{"OfTheModel", "some(x)"}, {"OfAToolkit", "head(if x > 0 then <x> else <> end)"}};

/// Shapes of expressions that contain a call.
const Called shapes[] = {{"Nested", "some(some(x))"},
                         {"InAPrecondition", "above(x)"},
                         {"InAnArgument", "some(head(if x > 0 then <x> else <> end))"},
                         {"UnderABinder", "size({n : nat | n >= x @ some(n)})"},
                         {"InThePredicateOfABinder", "size({n : nat | some(n + x) > 0})"},
                         {"UnderAQuantifier", "(if forall n : nat | n >= x @ some(n) > 0 then 1 else 2 end)"},
                         {"InALet", "(let k == x @ some(k))"},
                         {"InTheValueOfALet", "(let k == some(x) @ k)"},
                         {"BehindADisjunction", "(if x == 0 \\/ some(x) > 0 then 1 else 2 end)"},
                         {"InABranch", "(if x > 0 then some(x) else 0 end)"},
                         {"Last", "last(if x > 0 then <x> else <> end)"},
                         {"Tail", "size(tail(if x > 0 then <x> else <> end))"},
                         {"Front", "size(front(if x > 0 then <x> else <> end))"},
                         {"Least", "min({n : nat | n < x @ n})"},
                         {"Greatest", "max({n : nat | n < x @ n})"},
                         {"Inter", "size(Inter({n : nat | n < x @ {n}}))"}};

std::string insert_expression(std::string body, const std::string& expression) {
    if (body.front() == '2') body.replace(0, 1, two_states);
    for (std::size_t at = body.find('%'); at != std::string::npos; at = body.find('%', at + expression.size()))
        body.replace(at, 1, expression);
    return body;
}

std::string model_of(const std::string& body, const std::string& precondition = "") {
    return "import set_toolkit::* import sequence_toolkit::*\n"
           "interface Acts { act(n : nat) } interface Ops { op(n : nat) }\n"
           "interface Ev { event go event stop event in1 : nat event tell : nat }\n"
           "function some(n : nat) : nat { precondition n > 0 postcondition result == n }\n"
           "function above(n : nat) : nat { precondition some(n) > 1 postcondition result == n }\n"
           "operation op(n : nat) { " +
           precondition +
           " initial i final f transition t0 { from i to f } }\n"
           "stm S { requires Acts requires Ops uses Ev var x : nat var y : nat var r : Seq(nat) initial i\n"
           "transition t0 { from i to A } transition t { from A to A trigger in1?x }\n" +
           body +
           "\n}\n"
           "controller C { requires Acts uses Ev sref m = S opref o = op connection C on go to m on go\n"
           "connection C on stop to m on stop connection C on in1 to m on in1 connection m on tell to C on tell }\n"
           "module M { robotic platform P { provides Acts uses Ev } cref c = C\n"
           "connection P on go to c on go (_async) connection P on stop to c on stop (_async)\n"
           "connection P on in1 to c on in1 (_async) connection c on tell to P on tell (_async) }\n";
}

/// Checks that the generated code conforms, and that it differs if one of its precondition checks is omitted.
void expect_asked(const std::string& body) {
    const test::ModelFolder folder(model_of(body));
    test::Model model(folder.path());
    ASSERT_TRUE(model.diagnostics.ok()) << body;
    test::Bench bench(model, model.first_module());
    const Result schedulable = bench.judge_schedulability();
    ASSERT_EQ(schedulable.outcome, Outcome::conforms) << schedulable.reason;
    const Result result = bench.check_code();
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    constexpr auto not_asked = cpp_emit::Fault::function_precondition_dropped;
    bool killed = false;
    for (std::uint32_t site = 0; site < bench.site_count(not_asked) && !killed; ++site)
        killed = bench.check_code(not_asked, site).outcome == Outcome::differs;
    EXPECT_TRUE(killed) << bench.site_count(not_asked) << " places where it can be forgotten";
}

using Row = std::tuple<Position, Called>;

class Preconditions : public ::testing::TestWithParam<Row> {};

TEST_P(Preconditions, AreAsked) {
    const auto& [position, called] = GetParam();
    expect_asked(insert_expression(position.body, called.text));
}

std::string row_name(const ::testing::TestParamInfo<Row>& info) {
    return std::get<0>(info.param).name + std::string("_") + std::get<1>(info.param).name;
}

INSTANTIATE_TEST_SUITE_P(InEveryPosition, Preconditions,
                         ::testing::Combine(::testing::ValuesIn(positions), ::testing::ValuesIn(functions)), row_name);

const Position in_a_call[] = {
    {"PlatformCall", "2 transition t1 { from A to B trigger go action act(if % > 1 then 1 else 0 end) }"}};
INSTANTIATE_TEST_SUITE_P(OfEveryShape, Preconditions,
                         ::testing::Combine(::testing::ValuesIn(in_a_call), ::testing::ValuesIn(shapes)), row_name);

// A function as a value contains a pair for each argument that satisfies its precondition.
TEST(PreconditionsOfFunctionsAsValues, SayWhichPairsThereAre) {
    const test::ModelFolder folder(
        model_of(insert_expression("2 transition t1 { from A to B trigger go condition (|x, x|) in some }", "")));
    test::Model model(folder.path());
    (void)test::expect_conforming(model, model.first_module());
}

// The guard uses the value that the trigger receives, and so does the predicate of an input statement.
TEST(PreconditionsOfInputs, AreAskedOfTheIncomingValue) {
    expect_asked(
        "state A { } state B { } transition t1 { from A to B trigger go }\n"
        "transition t2 { from B to A trigger in1?x condition some(x) >= 0 action act(x) }");
    expect_asked("state A { } transition t1 { from A to A trigger go action in1[| some(y) >= 0 |]?y ; act(y) }");
}

// The deadline of a statement that waits forever expires. Time stops in the model, so the model is not schedulable.
TEST(PreconditionsUnderADeadline, StopTimeWhenItIsOver) {
    const test::ModelFolder folder(model_of(insert_expression(
        "2 transition t1 { from A to B trigger go action (wait(some(x)) ; act(2)) <{1} ; act(1) }", "")));
    test::Model model(folder.path());
    test::Bench bench(model, model.first_module());
    const Result result = bench.judge_schedulability();
    EXPECT_EQ(result.outcome, Outcome::not_schedulable);
    EXPECT_NE(result.reason.find("neither go on nor let time pass"), std::string::npos) << result.reason;
}

Result conformance_of(const std::string& text) {
    const test::ModelFolder folder(text);
    test::Model model(folder.path());
    diagnostics::Diagnostics found;
    EXPECT_TRUE(model.diagnostics.ok()) << text;
    return conform(model.system, model.instantiation, model.first_module(), {}, model.sources, found);
}

/// Checks that the difference comes from the model: the precondition is false, and both model and code stop at the call
/// in this line.
void expect_false_precondition(const Result& result, const std::string& condition, const std::string& line_of_call) {
    EXPECT_EQ(result.outcome, Outcome::differs) << condition << result.reason;
    EXPECT_EQ(result.reason, "the precondition `" + condition + "` of op is false");
    ASSERT_NE(result.explanation.rule, nullptr) << condition;
    EXPECT_EQ(result.explanation.rule->code, "RC-K11");
    ASSERT_EQ(result.explanation.where.size(), 2U);
    EXPECT_THAT(result.explanation.where[0], ::testing::StartsWith("precondition of op ("));
    EXPECT_THAT(result.explanation.where[1], ::testing::StartsWith("call of op ("));
    EXPECT_THAT(result.explanation.where[1], ::testing::EndsWith(":" + line_of_call + ")"));
}

// A violated precondition of an operation is reported. The code first checks the preconditions of functions that it
// calls.
TEST(PreconditionsOfOperations, AreReportedWhereAFunctionInThemHasNoValue) {
    for (const std::string condition : {"n > 0", "some(n) > 0", "min({k : nat | k < n @ k}) >= 0"})
        expect_false_precondition(
            conformance_of(model_of(insert_expression("2 transition t1 { from A to B trigger go action op(x) }", ""),
                                    "precondition " + condition)),
            condition, "9");
}

// After the call, nothing happens in the rest of the cycle: the machine does not continue, and neither does another
// machine or a during action.
TEST(PreconditionsOfOperations, StopTheCycleAtTheCall) {
    const char* const bodies[] = {"2 transition t1 { from A to B trigger go action act(1) ; op(x) ; act(2) ; tell!2 }",
                                  "state A { } state B { entry act(1) ; op(x) ; act(2) during act(2) } "
                                  "transition t1 { from A to B trigger go }",
                                  "state A { } state B { entry act(1) during op(x) initial j state D { during act(2) } "
                                  "transition k { from j to D } } transition t1 { from A to B trigger go }"};
    for (const char* const body : bodies) {
        const Result result = conformance_of(model_of(insert_expression(body, ""), "precondition n > 0"));
        expect_false_precondition(result, "n > 0", "9");
        EXPECT_THAT(result.cycles.back().outputs, ::testing::ElementsAre("act(1)")) << body;
    }
}

// Of several preconditions, the false one is named.
TEST(PreconditionsOfOperations, AreNamedOneByOne) {
    const Result result =
        conformance_of(model_of(insert_expression("2 transition t1 { from A to B trigger go action op(2) }", ""),
                                "precondition n > 1 precondition n < 2"));
    expect_false_precondition(result, "n < 2", "9");
}

// If the code has a fault and calls an operation outside its precondition, the report does not blame the model.
TEST(PreconditionsOfOperations, AreNotBlamedOnTheModelIfTheCodeIsWrong) {
    const test::ModelFolder folder(
        model_of(insert_expression("2 transition t1 { from A to B trigger go action op(2) ; act(1) }", ""),
                 "precondition n > 0"));
    test::Model model(folder.path());
    Options options;
    options.generator.fault = cpp_emit::Fault::precondition_negated;
    diagnostics::Diagnostics found;
    const Result result =
        conform(model.system, model.instantiation, model.first_module(), options, model.sources, found);
    EXPECT_EQ(result.outcome, Outcome::differs);
    EXPECT_THAT(result.reason, ::testing::StartsWith("the code calls op outside its precondition")) << result.reason;
    EXPECT_EQ(result.explanation.rule, nullptr);
}

// A during action that waits forever is interrupted when its state is left. This is the smallest model for which the
// code was once wrong.
TEST(PreconditionsOfFunctions, HoldUpADuringActionUntilItsStateIsLeft) {
    const test::ModelFolder folder(
        "interface Acts { act(n : nat) } function f() : nat { precondition false }\n"
        "stm S { requires Acts event go initial i state A { during act(f()) } state B { }\n"
        "transition t0 { from i to A } transition t1 { from A to B trigger go } }\n");
    test::Model model(folder.path());
    const Result result = test::expect_conforming(model, model.machine_named("S"));
    EXPECT_TRUE(result.deadlines && result.deadlines->holds) << "time passes while the call waits";
}

}  // namespace
}  // namespace robochart::conformance
