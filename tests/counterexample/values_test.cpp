// SPDX-License-Identifier: Apache-2.0
// Tests that values of the script are shown in the notation of the model.
#include "counterexample/values.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace robochart::runs {
namespace {

using ::testing::ElementsAre;

class Values : public ::testing::Test {
protected:
    Values() { instantiation.scale = 100; }

    ir::TypeId add(ir::TypeKind kind, std::vector<ir::TypeId> args = {}, std::vector<std::string> labels = {}) {
        ir::Type type;
        type.kind = kind;
        type.args = std::move(args);
        type.labels = std::move(labels);
        system.types.push_back(type);
        return ir::TypeId{static_cast<std::uint32_t>(system.types.size() - 1)};
    }
    [[nodiscard]] std::string text(ir::TypeId type, const std::string& value) const {
        return value_text(system, instantiation, type, value);
    }

    ir::System system;
    ir::Instantiation instantiation;
};

TEST_F(Values, RealsAreDecimals) {
    const ir::TypeId real = add(ir::TypeKind::real);
    EXPECT_EQ(text(real, "-1088"), "-10.88");
    EXPECT_EQ(text(real, "-5"), "-0.05");
    EXPECT_EQ(text(real, "150"), "1.5");
    EXPECT_EQ(text(real, "-200"), "-2");
    EXPECT_EQ(text(add(ir::TypeKind::nat), "150"), "150");
}

TEST_F(Values, LiteralsLoseTheNameOfTheirType) {
    const ir::TypeId real = add(ir::TypeKind::real);
    const ir::TypeId colour = add(ir::TypeKind::enumeration, {}, {"green", "light_green", "mixed"});
    system.types[colour.index].literal_args = {{}, {}, {real, colour}};
    EXPECT_EQ(text(colour, "P_Colour_light_green"), "light_green");
    EXPECT_EQ(text(colour, "Colour_green"), "green");
    EXPECT_EQ(text(colour, "Colour_mixed.50.Colour_green"), "mixed(0.5, green)");
}

TEST_F(Values, PartsAreValuesOfTheirTypes) {
    const ir::TypeId real = add(ir::TypeKind::real);
    const ir::TypeId word = add(ir::TypeKind::string);
    EXPECT_EQ(text(add(ir::TypeKind::sequence, {real}), "<50, -25>"), "<0.5, -0.25>");
    EXPECT_EQ(text(add(ir::TypeKind::set, {real}), "{}"), "{}");
    EXPECT_EQ(text(add(ir::TypeKind::record, {real, word}, {"x", "name"}), "(50, \"a, (b\")"),
              " (| x = 0.5, name = \"a, (b\" |)");
    EXPECT_EQ(text(add(ir::TypeKind::record, {real}, {"x"}), "50"), " (| x = 0.5 |)");
    EXPECT_EQ(text(add(ir::TypeKind::product, {real, word}), "(50, \"a\")"), "(0.5, \"a\")");
    EXPECT_EQ(text(add(ir::TypeKind::function, {word, real}), "{(\"a\", 50)}"), "{(\"a\", 0.5)}");
}

TEST_F(Values, AnEventsValuesTakeTheDotsOfTheirTypes) {
    const ir::TypeId real = add(ir::TypeKind::real);
    const ir::TypeId shape = add(ir::TypeKind::enumeration, {}, {"dot", "circle"});
    system.types[shape.index].literal_args = {{}, {real}};
    const auto values = values_of_event(system, instantiation, {shape, real}, "Shape_circle.150.25");
    std::vector<std::string> texts;
    for (const Value& value : values) texts.push_back(value.text);
    EXPECT_THAT(texts, ElementsAre("circle(1.5)", "0.25"));
    EXPECT_TRUE(values_of_event(system, instantiation, {}, "").empty());
}

TEST(Split, LeavesBracketsAndQuotesAlone) {
    EXPECT_THAT(split_outside_brackets("a,(b,c),<d,e>,\"f,)\"", ","), ElementsAre("a", "(b,c)", "<d,e>", "\"f,)\""));
    EXPECT_THAT(split_outside_brackets("A(1) ‖ B", "‖"), ElementsAre("A(1) ", " B"));
}

}  // namespace
}  // namespace robochart::runs
