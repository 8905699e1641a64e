// Variables whose writes the environment propagates (semantics 3.7): of the machines of a controller alone, each has
// its copy, which the others' writes reach only through the outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "conformance/check/conform.hpp"
#include "tests/conformance/bench.hpp"

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

/// Drives generated code.
class Driven {
public:
    explicit Driven(const rc_interface& code) : code_(code), state_(code.state_size), registers_(code.inputs) {
        code.initial(state_.data());
    }

    /// One cycle with the given value of an input, "" for none; the names of what it wrote.
    std::vector<std::string> cycle(const std::string& input = "", const std::string& value = "") {
        for (std::uint32_t index = 0; index < code_.inputs; ++index) {
            const rc_input& each = code_.input[index];
            registers_[index] = {each.name == input ? 1U : 0U, 0};
            for (std::uint32_t place = 0; place < each.values; ++place)
                if (each.text[place] == value) registers_[index].value = place;
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
    test::TemporaryFolder folder_{shared_by_three};
};

using ::testing::Contains;
using ::testing::EndsWith;
using ::testing::Not;

TEST_F(SharedVariables, EachMachineHasItsCopyWhereTheEnvironmentPropagates) {
    test::Model model(folder_.path());
    diagnostics::Diagnostics found;
    const ir::ComponentRef controller = model.controller();
    const Result result = conform(model.system, model.instantiation, controller, {}, model.sources, found);
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    test::Bench bench(model, controller);
    const auto object = bench.compiled(cpp_emit::Fault::none, 0);
    ASSERT_TRUE(object);
    Driven code(object->interface());
    // What is written inside does not reach the reader, what comes from outside does.
    const std::vector<std::string> first = code.cycle();
    EXPECT_THAT(first, Contains(EndsWith("set_v")));
    EXPECT_THAT(first, Not(Contains(EndsWith("seen.out"))));
    EXPECT_THAT(code.cycle(), Not(Contains(EndsWith("seen.out"))));
    EXPECT_THAT(code.cycle("set_EXT_v", "1"), Contains(EndsWith("seen.out")));
}

TEST_F(SharedVariables, ThereIsOneWhereTheModuleDoes) {
    test::Model model(folder_.path());
    diagnostics::Diagnostics found;
    const Result result = conform(model.system, model.instantiation, model.module(), {}, model.sources, found);
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    test::Bench bench(model, model.module());
    const auto object = bench.compiled(cpp_emit::Fault::none, 0);
    ASSERT_TRUE(object);
    EXPECT_THAT(Driven(object->interface()).cycle(), Contains(EndsWith("seen.out")));
}

}  // namespace
}  // namespace robochart::conformance
