// SPDX-License-Identifier: Apache-2.0
// Tests that every seeded fault changes the behaviour of the controller at its own place. A fault must not affect code
// that is generated without it.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"

namespace robochart::cpp_emit::fault_test {
namespace {

using testing::component_named;
using testing::Controller;
using testing::Registers;

struct Case {
    Fault fault;
    const char* name;
    const char* body;               ///< of machine M
    std::vector<Registers> script;  ///< inputs that show the difference
};

std::ostream& operator<<(std::ostream& out, const Case& test_case) {
    return out << test_case.name;
}

const char* const guarded = R"(
event a : nat event x : nat var v : nat = 0 var w : nat = 0
initial i transition t0 { from i to A } state A {} state B { entry x!9 }
transition t1 { from A to B trigger a?v condition v > 1 }
transition t2 { from A to A trigger a?w condition w < 2 action x!5 }
)";

const char* const nested = R"(
event a event b event c event x : nat
initial i transition t0 { from i to O }
state O { initial j state P {} state Q { exit x!1 } transition u0 { from j to P } transition u1 { from P to Q trigger c }
          transition u2 { from Q to P trigger c action x!7 } }
state R {}
transition t1 { from O to R trigger a }
transition t2 { from R to O trigger b }
)";

const char* const actions = R"(
event a requires I clock T var v : nat = 0
initial i transition t0 { from i to A }
state A { entry tell(1) exit tell(2) }
state B { entry v = 2 ; wait(1) ; tell(v) }
state C {}
transition t1 { from A to B trigger a # T action tell(3) }
transition t2 { from B to C condition since(T) >= 2 action tell(4) }
)";

const char* const awaiting = R"(
event a : nat event x : nat var v : nat = 0
initial i transition t0 { from i to A } state A { entry a?v ; x!v }
)";

const char* const chain = R"(
requires I initial i transition t0 { from i to A }
state A {} state B {} transition t1 { from A to B action tell(1) } state C {} transition t2 { from B to C action tell(2) }
)";

const char* const calling = R"(
requires I initial i transition t0 { from i to A } state A { entry op(1, 2) }
)";

const char* const two_outputs = R"(
event x : nat initial i transition t0 { from i to A } state A { entry x!1 ; x!2 }
)";

const char* const two_inputs = R"(
event a event b event x initial i transition t0 { from i to A } state A {} state B {}
transition t1 { from A to B trigger a action x } transition t2 { from B to A trigger b }
)";

const char* const undefined = R"(
requires I event a : nat var v : nat = 0
initial i transition t0 { from i to A } state A {} state B { entry tell(some(v)) }
transition t1 { from A to B trigger a?v } transition t2 { from B to A }
)";

const std::vector<Registers> three = {{}, {{"a.in", ""}}, {}, {}, {}, {}};

class Faults : public ::testing::TestWithParam<Case> {
protected:
    ir::System system_ =
        testing::load_model(std::string("package p import sequence_toolkit::*\n"
                                        "function some(n : nat) : nat { precondition n > 0 }\ninterface I "
                                        "{ op(a : nat, b : nat) tell(v : nat) }\nstm M {") +
                            GetParam().body + "}");
};

std::vector<std::string> run(Controller& controller, const std::vector<Registers>& script) {
    std::vector<std::string> reported;
    for (const Registers& inputs : script) {
        for (const auto& text : controller.cycle(inputs)) reported.push_back(text);
        reported.push_back("result " + std::to_string(controller.result()));
    }
    return reported;
}

TEST_P(Faults, ChangeBehaviour) {
    Options options;
    options.fault = GetParam().fault;
    Controller good(system_, component_named(system_, "M"));
    Controller bad(system_, component_named(system_, "M"), options);
    EXPECT_GE(bad.fault_sites(), 1U);
    EXPECT_NE(run(good, GetParam().script), run(bad, GetParam().script));
}

TEST_P(Faults, HaveOneTextForEachSite) {
    const ir::ComponentRef ref = component_named(system_, "M");
    const std::string production = testing::emit_ok(system_, ref).files.front().text;
    Options options;
    options.fault = GetParam().fault;
    options.fault_site = 0xffffffffU;
    const Emission beyond = testing::emit_ok(system_, ref, options);
    const auto core = [](const Emission& emission) {
        return std::ranges::find_if(emission.files, [](const OutputFile& file) { return file.path == "M_core.hpp"; })
            ->text;
    };
    // Code with a fault in the cycle uses the general form of the event API. So the reference is code of the same form,
    // generated with another fault at a site that does not exist.
    Options other = options;
    other.fault = options.fault == Fault::wait_dropped ? Fault::wait_late : Fault::wait_dropped;
    EXPECT_EQ(core(beyond), core(testing::emit_ok(system_, ref, other)));
    std::vector<std::string> texts = {core(beyond)};
    for (options.fault_site = 0; options.fault_site < beyond.fault_sites; ++options.fault_site) {
        texts.push_back(core(testing::emit_ok(system_, ref, options)));
        EXPECT_EQ(std::ranges::count(texts, texts.back()), 1) << options.fault_site;
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, Faults,
    ::testing::Values(
        // The faulty code consumes a = 1 although the guard is false, so t2 cannot take it.
        Case{Fault::guard_after_consume, "guard_after_consume", guarded, {{}, {{"a.in", "1"}}}},
        Case{Fault::children_not_exited, "children_not_exited", nested, {{}, {{"c.in", ""}}, {{"a.in", ""}}}},
        // After the return to the composite state, the inner state must be P again, where c leads to Q without an
        // output.
        Case{Fault::composite_resumed,
             "composite_resumed",
             nested,
             {{}, {{"c.in", ""}}, {{"a.in", ""}}, {{"b.in", ""}}, {{"c.in", ""}}}},
        Case{Fault::input_not_awaited, "input_not_awaited", awaiting, {{}}},
        Case{Fault::single_transition_step, "single_transition_step", chain, {{}}},
        Case{Fault::guard_negated, "guard_negated", guarded, {{}, {{"a.in", "2"}}}},
        Case{Fault::guard_dropped, "guard_dropped", guarded, {{}, {{"a.in", "1"}}}},
        // Without the reset, since(T) is 2 when B becomes stable in cycle 3.
        Case{Fault::clock_not_reset, "clock_not_reset", actions, three},
        Case{Fault::clock_off_by_one, "clock_off_by_one", actions, three},
        Case{Fault::wrong_target, "wrong_target", actions, three},
        Case{Fault::action_dropped, "action_dropped", actions, three},
        Case{Fault::entry_dropped, "entry_dropped", actions, three},
        Case{Fault::exit_dropped, "exit_dropped", actions, three},
        Case{Fault::argument_swapped, "argument_swapped", calling, {{}}},
        Case{Fault::assignment_dropped, "assignment_dropped", actions, three},
        // the second a comes too early, so it must be lost
        Case{Fault::event_kept, "event_kept", two_inputs, {{{"a.in", ""}}, {{"a.in", ""}}, {{"b.in", ""}}}},
        Case{Fault::wait_dropped, "wait_dropped", actions, three},
        Case{Fault::output_repeated, "output_repeated", two_outputs, {{}, {}}},
        // The faulty code would leave B after the call of some(0).
        Case{Fault::function_precondition_dropped,
             "function_precondition_dropped",
             undefined,
             {{}, {{"a.in", "0"}}, {{"a.in", "1"}}}},
        Case{Fault::trigger_value_old, "trigger_value_old", guarded, {{}, {{"a.in", "2"}}}}),
    [](const auto& test) { return test.param.name; });

struct Exchanged {
    const char* condition;
    const char* own;
    const char* other;
};

// The fault exchanges the names of two functions. If one of the names had no function, the fault could never occur.
TEST(FaultsOfToolkitFunctions, TakeTheOtherOfEachPair) {
    constexpr Exchanged pairs[] = {{"union({v}, {1}) == {}", "union_", "inter"},
                                   {"inter({v}, {1}) == {}", "inter", "union_"},
                                   {"diff({v}, {1}) == {}", "diff", "union_"},
                                   {"Union({{v}}) == {}", "Union", "Inter"},
                                   {"Inter({{v}}) == {}", "Inter", "Union"},
                                   {"subset({v}, {1})", "subset", "subseteq"},
                                   {"subseteq({v}, {1})", "subseteq", "subset"},
                                   {"dres({v}, {(|1, 1|)}) == {}", "dres", "dsub"},
                                   {"dsub({v}, {(|1, 1|)}) == {}", "dsub", "dres"},
                                   {"rres({(|1, 1|)}, {v}) == {}", "rres", "rsub"},
                                   {"rsub({(|1, 1|)}, {v}) == {}", "rsub", "rres"},
                                   {"head(<v, 1>) == 1", "head", "last"},
                                   {"last(<v, 1>) == 1", "last", "head"},
                                   {"tail(<v, 1>) == <1>", "tail", "front"},
                                   {"front(<v, 1>) == <1>", "front", "tail"},
                                   {"min({v, 1}) == 1", "min", "max"},
                                   {"max({v, 1}) == 1", "max", "min"},
                                   {"prefix(<v>, <1>)", "prefix", "suffix"},
                                   {"suffix(<v>, <1>)", "suffix", "prefix"}};
    for (const Exchanged& pair : pairs) {
        const ir::System system = testing::load_model(
            "package p import set_toolkit::* import relation_toolkit::* import sequence_toolkit::*\n"
            "stm M { event a : nat var v : nat initial i transition t0 { from i to A } state A { } state B { }\n"
            "transition t1 { from A to B trigger a?v condition " +
            std::string(pair.condition) + " } }");
        Options options;
        options.fault = Fault::set_operation_wrong;
        const auto has = [&](const char* function) {
            const Emission emission = testing::emit_ok(system, component_named(system, "M"), options);
            return std::ranges::any_of(emission.files, [&](const OutputFile& file) {
                const std::string name = function;
                return file.path == "M_core.hpp" && (file.text.find("toolkit::" + name + "<") != std::string::npos ||
                                                     file.text.find("view::" + name + "<") != std::string::npos ||
                                                     file.text.find("view::" + name + "(") != std::string::npos);
            });
        };
        EXPECT_TRUE(has(pair.other)) << pair.condition;
        EXPECT_FALSE(has(pair.own)) << pair.condition;
        options.fault = Fault::none;
        EXPECT_TRUE(has(pair.own)) << pair.condition;
    }
}

}  // namespace
}  // namespace robochart::cpp_emit::fault_test
