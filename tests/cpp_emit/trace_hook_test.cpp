// SPDX-License-Identifier: Apache-2.0
// Tests that the trace hook produces no code for a platform that does not use it. For a platform that uses it, the hook
// reports each transition that is taken.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"

namespace robochart::cpp_emit::trace_hook_test {
namespace {

using testing::Folder;

/// Runs the core of aggregation with a platform with or without a method `taken`.
class TraceHook : public ::testing::Test {
protected:
    TraceHook() {
        const ir::System system = testing::load_corpus("aggregation");
        folder_.write(testing::emit_ok(system, testing::component_named(system, "Aggregation")));
        std::ofstream(folder_.path() + "/user.cpp") << R"(#include "Aggregation_core.hpp"
namespace core = aggregation::Aggregation_core;
struct Wheels {
    double linear = 0, angular = 0;
    unsigned reported = 0;
    bool replaces_MoveClockwise(double, double) noexcept { return false; }
    bool replaces_RotateClockwise(double) noexcept { return false; }
    void set_linearSpeed(double value) noexcept { linear = value; }
    void set_angularSpeed(double value) noexcept { angular = value; }
#ifdef LISTENS
    void taken(std::uint32_t transition) noexcept { reported += transition; }
#endif
};
robochart::StepResult cycle(core::State<robochart::Deployment>& state,
                            const core::Inputs<robochart::Deployment>& inputs, Wheels& wheels) {
    return core::step(state, inputs, wheels);
}
)";
    }

    /// Returns the assembly code of the machine.
    std::string compile_to_assembly(const std::string& options) const {
        folder_.run("c++ -std=c++17 -O2 -S " + options + " -I . user.cpp -o user.s");
        std::ostringstream text;
        text << std::ifstream(folder_.path() + "/user.s").rdbuf();
        return text.str();
    }

    Folder folder_;
};

TEST_F(TraceHook, GeneratesNoCodeIfThePlatformHasNoHook) {
    const std::string as_emitted = compile_to_assembly("");
    const std::string heard = compile_to_assembly("-DLISTENS");
    folder_.run("grep -q 'taken([0-9]*);' Aggregation_core.hpp");
    folder_.run("sed -i '/^ *taken([0-9]*);$/d' Aggregation_core.hpp");
    const std::string without = compile_to_assembly("");
    EXPECT_EQ(as_emitted, without);
    EXPECT_NE(heard, without);
}

/// The machine takes i -> S1 in the first cycle, and S1 -> S2 when a robot is in sight. The reported numbers are
/// indexes into the table.
TEST_F(TraceHook, ALeanPlatformIsNotifiedOfTransitions) {
    std::ofstream(folder_.path() + "/main.cpp") << R"(#include <cstring>
#include <vector>
#include "Aggregation_trace.hpp"
namespace core = aggregation::Aggregation_core;
struct Wheels {
    std::vector<const char*> reported;
    bool replaces_MoveClockwise(double, double) noexcept { return true; }
    bool replaces_RotateClockwise(double) noexcept { return true; }
    void set_linearSpeed(double) noexcept {}
    void set_angularSpeed(double) noexcept {}
    void taken(std::uint32_t transition) noexcept { reported.push_back(core::transitions[transition].element); }
};
int main() {
    core::State<robochart::Deployment> state{};
    Wheels wheels;
    core::Inputs<robochart::Deployment> inputs;
    core::step(state, inputs, wheels);
    if (wheels.reported.size() != 1 || std::strstr(wheels.reported[0], "AggregationFSM::") == nullptr) return 1;
    inputs.seeRobot.present = true;
    core::step(state, inputs, wheels);
    core::step(state, core::Inputs<robochart::Deployment>{}, wheels);
    return wheels.reported.size() == 2 && std::strcmp(wheels.reported[0], wheels.reported[1]) != 0 ? 0 : 2;
}
)";
    folder_.run("c++ -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Werror -I . main.cpp -o main && ./main");
}

}  // namespace
}  // namespace robochart::cpp_emit::trace_hook_test
