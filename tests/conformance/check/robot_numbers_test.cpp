// SPDX-License-Identifier: Apache-2.0
// Tests code with the numbers of the robot (docs/conformance.md, "Numbers on the robot"). The expected answers follow
// from doubles, which the comments state to 20 digits.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <regex>
#include <set>
#include <tuple>

#include "conformance/check/conform.hpp"
#include "conformance/check/numbers_to_try.hpp"
#include "conformance/model/rules.hpp"
#include "cpp_emit/emit.hpp"
#include "cpp_emit/load/shared_library.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance::robot_numbers_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Text that precedes the core: a literal of deployed code, which the variable robochart_mutant makes one ulp greater
/// (even) or less (odd).
constexpr const char* changed_literal = R"(
#include <cmath>
extern "C" { __attribute__((visibility("default"))) int robochart_mutant = -1; }
template <class Real>
Real robot_literal(int site, double value) {
    if constexpr (std::is_floating_point_v<Real>)
        if (robochart_mutant >= 0 && robochart_mutant / 2 == site)
            return std::nextafter(value, robochart_mutant % 2 == 0 ? 1e9 : -1e9);
    return Real(value);
}
)";

/// The code of the machine M, with tracked numbers and with the numbers of the robot.
class Machine {
public:
    explicit Machine(const std::string& text, std::size_t tracked_length = 100)
        : folder_(text), model_(folder_.path()) {
        component_ = model_.machine_named("M");
        timed_ = timed_model(model_.system, model_.instantiation, model_.sources, model_.diagnostics);
        const auto values = ir::value_model(model_.system, model_.instantiation, {ir::MachineId{0}}, {});
        EXPECT_TRUE(values.has_value());
        cpp_emit::Options options;
        options.tracked_scale = values ? values->scale : 1;
        options.tracked_length = tracked_length;
        cpp_emit::Emission emission =
            cpp_emit::emit(timed_.model.system, timed_.model.instantiation, component_, options, model_.diagnostics);
        for (cpp_emit::OutputFile& file : emission.files)
            if (file.path.ends_with("_core.hpp")) file.text = with_literals(file.text);
        std::string error;
        library_ = cpp_emit::SharedLibrary::build(emission.files, {emission.shim},
                                                  {"c++", "-std=c++17 -O0 -w -fno-exceptions -fno-rtti", ""}, error);
        EXPECT_TRUE(library_) << error;
    }

    [[nodiscard]] int literals() const { return literals_; }
    void select(int mutant) { *static_cast<int*>(library_->find_symbol("robochart_mutant")) = mutant; }
    [[nodiscard]] Result judge(const Options& options = {}) const {
        const auto* const code =
            reinterpret_cast<const rc_interface* (*)()>(library_->find_symbol("robochart_explore"))();
        ForAllValues found = judge_for_all_values(timed_, component_, *code, options, {});
        EXPECT_TRUE(found.result) << found.reason;
        return found.result.value_or(Result());
    }

private:
    std::string with_literals(const std::string& core) {
        static const std::regex literal(R"(Real\((0\.[1-9]\d*)\))");
        std::string result, rest = core;
        std::smatch found;
        while (std::regex_search(rest, found, literal)) {
            result += found.prefix();
            result += fmt::format("robot_literal<Real>({}, {})", literals_++, found[1].str());
            rest = found.suffix();
        }
        const std::string text = result + rest;
        const std::size_t at = text.find("\nnamespace ");
        return text.substr(0, at) + changed_literal + text.substr(at);
    }

    test::ModelFolder folder_;
    test::Model model_;
    ir::ComponentRef component_;
    TimedModel timed_;
    int literals_ = 0;
    std::unique_ptr<cpp_emit::SharedLibrary> library_;
};

/// Returns a machine that heats if the condition is true for its input.
std::string heater(const std::string& type, const std::string& condition) {
    return fmt::format(R"(
interface Plant {{ heat() }}
stm M {{
	event degrees : {0}
	requires Plant
	var x : {0}
	initial i
	state Waiting {{ }}
	junction k
	transition t0 {{ from i to Waiting }}
	transition t1 {{ from Waiting to k trigger degrees ? x }}
	transition t2 {{ from k to Waiting condition {1} action heat() }}
	transition t3 {{ from k to Waiting condition not ({1}) }}
}}
)",
                       type, condition);
}

/// 0.1 is the double 0.10000000000000000555, 0.2 is 0.20000000000000001110, 0.3 is 0.29999999999999998890, and the next
/// double is 0.30000000000000004441. The exact sum of 0.1 and 0.2 is 0.30000000000000001665, in the middle between the
/// last two. The last bit of the greater one is 0, so the sum of doubles is greater than 0.3.
TEST(RobotNumbers, ASumOfDecimalsIsRoundedUp) {
    const Machine machine(heater("real", "x + 0.1 <= 0.3"));
    const Result result = machine.judge();
    ASSERT_EQ(result.outcome, Outcome::rounds) << result.reason;
    EXPECT_EQ(result.reason,
              "`x + 0.1 <= 0.3` is true for 0.2, but false in the code, which compares 0.30000000000000004 with 0.3");
    EXPECT_EQ(result.explanation.rule, &rules::rounded);
    EXPECT_THAT(result.explanation.where, ElementsAre(HasSubstr("model.rct:12"), HasSubstr("model.rct:13")));
    ASSERT_EQ(result.cycles.size(), 1U);
    EXPECT_THAT(result.cycles.front().inputs, ElementsAre("degrees = 0.2"));
    EXPECT_THAT(result.cycles.front().outputs, IsEmpty());
    EXPECT_THAT(result.expected, HasSubstr("out <heat()>"));

    Options allowed;
    allowed.rounding_allowed = true;
    const Result accepted = machine.judge(allowed);
    EXPECT_EQ(accepted.outcome, Outcome::conforms);
    ASSERT_TRUE(accepted.robot);
    EXPECT_EQ(accepted.robot->difference, result.reason);
    EXPECT_THAT(accepted.cycles, IsEmpty());
}

/// The double before 0.2 is 0.19999999999999998335. Its exact sum with 0.1 is 0.29999999999999998890, which is the
/// double 0.3 in the comparison of the code. The sum with the model's 0.1 is less than the model's 0.3. No code with
/// doubles avoids this difference, so it is reported, but the code conforms.
TEST(RobotNumbers, ADoubleBesideTheBoundaryReachesIt) {
    const Machine machine(heater("real", "x + 0.1 < 0.3"));
    const Result result = machine.judge();
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    ASSERT_TRUE(result.robot);
    EXPECT_EQ(result.robot->difference,
              "`x + 0.1 < 0.3` is true for 0.19999999999999998, but false in the code, which compares 0.3 with 0.3");
}

/// The product does not fit into int64, so the code takes the first operand, 2 (docs/cpp.md, "Numbers at their
/// limits"). The check reports the number, but not as a difference caused by rounding.
TEST(RobotNumbers, LimitsOfIntegersAreReportedApart) {
    const Machine machine(heater("int", "2 * x > 10"));
    const Result result = machine.judge();
    ASSERT_EQ(result.outcome, Outcome::conforms) << result.reason;
    ASSERT_TRUE(result.robot);
    std::map<std::string, std::vector<std::string>> unlike;
    for (const RobotNumbers::Special& special : result.robot->special) {
        EXPECT_TRUE(special.limit);
        unlike[special.value] = special.unlike;
    }
    ASSERT_EQ(unlike.size(), 2U);
    EXPECT_THAT(unlike.at("9223372036854775807"), ElementsAre("degrees"));
    EXPECT_THAT(unlike.at("-9223372036854775808"), IsEmpty()) << "2 is not greater than 10, either";
}

constexpr const char* thermostat = R"(
interface Plant { heat() cool() rest() }
stm M {
	event degrees : real
	event tick
	requires Plant
	var t : real
	initial i
	state Resting { entry rest() }
	state Heating { entry heat() }
	state Cooling { entry cool() }
	junction k
	transition t0 { from i to Resting }
	transition t1 { from Resting to k trigger degrees?t }
	transition t2 { from Heating to k trigger degrees?t }
	transition t3 { from Cooling to Resting trigger tick condition t >= 0.7 }
	transition t4 { from k to Heating condition t < 0.1 }
	transition t5 { from k to Cooling condition t > 0.3 }
	transition t6 { from k to Resting condition t >= 0.1 /\ t <= 0.3 }
}
)";

/// 0.1, 0.3 and 0.7 are not doubles. Rounding to the nearest double keeps the order of numbers, so a number and a
/// literal compare as in the model. NaN is neither less than 0.1 nor greater than 0.3 nor between them, so the machine
/// stays at the junction. An infinity behaves like a great number, and -0.0 like 0.
TEST(RobotNumbers, LiteralsThatAreNoDoublesMakeNoDifference) {
    const Machine machine(thermostat);
    const Result result = machine.judge();
    ASSERT_EQ(result.outcome, Outcome::conforms) << result.reason;
    ASSERT_TRUE(result.robot);
    EXPECT_EQ(result.robot->limit, "");
    EXPECT_EQ(result.robot->regions, 7U);  // three thresholds, and four intervals
    // The check tries one number on each threshold. In each interval it tries two explored numbers, 16 random ones, and
    // the next doubles at the boundaries, which are six in all. The initial value 0 is in the first interval.
    EXPECT_EQ(result.robot->numbers, 3U + 4U * (2U + 16U) + 6U + 1U);
    std::map<std::string, std::vector<std::string>> unlike;
    for (const RobotNumbers::Special& special : result.robot->special) unlike[special.value] = special.unlike;
    EXPECT_THAT(unlike.at("nan"), ElementsAre("degrees"));
    for (const char* value : {"inf", "-inf", "-0", "1.7976931348623157e+308", "-1.7976931348623157e+308"})
        EXPECT_THAT(unlike.at(value), IsEmpty()) << value;
    EXPECT_EQ(unlike.size(), 6U);
}

/// With `not (t < c)` in place of the other conditions, NaN behaves like a number between the thresholds.
TEST(RobotNumbers, NaNIsLikeANumberWhereNegationsDecide) {
    const Machine machine(heater("real", "x < 0.1"));
    const Result result = machine.judge();
    ASSERT_TRUE(result.robot);
    ASSERT_FALSE(result.robot->special.empty());
    EXPECT_EQ(result.robot->special.front().value, "nan");
    EXPECT_THAT(result.robot->special.front().unlike, IsEmpty());
}

/// Each change of a literal moves a threshold, or the double next to it, to the other side. The machine then does
/// something else or stays at the junction. `t >= 0.1` with the double before 0.1, and `t <= 0.3` with the double after
/// 0.3, have no effect, because t4 and t5 come first. The change of t3 is only visible in a later cycle than the one
/// that receives the number.
TEST(RobotNumbers, ALiteralThatIsOneUlpWrongIsFound) {
    Machine machine(thermostat);
    constexpr auto same = Outcome::conforms, other = Outcome::rounds;
    const std::vector<std::pair<Outcome, Outcome>> expected{
        {same, same},    // t >= 0.7 in `dispatch`, which a cycle does not call
        {other, other},  // t < 0.1
        {other, other},  // t > 0.3
        {other, same},   // t >= 0.1
        {same, other},   // t <= 0.3
        {other, other},  // t >= 0.7
    };
    ASSERT_EQ(machine.literals(), static_cast<int>(expected.size()));
    for (int literal = 0; literal < machine.literals(); ++literal) {
        const auto& [greater, less] = expected[static_cast<std::size_t>(literal)];
        machine.select(2 * literal);
        EXPECT_EQ(machine.judge().outcome, greater) << literal;
        machine.select(2 * literal + 1);
        EXPECT_EQ(machine.judge().outcome, less) << literal;
    }
    machine.select(-1);
    EXPECT_EQ(machine.judge().outcome, Outcome::conforms);
}

constexpr const char* detector = R"(
import sequence_toolkit::*
import set_toolkit::*
import relation_toolkit::*
interface Plant { heat() cool() }
stm M {
	event scan : Seq(real)
	event tick
	requires Plant
	var s : Seq(real)
	initial i
	state Waiting { }
	state Near { }
	junction k
	transition t0 { from i to Waiting }
	transition t1 { from Waiting to k trigger scan ? s }
	transition t2 { from k to Near condition min(ran(extract([2, 3], s))) < 0.3 action heat() }
	transition t3 { from k to Waiting condition min(ran(extract([2, 3], s))) >= 0.3 action cool() }
	transition t4 { from k to Waiting condition size(s) < 2 }
	transition t5 { from Near to Waiting trigger tick condition min(ran(extract([70, 90], s))) <= 0.7 }
}
)";

/// Code with doubles is run with sequences up to the greatest place of a window, which is beyond the usual capacity. A
/// window ignores NaN if it contains another number. If it does not, no transition leaves the junction.
TEST(RobotNumbers, SequencesAreRunOverDoubles) {
    const Machine machine(detector);
    const Result result = machine.judge();
    ASSERT_EQ(result.outcome, Outcome::conforms) << result.reason;
    ASSERT_TRUE(result.robot);
    EXPECT_EQ(result.robot->limit, "");
    EXPECT_EQ(result.robot->difference, "");
    std::map<std::string, std::vector<std::string>> unlike;
    for (const RobotNumbers::Special& special : result.robot->special) unlike[special.value] = special.unlike;
    EXPECT_THAT(unlike.at("nan"), ElementsAre("scan"));
    for (const char* value : {"inf", "-inf", "-0"}) EXPECT_THAT(unlike.at(value), IsEmpty()) << value;
}

/// As for numbers: `>= 0.3` with the double before 0.3 has no effect, because t2 comes first. The change of t5 is only
/// visible in a later cycle.
TEST(RobotNumbers, AThresholdOfAWindowThatIsOneUlpWrongIsFound) {
    Machine machine(detector);
    constexpr auto same = Outcome::conforms, other = Outcome::rounds;
    const std::vector<std::pair<Outcome, Outcome>> expected{
        {same, same},    // min(...) <= 0.7 in `dispatch`, which a cycle does not call
        {other, other},  // min(...) < 0.3
        {other, same},   // min(...) >= 0.3
        {other, other},  // min(...) <= 0.7
    };
    ASSERT_EQ(machine.literals(), static_cast<int>(expected.size()));
    for (int literal = 0; literal < machine.literals(); ++literal) {
        const auto& [greater, less] = expected[static_cast<std::size_t>(literal)];
        machine.select(2 * literal);
        EXPECT_EQ(machine.judge().outcome, greater) << literal;
        machine.select(2 * literal + 1);
        EXPECT_EQ(machine.judge().outcome, less) << literal;
    }
}

/// Code that has no place for the explored sequences refuses them, so the check does not run it.
TEST(RobotNumbers, SequencesBeyondTheCapacityAreNotRun) {
    const Machine machine(detector, 0);
    const Result result = machine.judge();
    ASSERT_EQ(result.outcome, Outcome::conforms) << result.reason;
    ASSERT_TRUE(result.robot);
    EXPECT_THAT(result.robot->limit, HasSubstr("no place for sequences of"));
}

TriedNumber itself(double number) {
    return {std::bit_cast<std::int64_t>(number), std::nullopt};
}

TEST(NumbersToTry, SignsAreExact) {
    const ir::NumberPart first{{0}, ir::TypeKind::real}, second{{1}, ir::TypeKind::real};
    const ir::NumberPart whole{{}, ir::TypeKind::integer};
    constexpr double greatest = std::numeric_limits<double>::max();
    constexpr double least = std::numeric_limits<double>::denorm_min();
    const ir::TypeId type{0};
    const NumberSpace one{{first}, {}, 10}, two{{first, second}, {}, 10}, wholes{{whole}, {}, 10};
    const ir::Cut tenth{type, {1}, -1}, multiple{type, {1'048'575}, 0}, sum{type, {1, 1}, -10}, order{type, {1, -1}, 0};
    // The double 0.1 is 0.10000000000000000555, and the one before it is less than 0.1.
    EXPECT_EQ(sign_of(one, tenth, {itself(0.1)}), 1);
    EXPECT_EQ(sign_of(one, tenth, {itself(std::nextafter(0.1, 0.0))}), -1);
    EXPECT_EQ(sign_of(one, tenth, {nearest_number(one, first, 1)}), 0);
    EXPECT_EQ(sign_of(one, tenth, {itself(0.0)}), -1);
    EXPECT_EQ(sign_of(one, multiple, {itself(greatest)}), 1);
    EXPECT_EQ(sign_of(one, multiple, {itself(-greatest)}), -1);
    EXPECT_EQ(sign_of(one, multiple, {itself(least)}), 1);
    EXPECT_EQ(sign_of(one, multiple, {itself(-3 * least)}), -1);
    EXPECT_EQ(sign_of(one, multiple, {itself(-0.0)}), 0);
    // 0.29999999999999998890 + 0.69999999999999995559 < 1, although the sum of the doubles is 1.
    EXPECT_EQ(sign_of(two, sum, {itself(0.3), itself(0.7)}), -1);
    EXPECT_EQ(sign_of(two, sum, {nearest_number(two, first, 3), nearest_number(two, second, 7)}), 0);
    EXPECT_EQ(sign_of(two, order, {itself(greatest), itself(std::nextafter(greatest, 0.0))}), 1);
    EXPECT_EQ(sign_of(two, order, {itself(greatest), itself(least)}), 1);
    EXPECT_EQ(sign_of(two, order, {itself(least), itself(greatest)}), -1);
    const ir::Cut thrice{type, {3}, -100};
    EXPECT_EQ(sign_of(wholes, thrice, {{3, std::nullopt}}), -1);  // 3 * 3 < 10
    EXPECT_EQ(sign_of(wholes, thrice, {{4, std::nullopt}}), 1);
    EXPECT_EQ(sign_of(wholes, thrice, {{std::numeric_limits<std::int64_t>::max(), std::nullopt}}), 1);
    EXPECT_EQ(sign_of(wholes, thrice, {{std::numeric_limits<std::int64_t>::min(), std::nullopt}}), -1);
}

/// A window has no sign if it contains no place of the sequence. Otherwise its least number, or its greatest, decides.
TEST(NumbersToTry, SignsOfWindowsAreExact) {
    const ir::NumberPart part{{}, ir::TypeKind::real};
    const ir::TypeId type{0};
    const NumberSpace space{{part}, {}, 10, true};
    const ir::Cut least{type, {1}, -1, ir::SequenceWindow{{2, 3}, false}};
    const ir::Cut greatest{type, {1}, -1, ir::SequenceWindow{{2, 3}, true}};
    const ir::Cut reversed{type, {-1}, 1, ir::SequenceWindow{{2, 3}, false}};
    const ir::Cut size{type, {2}, -3};
    const TriedNumber tenth = nearest_number(space, part, 1), one = nearest_number(space, part, 10);
    const TriedNumber above = itself(0.1), below = itself(std::nextafter(0.1, 0.0));
    const TriedNumber huge = itself(std::numeric_limits<double>::max());
    const std::vector<std::tuple<TriedValue, int, int, int, int>> expected{
        {{}, 2, 2, 2, -1},
        {{below}, 2, 2, 2, -1},
        {{below, one}, 1, 1, -1, 1},
        {{below, tenth}, 0, 0, 0, 1},
        {{below, above}, 1, 1, -1, 1},
        {{below, one, below}, -1, 1, 1, 1},
        {{one, tenth, above, below}, 0, 1, 0, 1},
        {{one, tenth, below}, -1, 0, 1, 1},
        {{one, huge, itself(-0.0)}, -1, 1, 1, 1},
    };
    for (const auto& [sequence, of_least, of_greatest, of_reversed, of_size] : expected) {
        SCOPED_TRACE(value_text(space, sequence));
        EXPECT_EQ(sign_of(space, least, sequence), of_least);
        EXPECT_EQ(sign_of(space, greatest, sequence), of_greatest);
        EXPECT_EQ(sign_of(space, reversed, sequence), of_reversed);
        EXPECT_EQ(sign_of(space, size, sequence), of_size);
    }
    // The window of all places reads every item of a longer sequence; a window up to place 4095 does not.
    ir::Cut whole{type, {1}, -1, ir::SequenceWindow{std::vector<std::int64_t>(ir::last_place), false}};
    std::iota(whole.window->places.begin(), whole.window->places.end(), std::int64_t{1});
    TriedValue longer(5000, one);
    longer[4500] = below;
    EXPECT_EQ(sign_of(space, whole, longer), -1);
    whole.window->places.pop_back();
    EXPECT_EQ(sign_of(space, whole, longer), 1);
    EXPECT_EQ(value_text(space, {one, tenth, tenth, tenth, below}), "<1, 3 times 0.1, 0.09999999999999999>");
}

/// The window contains the places 2 and 3, and the threshold is 0.3.
TEST(NumbersToTry, TheDoublesAroundTheThresholdOfAWindowAreTried) {
    const ir::NumberPart part{{}, ir::TypeKind::real};
    const ir::TypeId type{0};
    const NumberSpace space{{part}, {{type, {1}, -3, ir::SequenceWindow{{2, 3}, false}}, {type, {2}, -3}}, 10, true, 5};
    const ir::ExploredValues explored{type, {{}, {9}, {9, 2, 2}, {8, 1, 1}, {9, 3, 3}, {9, 4, 4}, {8, 5, 5}}, 1};
    diagnostics::Unlimited budget;
    const std::vector<TriedRegion> regions = numbers_to_try(space, explored, 16, budget);
    ASSERT_EQ(regions.size(), 4U);
    EXPECT_THAT(regions[0].places, ElementsAre(0U, 1U));
    EXPECT_THAT(regions[1].places, ElementsAre(2U, 3U));
    EXPECT_THAT(regions[2].places, ElementsAre(4U));
    EXPECT_THAT(regions[3].places, ElementsAre(5U, 6U));
    EXPECT_TRUE(regions[2].boundary);
    EXPECT_FALSE(regions[0].boundary);
    const TriedNumber nine = nearest_number(space, part, 9), exact = nearest_number(space, part, 3);
    const TriedNumber below = itself(std::nextafter(0.3, 0.0)), above = itself(std::nextafter(0.3, 1.0));
    const auto contains = [&](const TriedRegion& region, const TriedValue& sequence) {
        return std::ranges::any_of(region.values, [&](const TriedValue& value) {
            return std::ranges::equal(value, sequence, {}, &TriedNumber::bits, &TriedNumber::bits);
        });
    };
    EXPECT_TRUE(contains(regions[1], {nine, below, exact}));
    EXPECT_TRUE(contains(regions[1], {nine, exact, below}));
    EXPECT_TRUE(contains(regions[1], {nine, below, below}));
    EXPECT_TRUE(contains(regions[2], {nine, above, exact}));
    EXPECT_TRUE(contains(regions[3], {nine, above, above}));
    for (const TriedRegion& region : regions) {
        EXPECT_GT(region.values.size(), region.places.size());
        std::set<std::size_t> lengths;
        for (const TriedValue& value : region.values) {
            lengths.insert(value.size());
            for (const ir::Cut& cut : space.cuts)
                EXPECT_EQ(sign_of(space, cut, value), sign_of(space, cut, region.values.front()));
        }
        EXPECT_LE(*lengths.rbegin(), 5U);
        EXPECT_GE(lengths.size(), 2U);
    }
}

/// Of the doubles around the threshold 0.1, only the double 0.1 represents the threshold, although it is greater.
TEST(NumbersToTry, TheDoublesAroundAThresholdAreTried) {
    const ir::NumberPart part{{}, ir::TypeKind::real};
    const NumberSpace space{{part}, {{ir::TypeId{0}, {1}, -1}}, 10};
    const ir::ExploredValues explored{ir::TypeId{0}, {{0}, {-5}, {1}, {3}, {4}}, 1};
    diagnostics::Unlimited budget;
    const std::vector<TriedRegion> regions = numbers_to_try(space, explored, 16, budget);
    ASSERT_EQ(regions.size(), 3U);
    EXPECT_THAT(regions[0].places, ElementsAre(0U, 1U));
    EXPECT_THAT(regions[1].places, ElementsAre(2U));
    EXPECT_THAT(regions[2].places, ElementsAre(3U, 4U));
    const auto contains = [](const TriedRegion& region, double number) {
        return std::ranges::any_of(region.values, [&](const TriedValue& value) {
            return value.front().bits == std::bit_cast<std::int64_t>(number);
        });
    };
    EXPECT_TRUE(contains(regions[0], std::nextafter(0.1, 0.0)));
    EXPECT_TRUE(contains(regions[2], std::nextafter(0.1, 1.0)));
    EXPECT_TRUE(contains(regions[1], 0.1));
    EXPECT_FALSE(contains(regions[2], 0.1));
    EXPECT_EQ(regions[0].values.size(), 2U + 1U + 16U);
    EXPECT_EQ(regions[1].values.size(), 1U);
    EXPECT_EQ(regions[2].values.size(), 2U + 1U + 16U);
    for (const TriedValue& value : regions[0].values) EXPECT_EQ(sign_of(space, space.cuts[0], value), -1);
    for (const TriedValue& value : regions[2].values) EXPECT_EQ(sign_of(space, space.cuts[0], value), 1);
}

}  // namespace
}  // namespace robochart::conformance::robot_numbers_test
