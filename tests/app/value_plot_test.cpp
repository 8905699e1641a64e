// SPDX-License-Identifier: Apache-2.0
// Tests the lines and points in plots of probabilistic assertions.
#include "app/report/value_plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace robochart::app::value_plot_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Returns a row with one result per value.
probability::Row row(NamedValues constants, const std::vector<std::int64_t>& values) {
    probability::Row row;
    row.constants = std::move(constants);
    for (const std::int64_t value : values) {
        prism::Result result;
        result.kind = prism::Result::Kind::number;
        result.low = result.high = prism::Real(value);
        row.results.push_back(result);
    }
    return row;
}

std::string plot(std::vector<probability::Row> rows) {
    return value_plot("A1 P=?", {"", "", std::move(rows)});
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST(ValuePlot, LeastAndGreatestValuesAreTwoLines) {
    const std::string svg = plot({row({{"N", "10"}}, {1, 3}), row({{"N", "2"}}, {2, 4})});
    EXPECT_THAT(svg, HasSubstr("<title>A1 P=?</title>"));
    EXPECT_THAT(svg, HasSubstr(">N</text>"));
    EXPECT_THAT(svg, HasSubstr(">least</text>"));
    EXPECT_THAT(svg, HasSubstr(">greatest</text>"));
    EXPECT_EQ(count(svg, "<polyline"), 2U);
    EXPECT_EQ(count(svg, "<circle"), 4U);
    EXPECT_EQ(count(svg, "<polyline points=\"62.0,"), 2U) << "both lines begin at N = 2, the left end of the axis";
}

TEST(ValuePlot, EachCombinationOfTheOtherConstantsIsALine) {
    std::vector<probability::Row> rows;
    for (const char* const m : {"1", "2"})
        for (const char* const n : {"1/4", "1/2", "3/4"}) rows.push_back(row({{"K", "7"}, {"M", m}, {"N", n}}, {1}));
    const std::string svg = plot(rows);
    EXPECT_THAT(svg, HasSubstr(">N</text>")) << "the constant with the most values";
    EXPECT_THAT(svg, HasSubstr(">value, M=1</text>"));
    EXPECT_THAT(svg, HasSubstr(">value, M=2</text>"));
    EXPECT_EQ(count(svg, "<polyline"), 2U);
    EXPECT_THAT(svg, Not(HasSubstr("K="))) << "it does not vary";
}

TEST(ValuePlot, NeedsNumbers) {
    EXPECT_EQ(plot({row({{"N", "1"}}, {1})}), "") << "one value of N";
    EXPECT_EQ(plot({row({{"N", "red"}}, {1}), row({{"N", "blue"}}, {1})}), "");
    EXPECT_EQ(plot({row({{"N", "1"}}, {}), row({{"N", "2"}}, {})}), "") << "no answers";
}

}  // namespace
}  // namespace robochart::app::value_plot_test
