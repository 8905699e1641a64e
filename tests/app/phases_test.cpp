// SPDX-License-Identifier: Apache-2.0
// Compares the output of each phase, for one model that uses every construct (phases/gate.rct), with the stored text.
// After an intended change, read the new texts, then store them: ROBOCHART_STORE_GOLDEN=tests/app/phases.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/app/command.hpp"

namespace robochart::app::phases_test {
namespace {

std::string read(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

void expect_golden(const std::string& name, const std::string& text) {
    EXPECT_EQ(text, read(testing::repository("tests/app/phases/" + name))) << name;
    if (const char* target = std::getenv("ROBOCHART_STORE_GOLDEN"))
        std::ofstream(std::string(target) + "/" + name) << text;
}

struct Phase {
    const char* name;
    const char* golden;
};

void PrintTo(const Phase& phase, std::ostream* out) {
    *out << phase.name;
}

class Phases : public ::testing::TestWithParam<Phase> {};

/// Runs the command in the folder of the models, because reports name files as the command line does.
testing::Ran run_beside_the_models(const std::string& arguments) {
    return testing::run_shell("cp '" + testing::repository("tests/app/phases") + "'/gate.* . && \"$verify\" " +
                              arguments);
}

TEST_P(Phases, PrintWhatIsStored) {
    const testing::Ran ran =
        run_beside_the_models("check gate.rct gate.assertions --print " + std::string(GetParam().name));
    EXPECT_EQ(ran.exit, 0) << ran.err;
    expect_golden(GetParam().golden, ran.out);
}

INSTANTIATE_TEST_SUITE_P(OfOneModel, Phases,
                         ::testing::Values(Phase{"ast", "ast.txt"}, Phase{"model", "model.txt"}, Phase{"ir", "ir.txt"},
                                           Phase{"script", "script.csp"}, Phase{"timed-script", "timed_script.csp"}),
                         [](const auto& test) {
                             const std::string file = test.param.golden;
                             return file.substr(0, file.find('.'));
                         });

TEST(PhasesOfOneModel, CodeIsWhatIsStored) {
    const testing::Ran ran = run_beside_the_models("emit cpp gate.rct --out . --quiet && cat cpp/Gate/Gate_core.hpp");
    EXPECT_EQ(ran.exit, 0) << ran.err;
    expect_golden("Gate_core.hpp.txt", ran.out);
}

}  // namespace
}  // namespace robochart::app::phases_test
