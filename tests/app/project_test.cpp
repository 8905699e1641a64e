// SPDX-License-Identifier: Apache-2.0
// Tests the verb `emit cpp --target`: the folders of the projects, files that are kept, inputs that are rejected.
// tests/cpp_emit/project_test.cpp tests the contents of the projects.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "command.hpp"

namespace robochart::app::project_test {
namespace {

namespace fs = std::filesystem;
using testing::Folder;
using ::testing::HasSubstr;
using ::testing::Not;
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

/// A capacity is a number from 1 to 65536 for an event or variable with lists. If an event has no capacity, a note
/// names it.
TEST(EmitCppCapacity, IsCheckedAndUsed) {
    const TemporaryFile model("m.rct",
                              "stm M { event found : Seq(nat) event stop event last : Seq(nat) var s : Seq(nat)\n"
                              "initial i state A { } transition t0 { from i to A }\n"
                              "transition t1 { from A to A trigger found?s } transition t2 { from A to A trigger stop\n"
                              "action last!s } }\n");
    const Folder folder;
    const auto emitted = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"emit", "cpp", model.path(), "--out", folder.path()};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    };
    for (const char* wrong : {"found=0", "found=-1", "found=1000000000", "found=", "found=many", "=4", "found"}) {
        const auto ran = emitted({"--capacity", wrong});
        EXPECT_EQ(ran.exit, 4) << wrong;
        EXPECT_THAT(ran.err, HasSubstr("expected EVENT=N, with a whole number N from 1 to 65536")) << wrong;
    }
    for (const char* name : {"stop", "nothing"}) {
        const auto ran = emitted({"--capacity", std::string(name) + "=4"});
        EXPECT_EQ(ran.exit, 4) << name;
        EXPECT_THAT(ran.err, HasSubstr("no event or variable '" + std::string(name) + "' has lists"));
    }
    EXPECT_FALSE(fs::exists(folder.path() + "/cpp")) << "nothing is written if the command is wrong";
    EXPECT_THAT(emitted({}).err, HasSubstr("note[RC-G16]: the lists of 'found' have at most 64 items"));
    const auto good = emitted({"--capacity", "found=360"});
    EXPECT_EQ(good.exit, 0) << good.err;
    EXPECT_THAT(good.err, Not(HasSubstr("RC-G16")));
    std::ifstream core(folder.path() + "/cpp/M/M_core.hpp");
    const std::string text{std::istreambuf_iterator<char>(core), {}};
    EXPECT_THAT(text, HasSubstr("robochart::Sequence<Nat, robochart::capacity<Types>(360)> s"));
}

/// A machine `M` with an operation, and a mapping for it.
class EmitCppMapping : public ::testing::Test {
protected:
    [[nodiscard]] testing::Ran emit(const std::string& mapping, const std::vector<std::string>& more = {}) const {
        const TemporaryFile file("m.ros2", mapping);
        std::vector<std::string> words{"emit", "cpp", model_.path(), "--out", folder_.path(), "--mapping", file.path()};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }

    Folder folder_;
    TemporaryFile model_{"m.rct",
                         "interface I { stop() } stm M { requires I initial i state A { entry stop() }\n"
                         "transition t { from i to A } }\n"
                         "stm N { initial i state A { } transition t { from i to A } }\n"};
};

TEST_F(EmitCppMapping, WritesThePackageOfItsComponent) {
    const auto ran =
        emit("ros2 for M { publish operation stop as geometry_msgs/Twist on \"cmd_vel\" }", {"--target", "ros2"});
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_TRUE(fs::exists(folder_.path() + "/ros2/M/launch/robot_m.launch.py"));
    EXPECT_FALSE(fs::exists(folder_.path() + "/ros2/N"));
}

/// A second run writes all files again, except those in the folder `own`.
TEST_F(EmitCppMapping, KeepsTheUsersFiles) {
    const std::vector<std::string> words{"--target",     "ros2",          "--license",         "Apache-2.0",
                                         "--maintainer", "Ada <a@b.org>", "--package-version", "1.2.3"};
    EXPECT_EQ(emit("ros2 for M { }", words).exit, 0);
    const std::string folder = folder_.path() + "/ros2/M/";
    for (const char* const file : {"own/own.cmake", "own/mine.cpp", "package.xml"})
        std::ofstream(folder + file) << "mine";
    EXPECT_EQ(emit("ros2 for M { }", words).exit, 0);
    const auto text_of = [&](const std::string& file) {
        std::ifstream in(folder + file);
        return std::string{std::istreambuf_iterator<char>(in), {}};
    };
    EXPECT_EQ(text_of("own/own.cmake"), "mine");
    EXPECT_EQ(text_of("own/mine.cpp"), "mine");
    EXPECT_THAT(text_of("package.xml"), HasSubstr("<version>1.2.3</version>"));
    EXPECT_THAT(text_of("package.xml"), HasSubstr("<maintainer email=\"a@b.org\">Ada</maintainer>"));
}

TEST_F(EmitCppMapping, RefusesFactsThatNoManifestCanHave) {
    for (const auto& [option, word] :
         std::vector<std::pair<std::string, std::string>>{{"--package-version", "1.2"},
                                                          {"--package-version", "1.2.x"},
                                                          {"--package-version", "1..2"},
                                                          {"--license", "<evil/>"},
                                                          {"--license", ""},
                                                          {"--maintainer", "Ada"},
                                                          {"--maintainer", "Ada <ada>"},
                                                          {"--maintainer", "Ada <ada@localhost>"},
                                                          {"--maintainer", "Ada <ada@b.c>"},
                                                          {"--maintainer", "Ada <ada@b.c3>"},
                                                          {"--maintainer", "Ada <a@a@b.org>"},
                                                          {"--maintainer", "Ada <ada@.org>"},
                                                          {"--maintainer", "Ada <@b.org>"},
                                                          {"--maintainer", "Ada <a d@b.org>"},
                                                          {"--maintainer", "<a@b.org>"}}) {
        const auto ran = emit("ros2 for M { }", {"--target", "ros2", option, word});
        EXPECT_EQ(ran.exit, 4) << option << ' ' << word;
        EXPECT_THAT(ran.err, HasSubstr(option));
    }
    for (const auto& words : {std::vector<std::string>{"--license", "MIT"}, {"--model-names"}}) {
        const auto ran = run([&] {
            std::vector<std::string> all{"emit", "cpp", model_.path(), "--out", folder_.path()};
            all.insert(all.end(), words.begin(), words.end());
            return all;
        }());
        EXPECT_EQ(ran.exit, 4);
        EXPECT_THAT(ran.err, HasSubstr("--target ros2"));
    }
}

TEST_F(EmitCppMapping, RefusesWhatItCannotMean) {
    const auto other = emit("ros2 for NN { }", {"--target", "ros2"});
    EXPECT_EQ(other.exit, 2);
    EXPECT_THAT(other.err, HasSubstr("RC-R02"));
    EXPECT_THAT(other.err, HasSubstr("did you mean 'N'?"));
    EXPECT_THAT(other.err, HasSubstr("m.ros2:1:10"));
    const auto wrong = emit("ros2 for M { stop }", {"--target", "ros2"});
    EXPECT_EQ(wrong.exit, 2);
    EXPECT_THAT(wrong.err, HasSubstr("RC-R01"));
    const auto useless = emit("ros2 for M { }");
    EXPECT_EQ(useless.exit, 4);
    EXPECT_THAT(useless.err, HasSubstr("--target ros2"));
    const auto absent =
        run({"emit", "cpp", model_.path(), "--target", "ros2", "--mapping", folder_.path() + "/none.ros2"});
    EXPECT_EQ(absent.exit, 2);
    EXPECT_THAT(absent.err, HasSubstr("RC-F01"));
    EXPECT_FALSE(fs::exists(folder_.path() + "/ros2"));
}

}  // namespace
}  // namespace robochart::app::project_test
