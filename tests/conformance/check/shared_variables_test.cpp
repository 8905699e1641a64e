// Variables whose writes the environment propagates (semantics 3.7): of the machines of a controller alone, each has
// its copy, which the others' writes reach only through the outside.
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

class SharedVariables : public ::testing::Test {
protected:
    static std::string core(test::Model& model, const ir::ComponentRef& ref) {
        const cpp_emit::Emission code = cpp_emit::emit(model.system, model.instantiation, ref, {}, model.diagnostics);
        for (const auto& file : code.files)
            if (file.path.ends_with("_core.hpp")) return file.text;
        return {};
    }

    test::TemporaryFolder folder_{shared_by_three};
};

TEST_F(SharedVariables, EachMachineHasItsCopyWhereTheEnvironmentPropagates) {
    test::Model model(folder_.path());
    const ir::ComponentRef controller = model.controller();
    (void)test::expect_conforming(model, controller);
    // What is written inside does not reach the reader, what comes from outside does.
    const std::string code = core(model, controller);
    EXPECT_EQ(code.find("write_v(Nat value) noexcept {\n        state_."), std::string::npos);
    EXPECT_NE(code.find("= inputs_.external_v.value;"), std::string::npos);
}

TEST_F(SharedVariables, ThereIsOneWhereTheModuleDoes) {
    test::Model model(folder_.path());
    (void)test::expect_conforming(model, model.module());
    EXPECT_NE(core(model, model.module()).find("write_v(Nat value) noexcept {\n        state_."), std::string::npos);
}

}  // namespace
}  // namespace robochart::conformance
