// SPDX-License-Identifier: Apache-2.0
// Tests `init`: the files that it writes can be verified without changes, and it overwrites no existing file.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

#include "tests/app/command.hpp"

namespace robochart::app::testing::init_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Init, WritesAProjectThatVerifiesAtOnce) {
    const Ran ran = run_shell(
        "\"$verify\" init wanderer && \"$verify\" format --check wanderer && \"$verify\" wanderer --no-cache && "
        "\"$verify\" check wanderer --core");
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    EXPECT_THAT(
        ran.out,
        HasSubstr("wanderer/wanderer.rct\nwanderer/wanderer.assertions\nwanderer/wanderer.claims\nwanderer/README.md\n"
                  "wanderer/.gitignore\n\nnext: robochart-verify wanderer\n"));
    EXPECT_THAT(ran.out, HasSubstr("1 of 1 controllers conform"));
    EXPECT_THAT(ran.out, HasSubstr("next: robochart-verify wanderer\n"));
    EXPECT_THAT(ran.err, Not(HasSubstr("warning")));
}

TEST(Init, WithASimulation) {
    const Ran ran = run_shell(
        "\"$verify\" init wanderer --simulation && cat wanderer/README.md && cd wanderer && "
        "\"$verify\" simulate wanderer.scenario --no-cache --no-pictures");
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("robochart-verify simulate wanderer.scenario"));
    EXPECT_THAT(ran.out, HasSubstr("1 of 1 bands hold"));
}

TEST(Init, WithAPackageForRos2) {
    const Ran ran = run_shell(
        "\"$verify\" init wanderer --ros2 && cd wanderer && "
        "\"$verify\" emit cpp . --target ros2 --mapping wanderer.ros2 && cat out/ros2/Robot/package.xml README.md");
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("<depend>geometry_msgs</depend>"));
    EXPECT_THAT(ran.out, HasSubstr("--mapping wanderer.ros2"));
    EXPECT_THAT(ran.err, Not(HasSubstr("RC-R"))) << "every operation has its message";
}

TEST(Init, LeavesNoMarkOfATemplate) {
    const Ran ran =
        run_shell("\"$verify\" init a --simulation --ros2 && \"$verify\" init b && cat a/* a/.gitignore b/*");
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_THAT(ran.out, Not(HasSubstr("@")));
}

// The names are those of the model's own elements and reserved words of CSPM and C++.
TEST(Init, TakesNamesThatOtherLanguagesReserve) {
    for (const std::string name :
         {"Robot", "Wander", "Brain", "Motors", "class", "int", "std", "tock", "STOP", "Seq"}) {
        const Ran ran = run_shell("\"$verify\" init " + name + " && \"$verify\" --no-cache " + name);
        EXPECT_EQ(ran.exit, 0) << name << "\n" << ran.out << ran.err;
    }
}

TEST(Init, RefusesWhatIsNoName) {
    for (const std::string name : {"state", "2wheels", "_x", "my-robot", "a b", "/", "''", "\"$(printf 'a\\nb')\"",
                                   "\"$(printf 'a%.0s' $(seq 65))\""}) {
        const Ran ran =
            run_shell("\"$verify\" init " + (name == "a b" ? "'a b'" : name) + "; echo $?; ls -A | grep -v txt");
        EXPECT_THAT(ran.err, HasSubstr("cannot be the name of a project: ")) << name;
        EXPECT_EQ(ran.out, "4\n") << name;
    }
    EXPECT_EQ(run({"init", "a", "b"}).exit, 4);
}

TEST(Init, SuggestsANameThatIsFit) {
    const std::pair<std::string, std::string> rows[] = {
        {"my-robot",
         "made of letters, digits and _, and begins with a "
         "letter; did you mean 'my_robot'?"},
        {"../here/my-robot/", "did you mean '../here/my_robot'?"},
        {"2wheels", "did you mean 'robot_2wheels'?"},
        {"__a..b--", "did you mean 'a_b'?"},
        {"model.rct", "did you mean 'model'?"},
        {"state", "a reserved word of RoboChart; did you mean 'robot_state'?"},
        {"channel", "a reserved word of CSPM; did you mean 'robot_channel'?"},
        {"Polite", "called so; did you mean 'robot_Polite'?"}};
    for (const auto& [name, message] : rows) {
        const Ran ran = run({"init", name});
        EXPECT_EQ(ran.exit, 4) << name;
        EXPECT_THAT(ran.err, HasSubstr(message)) << name;
    }
    EXPECT_THAT(run({"init", "--", "!!"}).err, Not(HasSubstr("did you mean")));
    const std::string longest(100, 'a');
    EXPECT_THAT(run({"init", longest}).err, HasSubstr("did you mean 'aaa"));
}

TEST(Init, HereMakesAFitNameOfTheFolders) {
    const Ran ran =
        run_shell("mkdir my-robot && cd my-robot && \"$verify\" init && \"$verify\" . --no-cache -q; echo $?; ls");
    EXPECT_THAT(ran.out,
                HasSubstr("controllers conform\n0\nREADME.md\nmy_robot.assertions\nmy_robot.claims\nmy_robot.rct\n"))
        << ran.err;
}

TEST(Init, HereTakesTheNameOfTheFolder) {
    const Ran ran = run_shell(
        "mkdir robot && cd robot && echo mine > README.md && \"$verify\" init; echo $?; ls -A; "
        "cat README.md");
    EXPECT_THAT(ran.out, HasSubstr("./README.md is left as it is"));
    EXPECT_THAT(ran.out, HasSubstr("0\n.gitignore\nREADME.md\nrobot.assertions\nrobot.claims\nrobot.rct\nmine\n"));
}

TEST(Init, NeverTouchesAModel) {
    const Ran other = run_shell("mkdir r && echo x > r/other.rct && \"$verify\" init r; echo $?; ls -A r");
    EXPECT_THAT(other.err, HasSubstr("there is a model already: r/other.rct; nothing is written"));
    EXPECT_EQ(other.out, "2\nother.rct\n");
    const Ran same = run_shell("mkdir r && ln -s nowhere r/r.assertions && \"$verify\" init r; echo $?; ls -A r");
    EXPECT_THAT(same.err, HasSubstr("r/r.assertions is there already; nothing is written"));
    EXPECT_EQ(same.out, "2\nr.assertions\n");
    const Ran file = run_shell("touch r && \"$verify\" init r; echo $?");
    EXPECT_THAT(file.err, HasSubstr("r is there already, and is no folder"));
    EXPECT_EQ(file.out, "2\n");
}

TEST(Init, SaysWhyNothingCanBeWritten) {
    const Ran ran = run_shell("\"$verify\" init /proc/robot; echo $?");
    EXPECT_THAT(ran.err, HasSubstr("/proc/robot"));
    EXPECT_EQ(ran.out, "2\n");
}

}  // namespace
}  // namespace robochart::app::testing::init_test
