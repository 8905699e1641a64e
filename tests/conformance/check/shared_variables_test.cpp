// SPDX-License-Identifier: Apache-2.0
// Tests variables whose writes the environment propagates (semantics 3.7). If a controller is checked alone, each of
// its machines has a copy of the variable, and writes of other machines reach the copy only through the environment.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "conformance/check/conform.hpp"
#include "tests/conformance/bench.hpp"
#include "tests/conformance/check/expect_conforming.hpp"

namespace robochart::conformance {
namespace {

constexpr const char* shared_by_three = R"(
interface V { var v : nat }
interface E { event seen }
robotic platform P { provides V uses E }
controller C {
    requires V uses E
    sref m = Writer
    sref n = Reader
    connection n on seen to C on seen
}
stm Writer {
    requires V
    initial i
    state A { entry v = 1 }
    transition t0 { from i to A }
}
stm Reader {
    requires V uses E
    initial i
    state A { }
    state B { entry seen }
    transition t0 { from i to A }
    transition t1 { from A to B condition v > 0 }
}
module M { rref p = P cref c = C connection c on seen to p on seen ( _async ) }
)";

/// Runs generated code, cycle by cycle.
class Driven {
public:
    explicit Driven(const rc_interface& code) : code_(code), state_(code.state_size), registers_(code.inputs) {
        code.initial(state_.data());
    }

    /// Runs one cycle with the given value of an input ("" if there is no input). Returns the names of its outputs.
    std::vector<std::string> cycle(const std::string& input = "", const std::string& value = "") {
        for (std::uint32_t index = 0; index < code_.inputs; ++index) {
            const rc_input& declared = code_.input[index];
            registers_[index] = {declared.name == input ? 1U : 0U, 0};
            for (std::uint32_t place = 0; place < declared.values; ++place)
                if (declared.text[place] == value) registers_[index].value = place;
        }
        std::vector<rc_record> records(20);
        rc_log log{};
        log.capacity = static_cast<std::uint32_t>(records.size());
        log.record = records.data();
        (void)code_.step(state_.data(), registers_.data(), &log);
        std::vector<std::string> names;
        for (std::uint32_t index = 0; index < log.count; ++index)
            names.emplace_back(code_.output[records[index].output].name);
        return names;
    }

private:
    const rc_interface& code_;
    std::vector<unsigned char> state_;
    std::vector<rc_register> registers_;
};

class SharedVariables : public ::testing::Test {
protected:
    test::ModelFolder folder_{shared_by_three};
};

using ::testing::Contains;
using ::testing::EndsWith;
using ::testing::Not;

TEST_F(SharedVariables, EachMachineHasItsCopyWhereTheEnvironmentPropagates) {
    test::Model model(folder_.path());
    const ir::ComponentRef controller = model.first_controller();
    (void)test::expect_conforming(model, controller);
    test::Bench bench(model, controller);
    const auto object = bench.compile_fault(cpp_emit::Fault::none, 0);
    ASSERT_TRUE(object);
    Driven code(object->interface());
    // A write inside the component does not reach the reader, but a write from the environment does.
    const std::vector<std::string> first = code.cycle();
    EXPECT_THAT(first, Contains(EndsWith("set_v")));
    EXPECT_THAT(first, Not(Contains(EndsWith("seen.out"))));
    EXPECT_THAT(code.cycle(), Not(Contains(EndsWith("seen.out"))));
    EXPECT_THAT(code.cycle("set_EXT_v", "1"), Contains(EndsWith("seen.out")));
}

TEST_F(SharedVariables, ThereIsOneWhereTheModuleDoes) {
    test::Model model(folder_.path());
    (void)test::expect_conforming(model, model.first_module());
    test::Bench bench(model, model.first_module());
    const auto object = bench.compile_fault(cpp_emit::Fault::none, 0);
    ASSERT_TRUE(object);
    EXPECT_THAT(Driven(object->interface()).cycle(), Contains(EndsWith("seen.out")));
}

/// Returns a module with the machines of a controller. Its platform provides `v` and the operations.
std::string with_platform(const std::string& controller) {
    return "interface D { var v : nat }\ninterface O { move() stop() }\ninterface P { op() }\n"
           "module M {\n"
           "  robotic platform R { provides D provides O event e : nat }\n"
           "  controller C { requires D requires O event e : nat\n" +
           controller + "}\n  connection R on e to C on e ( _async )\n}\n";
}

struct HeldUp {
    const char* what;
    const char* controller;
};

/// Writes are not propagated to a machine while one of its threads waits to call the platform (semantics 3.7). Each
/// memory in between stores one write, so the third of three consecutive writes has to wait for the call. Code that
/// makes all three writes first differs.
const HeldUp held_up[] = {
    {"a during action begins with the call", R"(stm A { requires D requires O initial i
        state S { initial j state T { during move() } transition tj { from j to T }
                  during v = 1; v = 2; v = 1 }
        transition ti { from i to S } })"},
    {"both begin with calls", R"(stm A { requires D requires O initial i
        state S { initial j state T { during move(); v = 1; v = 2; v = 1 } transition tj { from j to T }
                  during stop(); v = 1; v = 2; v = 1 }
        transition ti { from i to S } })"},
    {"the third write is that of a reception", R"(stm A { requires D requires O event e : nat initial i
        state S { initial j state T { during move(); stop() } transition tj { from j to T }
                  during v = 1; v = 2; e?D::v }
        transition ti { from i to S } }
        connection C on e to A on e)"},
    {"both wait until the same moment", R"(stm A { requires D requires O initial i
        state S { initial j state T { during wait(1); move() } transition tj { from j to T }
                  during wait(1); v = 1; v = 2; v = 1 }
        transition ti { from i to S } })"},
    {"a wait with a deadline in another machine", R"(stm A { requires D initial i
        state S { entry wait(1); v = 1; v = 2; v = 1 } transition ti { from i to S } }
        stm B { requires D requires O initial i
        state S { during wait(1) <{1}; move(); stop(); v = 0; v = 1; v = 2 } transition ti { from i to S } })"},
    {"a wait at the end of an operation", R"(opref o = op
        stm A { requires D initial i
        state S { entry wait(1); v = 1; v = 2; v = 1 } transition ti { from i to S } }
        stm B { requires D requires O requires P initial i
        state S { during op(); v = 0; v = 1; v = 2 } transition ti { from i to S } })"},
    {"a machine that has sent goes on with the call", R"(stm A { requires D requires O event s : nat initial i
        state S { during s!1; move() } transition ti { from i to S } }
        stm B { requires D event s : nat var y : nat initial i
        state S { during s?y; v = 1; v = 2; v = 1 } transition ti { from i to S } }
        connection A on s to B on s)"},
    {"an input with a deadline beside the writes", R"(stm A { requires D event e : nat var w : nat initial i
        state S { initial j state T { during e?w <{2} } transition tj { from j to T }
                  during v = 1; v = 2; v = 1 }
        transition ti { from i to S } }
        connection C on e to A on e)"},
    {"an input with a deadline, and a write a cycle", R"(stm A { requires D event e : nat var w : nat initial i
        state S { } transition ti { from i to S action e?w <{3} } }
        stm B { requires D initial i state S { }
        transition ti { from i to S } transition tt { from S to S action v = v + 1; wait(1) } }
        connection C on e to A on e)"},
    {"a machine that sends with a deadline", R"(stm A { requires D event s : nat initial i
        state S { during s!1 <{2}; wait(1); v = 0 } transition ti { from i to S } }
        stm B { requires D event s : nat event e : nat var y : nat var z : nat initial i
        state S { initial j state T { during e?z; s?y } transition tj { from j to T }
                  during v = 1; v = 2; v = 1 }
        transition ti { from i to S } }
        connection A on s to B on s connection C on e to B on e)"},
    {"an operation that waits with a deadline", R"(opref o = op
        stm A { requires D event e : nat var w : nat requires P initial i
        state S { during op() } transition ti { from i to S } }
        stm B { requires D initial i state S { }
        transition ti { from i to S action v = 1; v = 2; wait(1); v = 1; v = 2; wait(1); v = 1 } }
        connection C on e to A on e)"},
};

TEST(WritesHeldUp, WritesWaitForThem) {
    for (const HeldUp& row : held_up) {
        const std::string_view controller = row.controller;
        const std::string operation = controller.find("requires O") != std::string_view::npos
                                          ? "operation op() { requires O initial i final f transition t { from i to f "
                                            "action wait(1); move() } }\n"
                                          : "operation op() { event e : nat var w : nat initial i final f\n"
                                            "transition t { from i to f action e?w <{3} } }\n";
        const test::ModelFolder folder(with_platform(row.controller) + operation);
        test::Model model(folder.path());
        ASSERT_FALSE(model.system.modules.empty()) << row.what;
        SCOPED_TRACE(row.what);
        EXPECT_GT(test::expect_conforming(model, model.first_module()).code_cycles, 1U);
    }
}

}  // namespace
}  // namespace robochart::conformance
