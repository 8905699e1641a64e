// SVG of every model at hand is well-formed, with ids that are unique.
#include "diagrams/svg/svg.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "tests/diagrams/models.hpp"

namespace robochart::diagrams {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Svg, IdsAreUnique) {
    draw_own_models([](const DrawnModel& drawn) {
        const std::string text = svg(drawn.picture, drawn.elements);
        const std::regex id("[ <]id=\"([^\"]*)\"");
        std::set<std::string> seen;
        for (auto at = std::sregex_iterator(text.begin(), text.end(), id); at != std::sregex_iterator(); ++at)
            EXPECT_TRUE(seen.insert((*at)[1]).second) << (*at)[1] << " in " << drawn.subject.name;
        EXPECT_GE(seen.size(), drawn.picture.boxes.size() + drawn.picture.lines.size());
    });
}

}  // namespace
}  // namespace robochart::diagrams
