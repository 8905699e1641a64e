// SPDX-License-Identifier: Apache-2.0
// Tests `conform --export`, which writes the complete state space of the code for other tools, and a script that
// contains the model. For this script, the project's checker of scripts must give the same answer as `conform`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>

#include <fstream>

#include "command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::code_export_test {
namespace {

using tests::read_contents;

using ::testing::HasSubstr;
using testing::repository;
using testing::run;
using ::testing::StartsWith;

/// The model leaves a choice, so its code has more states if it is generated with all choices. Both refinement
/// relations are tested.
TEST(Conform, RelationsAndChoices) {
    const testing::TemporaryFile model(
        "m.rct",
        "stm M {\n event go event left event right initial i\n state A { } state B { entry left } "
        "state C { entry right }\n transition t0 { from i to A }\n"
        " transition t1 { from A to B trigger go } transition t2 { from A to C trigger go } }\n");
    const auto first = run({"conform", model.path(), "--component", "M", "--model", "tick-tock"});
    EXPECT_EQ(first.exit, 0) << first.out << first.err;
    EXPECT_THAT(first.out, HasSubstr("conforms     M: 3 states"));
    const auto all = run({"conform", model.path(), "--component", "M", "--all-choices", "--model", "tick-tock"});
    EXPECT_EQ(all.exit, 0) << all.out << all.err;
    EXPECT_THAT(all.out, HasSubstr("conforms     M: 4 states"));
    EXPECT_EQ(run({"conform", model.path(), "--model", "traces"}).exit, 4);
}

TEST(CodeExport, TheScriptRepeatsTheCheck) {
    for (const char* study : {"corpus/aggregation", "tests/conformance/models/nested"}) {
        const testing::Folder folder;
        const std::string path = folder / "code.csp";
        const auto ran = run({"conform", repository(study), "--export", path});
        ASSERT_EQ(ran.exit, 0) << ran.out << ran.err;
        EXPECT_THAT(read_contents(path), HasSubstr("assert NF__ [FD= Code__"));
        const auto decided = run({"cspm", path});
        EXPECT_EQ(decided.exit, 0) << decided.out << decided.err;
        // The same code without one write does not refine the model, and the script detects this.
        std::string broken = read_contents(path);
        const std::size_t code = broken.find("Code__0 =");
        const std::size_t write = broken.find("registerWrite.", code);
        ASSERT_NE(write, std::string::npos);
        const std::size_t arrow = broken.find("->", write);
        broken.replace(write, arrow - write, "tock ");
        std::ofstream(path, std::ios::binary) << broken;
        EXPECT_EQ(run({"cspm", path}).exit, 1);
    }
}

/// Aldebaran's format has a line `des (0, transitions, states)`, and then one line for each transition.
TEST(CodeExport, AldebaranHasEveryTransition) {
    const testing::Folder folder;
    const std::string path = folder / "code.aut";
    ASSERT_EQ(run({"conform", repository("corpus/aggregation"), "--export", path}).exit, 0);
    const std::string text = read_contents(path);
    EXPECT_THAT(text, StartsWith("des (0,"));
    EXPECT_THAT(text, HasSubstr("registerRead.present__seeRobot"));
    EXPECT_THAT(text, HasSubstr("registerWrite.wrote__set_linearSpeed.-1088"));
    const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n'));
    EXPECT_EQ(text.substr(0, text.find('\n')).find("," + std::to_string(lines - 1) + ","), 6U) << text.substr(0, 40);
}

TEST(CodeExport, OptionsThatDoNotFitAreSaid) {
    const auto ending = run({"conform", repository("corpus/aggregation"), "--export", "code.txt"});
    EXPECT_EQ(ending.exit, 4);
    EXPECT_THAT(ending.err, HasSubstr(".aut, .dot or .csp"));
    const auto large = run({"conform", repository("corpus/aggregation"), "--export", "code.aut", "--max-states", "3"});
    EXPECT_EQ(large.exit, 2);
    EXPECT_THAT(large.err, HasSubstr("nothing is written"));
}

}  // namespace
}  // namespace robochart::app::code_export_test
