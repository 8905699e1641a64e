// Code that asks where the model leaves a choice (`emit cpp --choices`): a platform without `pick` gets the first, one
// that repeats recorded answers gets those; without the option there is nothing to ask at.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"

namespace robochart::cpp_emit {
namespace {

using testing::Folder;

const char* const text = R"(package p
interface O { left() middle() right() }
stm M { requires O event go initial i
    state A { } state B { entry left() } state C { entry middle() } state D { entry right() }
    transition t0 { from i to A }
    transition t1 { from A to B trigger go } transition t2 { from A to C trigger go } transition t3 { from A to D trigger go }
    transition b { from B to A trigger go } transition c { from C to A trigger go } transition d { from D to A trigger go } }
)";

const char* const program = R"(#include <string>
#include "M_core.hpp"
namespace core = p::M_core;
using Types = robochart::Deployment;
struct Plain {
    std::string done;
    void left() noexcept { done += 'l'; }
    void middle() noexcept { done += 'm'; }
    void right() noexcept { done += 'r'; }
};
struct Repeating : Plain {
    robochart::RecordedChoices choices;
    std::size_t asked = 0;
    explicit Repeating(robochart::RecordedChoices recorded) : choices(recorded) {}
    std::size_t pick(std::size_t count) noexcept {
        asked += count;
        return choices.next();
    }
};
template <class Platform>
std::string run(Platform& platform) {
    core::State<Types> state = core::init<Types>();
    core::step(state, core::Inputs<Types>{}, platform);
    for (int cycle = 0; cycle < 8; ++cycle) {
        core::Inputs<Types> inputs;
        inputs.go.present = true;
        core::step(state, inputs, platform);
    }
    return platform.done;
}
)";

TEST(Choices, RecordedAnswersAreRepeated) {
    const ir::System system = testing::model(text);
    Options options;
    options.choices = true;
    Folder folder;
    folder.write(testing::emit_ok(system, testing::component(system, "M"), options));
    std::ofstream(folder.path() + "/main.cpp") << program << R"(
int main() {
    Plain plain;
    if (run(plain) != "llll") return 1;
    const std::size_t answers[] = {2, 0, 1};
    Repeating repeating{robochart::RecordedChoices(answers, 3)};
    if (run(repeating) != "rlml") return 2;  // beyond the record: the first
    return repeating.asked == 12 ? 0 : 3;    // four times, of three each
}
)";
    folder.run(
        "c++ -std=c++17 -O0 -Wall -Wextra -Wpedantic -Wconversion -Werror -I . main.cpp M.cpp -o main && ./main");
}

/// Without the option the first is all there is, whatever the platform could say.
TEST(Choices, WithoutTheOptionNobodyIsAsked) {
    const ir::System system = testing::model(text);
    const Emission emission = testing::emit_ok(system, testing::component(system, "M"));
    for (const OutputFile& file : emission.files) {
        if (file.path == "M_core.hpp") {
            EXPECT_EQ(file.text.find("in_turn"), std::string::npos);
        }
    }
    Folder folder;
    folder.write(emission);
    std::ofstream(folder.path() + "/main.cpp") << program << R"(
int main() {
    const std::size_t answers[] = {2, 0, 1};
    Repeating repeating{robochart::RecordedChoices(answers, 3)};
    return run(repeating) == "llll" && repeating.asked == 0 ? 0 : 1;
}
)";
    folder.run("c++ -std=c++17 -O0 -Wall -Wextra -Wpedantic -Wconversion -Werror -I . main.cpp -o main && ./main");
}

/// The classes: `pick` is a method to override.
TEST(Choices, ThePapersFacePicks) {
    const ir::System system = testing::model(text);
    Options options;
    options.choices = true;
    Folder folder;
    folder.write(testing::emit_ok(system, testing::component(system, "M"), options));
    std::ofstream(folder.path() + "/main.cpp") << R"(#include <string>
#include "M.hpp"
struct Robot : p::M {
    std::string done;
    void left() override { done += 'l'; }
    void middle() override { done += 'm'; }
    void right() override { done += 'r'; }
    std::size_t pick(std::size_t count) noexcept override { return count - 1; }
};
int main() {
    Robot robot;
    for (int cycle = 0; cycle < 3; ++cycle) {
        robot.go = cycle > 0;
        robot.step();
    }
    return robot.done == "r" ? 0 : 1;
}
)";
    for (const char* trace : {"0", "1"})
        folder.run(std::string("c++ -std=c++17 -O0 -Wall -Wextra -Wpedantic -Wconversion -Werror -DROBOCHART_TRACE=") +
                   trace + " -I . main.cpp M.cpp -o main && ./main");
}

}  // namespace
}  // namespace robochart::cpp_emit
