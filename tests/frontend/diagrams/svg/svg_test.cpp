// SPDX-License-Identifier: Apache-2.0
// Tests that the SVG of all available models is well-formed and has unique ids, and that malicious text stays text.
#include "frontend/diagrams/svg/svg.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>

#include "base/diagnostics/files.hpp"
#include "tests/frontend/diagrams/models.hpp"
#include "tests/needed.hpp"

namespace robochart::diagrams {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Parses the texts with Python's XML parser.
void expect_well_formed(const std::vector<std::string>& texts) {
    std::string error;
    const diagnostics::TemporaryFolder folder("", error);
    ASSERT_EQ(error, "");
    for (std::size_t i = 0; i < texts.size(); ++i)
        ASSERT_EQ(diagnostics::write_below(folder.path(), std::to_string(i) + ".svg", texts[i]), "");
    const std::string command =
        "python3 -c 'import sys, glob, xml.etree.ElementTree as t\nfor f in glob.glob(sys.argv[1] + \"/*.svg\"): "
        "t.parse(f)' '" +
        folder.path() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
}

bool python_is_there() {
    return std::system("python3 -c '' > /dev/null 2>&1") == 0;
}

TEST(Svg, OfOurModelsIsWellFormed) {
    ROBOCHART_NEEDS(python_is_there(), "python3");
    std::vector<std::string> texts;
    draw_own_models([&](const DrawnModel& drawn) { texts.push_back(render_svg(drawn.picture, drawn.elements)); });
    expect_well_formed(texts);
}

TEST(Svg, IdsAreUnique) {
    draw_own_models([](const DrawnModel& drawn) {
        const std::string text = render_svg(drawn.picture, drawn.elements, {Theme::light, "p-"});
        const std::regex id("[ <]id=\"p-([^\"]*)\"");
        std::set<std::string> seen;
        for (auto at = std::sregex_iterator(text.begin(), text.end(), id); at != std::sregex_iterator(); ++at)
            EXPECT_TRUE(seen.insert((*at)[1]).second) << (*at)[1] << " in " << drawn.subject.name;
        EXPECT_GE(seen.size(), drawn.picture.boxes.size() + drawn.picture.lines.size());
    });
}

TEST(Svg, TheSamePictureIsTheSameText) {
    std::vector<std::string> first;
    draw_own_models([&](const DrawnModel& drawn) { first.push_back(render_svg(drawn.picture, drawn.elements)); });
    std::size_t next = 0;
    draw_own_models(
        [&](const DrawnModel& drawn) { EXPECT_EQ(render_svg(drawn.picture, drawn.elements), first[next++]); });
}

/// Returns the picture of a model with this string as an action.
std::string svg_with(const std::string& string) {
    std::string text;
    draw_each({{"m.rct", "stm M { var v : string initial i state s { entry v = \"" + string +
                             "\" } transition t { from i to s condition v == \"" + string + "\" } }\n"}},
              [&](const DrawnModel& drawn) { text = render_svg(drawn.picture, drawn.elements); });
    return text;
}

TEST(Svg, HostileTextStaysText) {
    for (const std::string hostile :
         {"</script><script>alert(1)</script>", "&amp;<!-- -->]]>", "<img onerror=alert(1)>"}) {
        const std::string text = svg_with(hostile);
        EXPECT_THAT(text, Not(HasSubstr("<script")));
        EXPECT_THAT(text, Not(HasSubstr("<img")));
        EXPECT_THAT(text, Not(HasSubstr("]]>")));
        if (python_is_there()) expect_well_formed({text});
    }
    // Characters that change the text direction, and characters of zero width, are made visible.
    EXPECT_THAT(svg_with("a\xE2\x80\xAE"
                         "b"),
                HasSubstr("\\u202e"));
}

TEST(Svg, NamesAreHostileToo) {
    Picture picture;
    picture.title = "\"><img onerror=x>";
    picture.size = {100, 100};
    PictureBox box;
    box.place = {10, 10, 80, 40};
    Text name;
    name.text = "\"><img onerror=x>\x01\xFF";
    box.texts.push_back(name);
    box.whole = "'</title><script>";
    picture.boxes.push_back(box);
    const auto loaded = random_models::load({{"m.rct", "stm M { }\n"}});
    const std::string text = render_svg(picture, Elements(loaded->model));
    EXPECT_THAT(text, Not(HasSubstr("<img")));
    EXPECT_THAT(text, Not(HasSubstr("<script")));
    if (python_is_there()) expect_well_formed({text});
}

TEST(Svg, LongNamesAreElidedAndKeptWhole) {
    const std::string name(10'000, 'n');
    std::string text;
    double width = 0;
    draw_each({{"m.rct",
                "stm " + name + " { initial i state s" + name + " { } transition t { from i to s" + name + " } }\n"}},
              [&](const DrawnModel& drawn) {
                  text = render_svg(drawn.picture, drawn.elements);
                  width = drawn.picture.size.width;
              });
    EXPECT_LT(width, 1'000);
    EXPECT_THAT(text, HasSubstr("state s" + name + "\n"));
    EXPECT_THAT(text, HasSubstr("\xE2\x80\xA6</text>"));
}

TEST(Svg, ThemesHaveTheirColours) {
    const auto loaded = random_models::load({{"m.rct", "stm M { }\n"}});
    const Elements elements(loaded->model);
    const std::string automatic = render_svg({}, elements);
    EXPECT_THAT(automatic, HasSubstr("@media screen and (prefers-color-scheme:dark)"));
    EXPECT_THAT(automatic, HasSubstr("role=\"img\""));
    EXPECT_THAT(render_svg({}, elements, {Theme::light, ""}), Not(HasSubstr("#1e1e1e")));
    EXPECT_THAT(render_svg({}, elements, {Theme::dark, ""}), HasSubstr(".page{fill:#1e1e1e}"));
}

}  // namespace
}  // namespace robochart::diagrams
