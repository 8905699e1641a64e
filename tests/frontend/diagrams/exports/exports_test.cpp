// SPDX-License-Identifier: Apache-2.0
// Tests exports for Mermaid and Graphviz: their contents, and that Graphviz parses them.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/diagnostics/files.hpp"
#include "frontend/diagrams/exports/dot.hpp"
#include "frontend/diagrams/exports/mermaid.hpp"
#include "tests/frontend/diagrams/models.hpp"
#include "tests/needed.hpp"

namespace robochart::diagrams {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr const char* model =
    "stm M { event e event f : nat var x : nat initial i junction j final F\n"
    " state s { entry x = 1; wait(2) state t { } initial k transition u { from k to t } }\n"
    " transition a { from i to s } transition b { from s to j trigger f?x condition x > 1 }\n"
    " transition c { from j to F } transition d { from s to s trigger e } }\n";

std::string exported(std::string (*format)(const Picture&), const std::string& text = model) {
    std::string result;
    draw_each({{"m.rct", text}}, [&](const DrawnModel& drawn) { result = format(drawn.picture); });
    return result;
}

TEST(Mermaid, SaysWhatIsDrawn) {
    EXPECT_EQ(exported(render_mermaid),
              "stateDiagram-v2\n"
              "  %% state machine M\n"
              "  %% not shown: interfaces, variables, constants and clocks of the component\n"
              "  %% not shown: its events\n"
              "  state n4 <<choice>>\n"
              "  state \"s<br/>entry x = 1#59; wait(2)\" as n6 {\n"
              "    state \"t\" as n7\n"
              "    [*] --> n7\n"
              "  }\n"
              "  [*] --> n6\n"
              "  n6 --> n4 : f?x[x #62; 1]\n"
              "  n4 --> [*]\n"
              "  n6 --> n6 : e\n");
}

/// `;` would end a statement, Mermaid rejects `::`, and `\n` would be a line end.
TEST(Mermaid, TextIsEscaped) {
    const std::string text = exported(
        render_mermaid,
        "stm M { var v : string initial i state s { entry v = \"a;b::c\\n%%{}<x>\" } transition t { from i to s } }\n");
    const std::size_t begin = text.find("entry v");
    ASSERT_NE(begin, std::string::npos);
    const std::string action = text.substr(begin, text.find('\n', begin) - begin);
    for (const char* sign : {"::", "\\", "%", "{", "}", "<", ">", "\""}) EXPECT_THAT(action, Not(HasSubstr(sign)));
    EXPECT_THAT(action, HasSubstr("a#59;b#58;#58;c#92;n"));
}

/// If a nested composite state has a note, Mermaid 12 draws the state outside its parent.
TEST(Mermaid, ActionsOfNestedCompositesAreInTheirTitles) {
    const std::string text =
        exported(render_mermaid,
                 "stm M { initial i state Outer { initial j state Inner { during wait(1) exit wait(2) initial k state "
                 "Deep { entry wait(3) } transition c { from k to Deep } } transition b { from j to Inner } }\n"
                 " transition a { from i to Outer } }\n");
    EXPECT_THAT(text, HasSubstr("    state \"Inner<br/>during wait(1)<br/>exit wait(2)\" as "));
    EXPECT_THAT(text, HasSubstr(" : entry wait(3)\n"));
    EXPECT_THAT(text, Not(HasSubstr("note")));
}

TEST(Mermaid, ComponentsAreFlowcharts) {
    const std::string text = exported(render_mermaid,
                                      "stm S { event e initial i }\nstm T { event e initial i }\n"
                                      "controller C { sref a = S sref b = T connection a on e to b on e }\n");
    EXPECT_THAT(text, StartsWith("flowchart LR\n  %% controller C\n  %% not shown: that events are on the borders of "
                                 "components: they are in them\n"));
    EXPECT_THAT(text, HasSubstr("ref a = S"));
    EXPECT_THAT(text, HasSubstr(" --> "));
}

TEST(Dot, SaysWhatIsDrawn) {
    const std::string text = exported(render_dot);
    EXPECT_THAT(text, StartsWith("digraph \"state machine M\" {\n"));
    EXPECT_THAT(text, HasSubstr("n6 -> n4 [label=\"f?x[x > 1]\", ltail=cluster_n6];"));
    EXPECT_THAT(text, HasSubstr("subgraph cluster_n6 {\n      label=\"s\\nentry x = 1; wait(2)\";"));
}

TEST(Dot, IsReadByGraphviz) {
    ROBOCHART_NEEDS(std::system("nop -p /dev/null > /dev/null 2>&1") == 0, "nop (Debian: graphviz)");
    std::string error;
    const diagnostics::TemporaryFolder folder("", error);
    ASSERT_EQ(error, "");
    std::size_t count = 0;
    draw_own_models([&](const DrawnModel& drawn) {
        ASSERT_EQ(diagnostics::write_below(folder.path(), fmt::format("{}.dot", count++), render_dot(drawn.picture)),
                  "");
    });
    EXPECT_EQ(std::system(("nop -p '" + folder.path() + "'/*.dot").c_str()), 0) << "of " << count;
}

}  // namespace
}  // namespace robochart::diagrams
