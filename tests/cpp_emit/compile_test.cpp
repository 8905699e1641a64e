// Everything generated for the corpus compiles without warnings on both compilers, the controller also without
// exceptions and run-time types; a scripted run of it is clean under AddressSanitizer and UBSan.
#include <gtest/gtest.h>

#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"

namespace robochart::cpp_emit {
namespace {

using testing::Folder;

struct Case {
    const char* model;
    const char* component;
    const char* machine;  ///< name of the class
    const char* script;   ///< lines for the console driver
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.component;
}

class Compiles : public ::testing::TestWithParam<Case> {
protected:
    void SetUp() override {
        const ir::System system = testing::corpus(GetParam().model);
        folder_.write(testing::emit_ok(system, testing::component(system, GetParam().component)));
    }

    void expect_clean(const std::string& compiler) const {
        std::string ignored;
        if (folder_.status(compiler + " --version", ignored) != 0) GTEST_SKIP() << compiler << " is not installed";
        const std::string strict = compiler + " -std=c++20 -Wall -Wextra -Wpedantic -Wconversion -Werror -I. -c ";
        folder_.run(strict + "-fno-exceptions -fno-rtti *_explore.cpp " + GetParam().machine + ".cpp");
        folder_.run(strict + "main.cpp");
    }

    Folder folder_;
};

TEST_P(Compiles, WithGcc) {
    expect_clean("g++");
}
TEST_P(Compiles, WithClang) {
    expect_clean("clang++");
}

TEST_P(Compiles, AndRunsCleanUnderSanitizers) {
    folder_.run(std::string("c++ -std=c++20 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all -I. main.cpp ") +
                GetParam().machine + ".cpp -o console");
    const std::string output = folder_.run(std::string("printf '") + GetParam().script + "' | ./console");
    EXPECT_EQ(output.find("not an input"), std::string::npos) << output;
    EXPECT_NE(output.find("cycle 4"), std::string::npos) << output;
}

const char* const aggregation_script = "\\nseeRobot\\nseeRobot seeWall\\n\\nseeWall\\n";
const char* const taxis_script =
    "\\nillumination=true\\nrobotDetected\\nheading=0.2\\n\\nturned\\nillumination=false\\n";
// The machine alone does not use `turned`: Turn is the platform's.
const char* const machine_script = "\\nillumination=true\\nrobotDetected\\nheading=0.2\\n\\n";

INSTANTIATE_TEST_SUITE_P(Corpus, Compiles,
                         ::testing::Values(Case{"aggregation", "AggregationFSM", "AggregationFSM", aggregation_script},
                                           Case{"aggregation", "Aggregation", "AggregationFSM", aggregation_script},
                                           Case{"swarm_taxis", "SwarmTaxisFSM", "SwarmTaxisFSM", machine_script},
                                           Case{"swarm_taxis", "SwarmTaxis", "SwarmTaxisFSM", taxis_script}),
                         [](const auto& test) { return test.param.component; });

}  // namespace
}  // namespace robochart::cpp_emit
