// SPDX-License-Identifier: Apache-2.0
// Tests the embedded profile. Compiles generated code for a Cortex-M4 (Debian: gcc-arm-none-eabi,
// libstdc++-arm-none-eabi-dev and libnewlib-dev) without exceptions and RTTI. The objects must not need features that a
// microcontroller may lack: a heap, streams, exceptions, constructors before main, static data.
#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <sstream>

#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"
#include "tests/needed.hpp"

namespace robochart::cpp_emit::embedded_test {
namespace {

using testing::Folder;

const std::string compiler =
    "arm-none-eabi-g++ -std=c++17 -fno-exceptions -fno-rtti -mcpu=cortex-m4 -mthumb -Os -Wall -Wextra -Wpedantic "
    "-Wconversion -Werror -I. -c ";

struct Sizes {
    unsigned text = 0, data = 0, bss = 0;
};

class Embedded : public ::testing::Test {
protected:
    /// Returns whether the packages are installed. Without them the test is skipped, except in continuous integration,
    /// where it fails.
    bool available() {
        std::string ignored;
        return folder_.status("echo '#include <cstdint>' | arm-none-eabi-g++ -x c++ -fsyntax-only -", ignored) == 0;
    }

    void emit(const char* model, const char* name, const Options& options = {}) {
        const ir::System system = testing::load_corpus(model);
        folder_.write(testing::emit_ok(system, testing::component_named(system, name), options));
    }

    /// Writes the file that a robot's author would write: a control cycle over the lean core.
    void write(const std::string& text) const { std::ofstream(folder_.path() + "/robot.cpp") << text; }

    Sizes compile(const std::string& source, const std::string& flags = "") const {
        folder_.run(compiler + flags + " " + source + " -o object.o");
        expect_bare();
        std::istringstream table(folder_.run("arm-none-eabi-size object.o | tail -1"));
        Sizes sizes;
        table >> sizes.text >> sizes.data >> sizes.bss;
        std::cout << source << " " << flags << ": " << sizes.text << " bytes of text, " << sizes.data << " of data, "
                  << sizes.bss << " of bss\n";
        EXPECT_GT(sizes.text, 0U);
        EXPECT_EQ(sizes.data, 0U);
        EXPECT_EQ(sizes.bss, 0U);
        return sizes;
    }

    /// Checks the undefined symbols of the object. Only the robot's own functions, arithmetic of the run-time library,
    /// memset and memcpy are allowed.
    void expect_bare() const {
        std::istringstream names(folder_.run("arm-none-eabi-nm -u object.o"));
        for (std::string mark, name; names >> mark >> name;) {
            const bool known = name.rfind("robot_", 0) == 0 || name.rfind("__aeabi_", 0) == 0 || name == "memset" ||
                               name == "memcpy" || name == "memcmp" || name == "memmove";
            EXPECT_TRUE(known) << name;
        }
        EXPECT_EQ(folder_.run("arm-none-eabi-nm object.o | grep -E ' (_GLOBAL__|__cxa_|_Znw|_Zdl)' || true"), "");
    }

    Folder folder_;
};

#define ROBOCHART_NEEDS_ARM      \
    ROBOCHART_NEEDS(available(), \
                    "arm-none-eabi-g++ (Debian: gcc-arm-none-eabi libstdc++-arm-none-eabi-dev libnewlib-dev)")

const char* const aggregation_robot = R"(#include "Aggregation_core.hpp"
namespace core = aggregation::Aggregation_core;
extern "C" void robot_speeds(double linear, double angular);
#ifdef SINGLE
struct Types {
    using Real = float;
    using Nat = std::int32_t;
    using Int = std::int32_t;
    static constexpr std::size_t longest = 4;
};
#else
using Types = robochart::Deployment;
#endif
using Real = Types::Real;
struct Board {
    Real linear{}, angular{};
    bool replaces_MoveClockwise(Real, Real) noexcept { return false; }
    bool replaces_RotateClockwise(Real) noexcept { return false; }
    void set_linearSpeed(Real value) noexcept { linear = value; }
    void set_angularSpeed(Real value) noexcept { angular = value; }
};
extern "C" unsigned control_cycle(core::State<Types>* state, const core::Inputs<Types>* inputs) {
    Board board;
    const auto result = core::step(*state, *inputs, board);
    robot_speeds(static_cast<double>(board.linear), static_cast<double>(board.angular));
    return static_cast<unsigned>(result);
}
static_assert(sizeof(core::State<Types>) <= 48, "the whole state");
)";

TEST_F(Embedded, TheLeanCoreOfAggregation) {
    ROBOCHART_NEEDS_ARM;
    emit("aggregation", "Aggregation");
    write(aggregation_robot);
    const Sizes sizes = compile("robot.cpp");
    EXPECT_LT(sizes.text, 2048U);
}

/// Types are a template policy, so the same text works with reals of four bytes, for the single-precision FPU.
TEST_F(Embedded, WithRealsOfFourBytes) {
    ROBOCHART_NEEDS_ARM;
    emit("aggregation", "Aggregation");
    write(aggregation_robot);
    const Sizes sizes = compile("robot.cpp", "-DSINGLE -mfloat-abi=hard -mfpu=fpv4-sp-d16");
    EXPECT_LT(sizes.text, 2048U);
}

TEST_F(Embedded, TheLeanCoreOfSwarmTaxis) {
    ROBOCHART_NEEDS_ARM;
    emit("swarm_taxis", "SwarmTaxis");
    write(R"(#include "SwarmTaxis_core.hpp"
namespace core = swarm_taxis::SwarmTaxis_core;
using Types = robochart::Deployment;
extern "C" void robot_wheels(double left, double right);
extern "C" void robot_ask(int what);
extern "C" void robot_turn(double degree);
struct Board {
    double radius = 0.1;
    void MoveForward() noexcept { robot_wheels(6.4, 6.4); }
    void CheckIlluminationStatus() noexcept { robot_ask(0); }
    void CalcCoherenceHeading() noexcept { robot_ask(1); }
    void CalcAvoidanceHeading() noexcept { robot_ask(2); }
    void StartTurning(double degree) noexcept { robot_turn(degree); }
    bool replaces_Turn(double) noexcept { return false; }
    bool replaces_UpdateAvoidanceRadius() noexcept { return false; }
    void set_avoidanceRadius(double value) noexcept { radius = value; }
    void set_illuminated(bool) noexcept {}
    void set_reached(bool) noexcept {}
    void set_desiredTurningDegree(double) noexcept {}
};
extern "C" unsigned control_cycle(core::State<Types>* state, const core::Inputs<Types>* inputs, Board* board) {
    return static_cast<unsigned>(core::step(*state, *inputs, *board));
}
)");
    const Sizes sizes = compile("robot.cpp");
    EXPECT_LT(sizes.text, 4096U);
}

/// Compiles the classes of the paper's mapping, with MakeTransition and related methods.
TEST_F(Embedded, TheClasses) {
    ROBOCHART_NEEDS_ARM;
    emit("swarm_taxis", "SwarmTaxis");
    compile("SwarmTaxisFSM.cpp");
}

}  // namespace
}  // namespace robochart::cpp_emit::embedded_test
