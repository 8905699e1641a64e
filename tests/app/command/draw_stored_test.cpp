// SPDX-License-Identifier: Apache-2.0
// Tests `draw` with the diagrams that RoboTool stores next to a model.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frontend/diagrams/stored/aird.hpp"
#include "tests/app/command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::draw_stored_test {
namespace {

using testing::Folder;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::run;
using testing::run_shell;
using tests::read_contents;

constexpr const char* machine =
    "stm S {\n event e\n initial i\n state A { }\n transition t { from i to A }\n transition u { from A to A trigger e "
    "}\n}\n";

/// The file stores the positions of two nodes, 300 pixels apart. The program routes the transitions.
constexpr const char* diagrams =
    "<XMI xmlns:xmi=\"m\"><d:DSemanticDiagram xmlns:d=\"d\"><ownedAnnotationEntries><data "
    "xmi:type=\"notation:Diagram\">"
    "<children type=\"2002\" element=\"s\"><children type=\"7001\"><children type=\"3008\" element=\"n\">"
    "<children type=\"3007\" element=\"i\"><layoutConstraint x=\"10\" y=\"10\"/></children>"
    "<children type=\"3008\" element=\"a\"><layoutConstraint x=\"310\" y=\"10\"/></children>"
    "</children></children></children></data></ownedAnnotationEntries>"
    "<ownedDiagramElements uid=\"s\" name=\"S\"><target href=\"m.rct#//@machines.0\"/><actualMapping "
    "href=\"x[name='StateMachineID']\"/></ownedDiagramElements>"
    "<ownedDiagramElements uid=\"n\"><target href=\"m.rct#//@machines.0\"/><actualMapping href=\"x[name='NodesID']\"/>"
    "</ownedDiagramElements>"
    "<ownedDiagramElements uid=\"i\" name=\"i\"><target href=\"m.rct#//@machines.0/@nodes.0\"/><actualMapping "
    "href=\"x[name='InitialID']\"/></ownedDiagramElements>"
    "<ownedDiagramElements uid=\"a\" name=\"A\"><target href=\"m.rct#//@machines.0/@nodes.1\"/><actualMapping "
    "href=\"x[name='StateID']\"/></ownedDiagramElements>"
    "</d:DSemanticDiagram></XMI>";

/// Runs the commands in a folder with the model and a file of diagrams.
std::string with(const std::string& aird, const std::string& commands) {
    return std::string("cat > m.rct <<'EOF'\n") + machine + "EOF\ncat > representations.aird <<'EOF'\n" + aird +
           "\nEOF\n" + commands;
}

TEST(DrawStored, UsesWhatAPersonDrew) {
    const auto own = run_shell(with("<x/>", "\"$verify\" draw m.rct S --allow STM8"));
    const auto drawn = run_shell(with(diagrams, "\"$verify\" draw m.rct S --allow STM8"));
    EXPECT_EQ(drawn.exit, 0) << drawn.err;
    EXPECT_NE(drawn.out, own.out);
    // The state is 5 pixels inside the frame, which is 14 pixels from the left of the picture.
    EXPECT_THAT(drawn.out, HasSubstr("x=\"329\""));
    EXPECT_THAT(drawn.err,
                HasSubstr("note[RC-D03]: state machine S is drawn as in representations.aird, which does not "
                          "have transition t, transition u"));
    EXPECT_THAT(own.err, Not(HasSubstr("RC-D0")));
}

/// The formats for other programs contain no positions.
TEST(DrawStored, FormatsForOtherProgramsAreAsWithoutIt) {
    for (const std::string format : {"dot", "mermaid"}) {
        const std::string command = "\"$verify\" draw m.rct S --allow STM8 --format " + format;
        const auto ran = run_shell(with(diagrams, command));
        EXPECT_EQ(ran.exit, 0) << ran.err;
        EXPECT_EQ(ran.out, run_shell(with("<x/>", command)).out);
        EXPECT_THAT(ran.err, Not(HasSubstr("RC-D0")));
        EXPECT_THAT(run_shell(with("<x", command)).err, Not(HasSubstr("RC-D0")));
    }
}

TEST(DrawStored, ABrokenFileIsANoteAndNothingElse) {
    const std::string command = "\"$verify\" draw m.rct S --deny-warnings --allow STM8";
    const auto own = run_shell(with("<x/>", command));
    for (const std::string text : {"<x", "<!DOCTYPE a [<!ENTITY b \"c\">]><a>&b;</a>", "\xff", "no XML at all"}) {
        const auto ran = run_shell(with(text, command));
        EXPECT_EQ(ran.exit, own.exit) << ran.err;
        EXPECT_EQ(ran.out, own.out) << text;
        EXPECT_THAT(ran.err, HasSubstr("note[RC-D01]: the diagrams of representations.aird are not used: ")) << text;
        EXPECT_THAT(ran.err, HasSubstr("representations.aird:1:")) << text;
    }
}

TEST(DrawStored, FilesThatAreNoneAreANote) {
    const auto ran =
        run_shell(with("", "rm representations.aird; mkfifo representations.aird; \"$verify\" draw m.rct S"));
    EXPECT_EQ(ran.exit, 0);
    EXPECT_THAT(ran.err, HasSubstr("note[RC-D01]"));
}

/// The command never writes the file of diagrams.
TEST(DrawStored, LeavesTheFileAsItIs) {
    const auto ran = run_shell(with(diagrams,
                                    "chmod 400 representations.aird; cp -p representations.aird before; "
                                    "\"$verify\" draw m.rct > /dev/null 2>&1; cmp representations.aird before; "
                                    "stat -c %y representations.aird before | uniq | wc -l"));
    EXPECT_EQ(ran.out, "1\n");
}

/// References to other files are ignored: the command neither opens these files nor reports them as missing.
TEST(DrawStored, OpensNoOtherFile) {
    std::string aird = diagrams;
    for (std::size_t at = 0; (at = aird.find("m.rct#", at)) != std::string::npos; at += 20)
        aird.replace(at, 5, "../pipe/m.rct");
    const auto ran = run_shell(with(aird, "mkdir pipe; mkfifo pipe/m.rct; cd . && \"$verify\" draw m.rct S"));
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("RC-D03"));
}

TEST(DrawStored, ThePageOfAReportHasItToo) {
    const auto ran = run_shell(with(diagrams, "\"$verify\" check m.rct --html page.html > /dev/null; cat page.html"));
    EXPECT_THAT(ran.out, HasSubstr("x=\"329\""));
}

}  // namespace
}  // namespace robochart::app::draw_stored_test
