// SPDX-License-Identifier: Apache-2.0
// Tests code that asks its platform at the choices of the model (`emit cpp --choices`). If a platform has no `pick`,
// the code takes the first alternative. A platform that replays recorded answers determines the alternatives. Without
// the option, the code asks nothing.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"

namespace robochart::cpp_emit::choices_test {
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
    const ir::System system = testing::load_model(text);
    Options options;
    options.choices = true;
    Folder folder;
    folder.write(testing::emit_ok(system, testing::component_named(system, "M"), options));
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

/// Without the option the code takes the first alternative and does not ask the platform.
TEST(Choices, WithoutTheOptionNobodyIsAsked) {
    const ir::System system = testing::load_model(text);
    const Emission emission = testing::emit_ok(system, testing::component_named(system, "M"));
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

/// In the class API, `pick` is a virtual method.
TEST(Choices, TheClassApiPicks) {
    const ir::System system = testing::load_model(text);
    Options options;
    options.choices = true;
    Folder folder;
    folder.write(testing::emit_ok(system, testing::component_named(system, "M"), options));
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

/// The console program of a model, in a folder with the files that the program writes.
class ChoicesConsole : public ::testing::Test {
protected:
    void build_console(const char* model_text, bool choices = true) {
        const ir::System system = testing::load_model(model_text);
        Options options;
        options.choices = choices;
        folder_.write(testing::emit_ok(system, testing::component_named(system, "M"), options));
        folder_.run("c++ -std=c++17 -O0 -Wall -Wextra -Wpedantic -Wconversion -Werror -I . main.cpp M.cpp -o console");
    }
    /// Runs the program with these lines of input. Returns its output and error output.
    std::string run_console(const std::string& lines, const std::string& options = "", bool good = true) {
        std::ofstream(folder_.path() + "/lines") << lines;
        std::string output;
        const int status = folder_.status("./console " + options + " < lines", output);
        EXPECT_EQ(status, good ? 0 : 1 << 8U) << lines << output;
        return output;
    }
    [[nodiscard]] std::string file(const std::string& name) const {
        std::ostringstream contents;
        contents << std::ifstream(folder_.path() + "/" + name).rdbuf();
        return contents.str();
    }
    void file(const std::string& name, const std::string& contents) const {
        std::ofstream(folder_.path() + "/" + name) << contents;
    }

    Folder folder_;
};

constexpr const char* recorded = "robochart-record 1\ncontroller M\n\ngo pick=2/3\ngo\ngo pick=1/3\ngo\ngo pick=0/3\n";

TEST_F(ChoicesConsole, TheWordsOfACycleAnswer) {
    build_console(text);
    const std::string output = run_console("\ngo pick=2\ngo\npick=1 go\ngo\ngo\n", "--record run.record");
    EXPECT_EQ(output,
              "cycle 1\n  state A\n"
              "cycle 2\n  picks 2 of 0..2\n  right()\n  state D\n"
              "cycle 3\n  state A\n"
              "cycle 4\n  picks 1 of 0..2\n  middle()\n  state C\n"
              "cycle 5\n  state A\n"
              "cycle 6\n  picks 0 of 0..2\n  left()\n  state B\n");  // no answer is given: the first alternative
    EXPECT_EQ(file("run.record"), recorded);
    EXPECT_EQ(run_console("", "--replay run.record --record again.record"), output);
    EXPECT_EQ(file("again.record"), recorded);
}

TEST_F(ChoicesConsole, APersonIsAsked) {
    build_console(text);
    const std::string output =
        run_console("\ngo\nthree\n3\n2\ngo\ngo pick=1\ngo\ngo\n\ngo\ngo\n", "--ask --record run.record");
    EXPECT_NE(output.find("  which of 0..2? "), std::string::npos);
    EXPECT_NE(output.find("not a choice: three of 0..2\n"), std::string::npos) << output;
    EXPECT_NE(output.find("not a choice: 3 of 0..2\n"), std::string::npos) << output;
    EXPECT_EQ(file("run.record"), std::string(recorded) + "go\ngo pick=0/3\n");  // end of input: first choice
}

TEST_F(ChoicesConsole, WrongAnswersAreReported) {
    build_console(text);
    EXPECT_NE(run_console("\ngo pick=3\n").find("not a choice: 3 of 0..2\n"), std::string::npos);
    EXPECT_NE(run_console("\ngo pick=many\n").find("not a choice: pick=many\n"), std::string::npos);
    EXPECT_NE(run_console("\ngo pick=1 pick=2\n").find("nothing to choose: pick=2\n"), std::string::npos);
    EXPECT_NE(run_console("\ngo=1\n").find("not an input: go=1\n"), std::string::npos);
    EXPECT_NE(run_console("\n", "--ask 100", false).find("usage: "), std::string::npos);
    EXPECT_NE(run_console("\n", "--replay run.record 100", false).find("usage: "), std::string::npos);
    EXPECT_NE(run_console("\n", "--replay run.record --record run.record", false).find("usage: "), std::string::npos);
    EXPECT_NE(run_console("\n", "--record /no/such/folder", false).find("cannot write /no/such/folder"),
              std::string::npos);
}

/// Some records are invalid for this controller, others are of cycles that did not happen. The message names the line.
TEST_F(ChoicesConsole, RecordsThatDoNotFitAreReported) {
    build_console(text);
    EXPECT_EQ(run_console("", "--replay missing", false), "missing: cannot be read\n");
    const std::string head = "robochart-record 1\ncontroller M\n";
    for (const auto& [contents, reported] : std::vector<std::pair<std::string, std::string>>{
             {"", "run.record:1: expected `robochart-record 1`, found ``\n"},
             {"robochart-record 2\n", "run.record:1: expected `robochart-record 1`, found `robochart-record 2`\n"},
             {"robochart-record 1\n", "run.record:2: expected `controller M`, found ``\n"},
             {"robochart-record 1\ncontroller N\n", "run.record:2: expected `controller M`, found `controller N`\n"},
             {head + "\ngo\n", "run.record:4: no answer where there is a choice of 3\n"},
             {head + "\n// a comment\ngo pick=3/3\n", "run.record:5: not a choice: 3 of 0..2\n"},
             {head + "\ngo pick=1/2\n", "run.record:4: a choice of 2, here it is one of 3\n"},
             {head + "\ngo pick=1/3 pick=0/3\n", "run.record:4: nothing to choose: pick=0\n"},
             {head + "\ngo pick=1/\n", "run.record:4: not a choice: pick=1/\n"},
             {head + "\ngone\n", "run.record:4: not an input: gone\n"}}) {
        file("run.record", contents);
        const std::string output = run_console("", "--replay run.record", false);
        EXPECT_TRUE(output.size() >= reported.size() && output.substr(output.size() - reported.size()) == reported)
            << output << "expected " << reported;
    }
    file("run.record", head + "\ngo pick=1/3\n");
    run_console("", "--replay run.record");
}

constexpr const char* chances = R"(package p
interface O { left() right() }
stm M { requires O event pick : nat var n : nat initial i probabilistic p
    state A { } state B { entry left() } state C { entry right() } final F
    transition t0 { from i to A }
    transition t1 { from A to p trigger pick?n }
    transition t2 { from p to B probability 1/2 } transition t3 { from p to C probability 1/2 }
    transition t4 { from B to F } transition t5 { from C to F } }
)";

/// Answers of the same form determine randomly drawn alternatives, even without --choices. An input called `pick` keeps
/// its name. The controller may terminate before its record ends.
TEST_F(ChoicesConsole, WaysOfProbabilisticJunctions) {
    build_console(chances, false);
    const std::string output = run_console("\npick=7 pick_=1\n", "--record run.record");
    EXPECT_NE(output.find("  picks 1 of 0..1\n  right()\n"), std::string::npos) << output;
    EXPECT_EQ(file("run.record"), "robochart-record 1\ncontroller M\n\npick=7 pick_=1/2\n");
    file("run.record", file("run.record") + "\n\n\n\n");
    const std::string refused = run_console("\npick=7 pick=x pick=7x pick_=1\n");
    for (const char* const wrong : {"not an input: pick=x\n", "not an input: pick=7x\n"})
        EXPECT_NE(refused.find(wrong), std::string::npos) << refused;
    EXPECT_NE(run_console("", "--replay run.record", false).find("the controller has ended, the record goes on\n"),
              std::string::npos);
}

/// A program without choices has no options for answers.
TEST_F(ChoicesConsole, WithoutChoicesThereIsNothingToAnswer) {
    build_console(text, false);
    EXPECT_NE(run_console("\ngo pick=2\n").find("not an input: pick=2\n"), std::string::npos);
    EXPECT_EQ(file("main.cpp").find("console_choices"), std::string::npos);
    EXPECT_NE(run_console("", "--replay run.record", false).find("usage: "), std::string::npos);
}

}  // namespace
}  // namespace robochart::cpp_emit::choices_test
