// The verb `emit cpp --target` as a user runs it: where the projects go, what is kept, what is refused. What they are
// is tested in tests/cpp_emit/project_test.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "command.hpp"

namespace robochart::app {
namespace {

namespace fs = std::filesystem;
using testing::Folder;
using ::testing::HasSubstr;
using testing::repository;
using testing::run;
using testing::TemporaryFile;

TEST(EmitCppTarget, WritesAProjectForEachComponentBelowTheTarget) {
    const Folder folder;
    for (const char* target : {"library", "main", "ros2", "enki", "argos"}) {
        const auto ran =
            run({"emit", "cpp", repository("corpus/aggregation"), "--target", target, "--out", folder.path()});
        EXPECT_EQ(ran.exit, 0) << ran.err;
        const std::string project = folder.path() + "/" + target + "/Aggregation";
        EXPECT_TRUE(fs::exists(project + "/CMakeLists.txt")) << target;
        EXPECT_TRUE(fs::exists(project + "/controller/AggregationFSM.hpp")) << target;
        EXPECT_FALSE(fs::exists(project + "/controller/Aggregation_explore.cpp")) << "for the conformance check only";
        EXPECT_THAT(ran.out, HasSubstr(project + "/CMakeLists.txt"));
    }
    EXPECT_FALSE(fs::exists(folder.path() + "/cpp"));
}

TEST(EmitCppTarget, LeavesTheAuthorsFileAlone) {
    const Folder folder;
    const std::vector<std::string> words{"emit",  "cpp",        repository("corpus/aggregation"), "--target", "enki",
                                         "--out", folder.path()};
    EXPECT_EQ(run(words).exit, 0);
    const std::string mine = folder.path() + "/enki/Aggregation/robot.hpp";
    const std::string main = folder.path() + "/enki/Aggregation/main.cpp";
    std::ofstream(mine) << "// changed\n";
    std::ofstream(main) << "// changed\n";
    EXPECT_EQ(run(words).exit, 0);
    EXPECT_EQ(fs::file_size(mine), 11U);
    EXPECT_GT(fs::file_size(main), 1000U);
}

TEST(EmitCppTarget, RefusesByName) {
    const TemporaryFile model("m.rct",
                              "interface E { event found : Seq(nat) }\n"
                              "stm M { uses E var s : Seq(nat) initial i state A { }\n"
                              "transition t0 { from i to A } transition t1 { from A to A trigger found?s } }\n");
    const auto ran = run({"emit", "cpp", model.path(), "--target", "ros2"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, HasSubstr("RC-G14"));
    const auto unknown = run({"emit", "cpp", model.path(), "--target", "arduino"});
    EXPECT_EQ(unknown.exit, 4);
    EXPECT_THAT(unknown.err, HasSubstr("arduino"));
}

}  // namespace
}  // namespace robochart::app
