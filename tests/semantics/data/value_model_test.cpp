// SPDX-License-Identifier: Apache-2.0
// Tests the values of value models. Every region of a fine grid contains a value, and every region with several points
// contains two.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "semantics/data/value_model.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "tests/rounds.hpp"
#include "tests/semantics/lower/lowering_fixture.hpp"

namespace robochart::ir {
namespace {

std::optional<ValueModel> values_of(const std::string& type, const std::string& guard,
                                    const std::vector<Cut>& cuts = {}) {
    const auto lowered = samples::lower_text(
        fmt::format("stm S {{ event e : {0} event o : {0} var x : {0} initial i state A {{ }} junction k transition t0 "
                    "{{ from i to A }} transition t1 {{ from A to k trigger e ? x }} transition t2 {{ from k to A "
                    "condition {1} action o!x }} }}",
                    type, guard));
    diagnostics::Diagnostics found;
    const Instantiation instantiation = instantiate_system(lowered->system, {}, found);
    return value_model(lowered->system, instantiation, {MachineId{0}}, cuts);
}

/// Returns the signs of the cuts at a value. `unit` is the number of units of one number of the value.
std::vector<int> signs_at(const std::vector<Cut>& cuts, const std::vector<std::int64_t>& value, std::int64_t unit) {
    std::vector<int> result;
    for (const Cut& cut : cuts) {
        std::int64_t sum = cut.constant;
        for (std::size_t i = 0; i < value.size(); ++i) sum += cut.coefficients[i] * value[i] * unit;
        result.push_back((sum > 0 ? 1 : 0) - (sum < 0 ? 1 : 0));
    }
    return result;
}

/// Compares the values with the points of a grid from -6 to 6, in steps of a quarter for reals.
void expect_regions(const ValueModel& model, bool whole) {
    ASSERT_EQ(model.types.size(), 1U);
    const auto& values = model.types.front().values;
    const std::int64_t unit = whole ? model.scale : 1;
    std::map<std::vector<int>, std::size_t> found;
    for (const auto& value : values) ++found[signs_at(model.cuts, value, unit)];
    const std::int64_t step = whole ? 1 : model.scale / 4;
    const std::int64_t edge = whole ? 6 : 6 * model.scale;
    std::map<std::vector<int>, std::size_t> expected;
    for (std::int64_t one = -edge; one <= edge; one += step) {
        if (values.front().size() == 1) ++expected[signs_at(model.cuts, {one}, unit)];
        for (std::int64_t two = -edge; values.front().size() == 2 && two <= edge; two += step)
            ++expected[signs_at(model.cuts, {one, two}, unit)];
    }
    for (const auto& [signs, points] : expected) EXPECT_GE(found[signs], std::min<std::size_t>(points, 2));
}

TEST(ValueModels, EveryRegionHasTwoValues) {
    for (const auto& [type, guard] : {std::pair("real", "x < 2.5"),
                                      {"real", "x > 1.0 /\\ x <= 1.25"},
                                      {"int", "x >= 3 /\\ x < 5"},
                                      {"int", "x == 2"},
                                      {"real * real", "x[1] < x[2]"},
                                      {"real * real", "x[1] + x[2] > 1.5 \\/ x[1] == 2.0"}}) {
        const auto model = values_of(type, guard);
        ASSERT_TRUE(model) << guard;
        SCOPED_TRACE(guard);
        expect_regions(*model, std::string(type) == "int");
    }
}

/// Returns the sign of a cut at a sequence, or 2 if the sequence has no place in the window.
int sign_at(const Cut& cut, const std::vector<std::int64_t>& sequence) {
    const auto length = static_cast<std::int64_t>(sequence.size());
    std::vector<std::int64_t> numbers{length};
    if (cut.window) {
        numbers.clear();
        for (const std::int64_t place : cut.window->places)
            if (place <= length) numbers.push_back(sequence[static_cast<std::size_t>(place - 1)]);
        if (numbers.empty()) return 2;
    }
    const auto [least, greatest] = std::ranges::minmax(numbers);
    const bool upper = cut.window && cut.window->greatest;
    const std::int64_t sum = cut.constant + cut.coefficients.front() * (upper ? greatest : least);
    return (sum > 0 ? 1 : 0) - (sum < 0 ? 1 : 0);
}

std::optional<ValueModel> sequence_values(const std::string& type, const std::string& guard,
                                          const std::vector<Cut>& cuts = {}) {
    const auto lowered = samples::lower_text(
        fmt::format("import sequence_toolkit::*\nimport set_toolkit::*\nimport relation_toolkit::*\n"
                    "stm S {{ event e : Seq({0}) event o var x : Seq({0}) initial i state A {{ }} junction k "
                    "transition t0 {{ from i to A }} transition t1 {{ from A to k trigger e ? x }} "
                    "transition t2 {{ from k to A condition {1} action o }} }}",
                    type, guard));
    diagnostics::Diagnostics found;
    const Instantiation instantiation = instantiate_system(lowered->system, {}, found);
    return value_model(lowered->system, instantiation, {MachineId{0}}, cuts);
}

/// Checks sequences of up to six items from a grid. Each one is in the region of two explored sequences, or is the
/// empty sequence.
void expect_regions_of_sequences(const ValueModel& model, bool whole) {
    ASSERT_EQ(model.types.size(), 1U);
    const auto signs = [&](const std::vector<std::int64_t>& sequence) {
        std::vector<int> result;
        for (const Cut& cut : model.cuts) result.push_back(sign_at(cut, sequence));
        return result;
    };
    std::map<std::vector<int>, std::size_t> found;
    for (const auto& value : model.types.front().values) ++found[signs(value)];
    std::mt19937 random(20261130);
    for (int sample = 0; sample < 20'000; ++sample) {
        std::vector<std::int64_t> sequence(random() % 7);
        for (std::int64_t& item : sequence)
            item = whole ? static_cast<std::int64_t>(random() % 7)
                         : static_cast<std::int64_t>(random() % 9) * model.scale / 4;
        // A sequence of thresholds may be the only sequence of its region.
        const bool alone = std::ranges::all_of(sequence, [&](std::int64_t item) {
            return std::ranges::any_of(model.cuts, [&](const Cut& cut) { return cut.window && cut.constant == -item; });
        });
        ASSERT_GE(found[signs(sequence)], alone ? 1U : 2U) << fmt::format("{}", fmt::join(sequence, " "));
    }
}

TEST(ValueModels, EveryRegionOfSequencesHasTwoValues) {
    const char* near = "min(ran(extract([2, 3], x))) < 0.5";
    for (const std::string& guard :
         {std::string(near), std::string(near) + " /\\ not (min(ran(extract([3, 5], x))) < 0.5)",
          std::string("size(x) == 4 /\\ max(ran(extract([1, 2], x))) >= 1.5"), std::string("size(x) > 2"),
          std::string(near) + " /\\ not (min(ran(x)) < 0.5)", std::string("max(ran(x)) > 1.0 /\\ size(x) == 3")}) {
        SCOPED_TRACE(guard);
        const auto model = sequence_values("real", guard);
        ASSERT_TRUE(model);
        expect_regions_of_sequences(*model, false);
    }
    const auto whole = sequence_values("nat", "min(ran(extract([1, 2], x))) > 3");
    ASSERT_TRUE(whole);
    expect_regions_of_sequences(*whole, true);
}

TEST(ValueModels, WindowsOfTheCodeDivideSequences) {
    const auto first = sequence_values("real", "min(ran(extract([2, 3], x))) < 0.5");
    ASSERT_TRUE(first);
    const Cut shifted{first->types.front().type, {1}, -first->scale, SequenceWindow{{1, 2}, false}};
    const auto second = sequence_values("real", "min(ran(extract([2, 3], x))) < 0.5", {shifted});
    ASSERT_TRUE(second);
    EXPECT_GT(second->types.front().values.size(), first->types.front().values.size());
    EXPECT_NE(std::ranges::find(second->cuts, shifted), second->cuts.end());
    expect_regions_of_sequences(*second, false);
}

/// Code can build only the empty sequence, and no window reads single items.
TEST(ValueModels, OtherUsesOfSequencesHaveNone) {
    EXPECT_FALSE(sequence_values("real", "x[2] < 0.5"));
    EXPECT_FALSE(sequence_values("real", "x == <1.0>"));
    EXPECT_FALSE(sequence_values("real", "min(ran(extract([1, 2], x))) < 0.5 /\\ max(ran(extract([1, 2], x))) > 0.5"));
}

/// Place 4,096 represents all places after it, so only the window of all places has it.
TEST(ValueModels, WindowsOfTheFirst4095PlacesAreDivided) {
    EXPECT_TRUE(sequence_values("real", "min(ran(extract([4000, 4095], x))) < 0.5"));
    EXPECT_FALSE(sequence_values("real", "min(ran(extract([4000, 4096], x))) < 0.5"));
    EXPECT_FALSE(sequence_values("real", "min(ran(extract([1, 4096], x))) < 0.5"));
    const auto whole = sequence_values("real", "min(ran(x)) < 0.5");
    ASSERT_TRUE(whole);
    for (const auto& value : whole->types.front().values) EXPECT_LE(value.size(), 3U) << "few items represent all";
}

TEST(ValueModels, CutsDivideRegions) {
    const auto first = values_of("real", "x < 2.5");
    ASSERT_TRUE(first);
    const Cut cut = normalized({first->types.front().type, {-2}, 7 * first->scale});  // x = 3.5
    const auto finer = values_of("real", "x < 2.5", {cut});
    ASSERT_TRUE(finer);
    EXPECT_TRUE(std::ranges::binary_search(finer->cuts, cut));
    expect_regions(*finer, false);
    const auto& values = finer->types.front().values;
    EXPECT_NE(std::ranges::find(values, std::vector<std::int64_t>{finer->scale * 7 / 2}), values.end());
}

TEST(ValueModels, RandomConditions) {
    std::mt19937_64 random(29);
    const char* const relations[] = {"<", "<=", ">", ">=", "==", "!="};
    const auto number = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
    const auto place = [&](std::size_t size) {
        return std::uniform_int_distribution<std::size_t>(0, size - 1)(random);
    };
    for (std::size_t round = 0; round < tests::rounds(20); ++round) {
        const std::string left[] = {"x[1]", "x[2]", "x[1] + x[2]", "x[1] - x[2]"};
        std::string guard;
        for (int i = 0; i < 2; ++i)
            guard +=
                fmt::format("{}{} {} {}", i == 0 ? "" : " /\\ ", left[place(4)], relations[place(6)], number(-3, 3));
        const auto model = values_of("real * real", guard);
        ASSERT_TRUE(model) << guard;
        SCOPED_TRACE(guard);
        expect_regions(*model, false);
    }
}

}  // namespace
}  // namespace robochart::ir
