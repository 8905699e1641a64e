// SPDX-License-Identifier: Apache-2.0
// Tests conformance for all values (docs/conformance.md, "All values"). The mutants are faults in the conditions of
// generated code. All mutants of a model are compiled together, and a variable of the object selects one. The test also
// computes without the search whether a mutant differs from the original, with points on, between and beyond all
// thresholds.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <regex>

#include "conformance/check/conform.hpp"
#include "conformance/code/tracked_code.hpp"
#include "cpp_emit/emit.hpp"
#include "cpp_emit/load/shared_library.hpp"
#include "cpp_emit/plan/exploration_ports.hpp"
#include "cpp_emit/plan/resolve_component.hpp"
#include "tests/conformance/bench.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::conformance::all_values_test {
namespace {

using NumberList = std::vector<std::int64_t>;

/// The faults that can be selected at each comparison.
enum ConditionFault : int {
    boundary,
    constant_up,
    constant_down,
    extra_above,
    extra_below,
    other_number,
    direction,
    fault_kinds
};

/// Text that precedes the core: a comparison with the number `site`, which the variable robochart_mutant may make
/// faulty.
constexpr const char* faulty_comparison = R"(
extern "C" { __attribute__((visibility("default"))) int robochart_mutant = -1; }
namespace mutants {
enum { less, less_equal, greater, greater_equal, equal, not_equal };
template <class T>
bool holds(T a, int op, T b) {
    switch (op) {
        case less: return a < b;
        case less_equal: return a <= b;
        case greater: return a > b;
        case greater_equal: return a >= b;
        case equal: return a == b;
        default: return a != b;
    }
}
template <class T>
bool compared(int site, T a, int op, T b, T other, T step) {
    const int kind = robochart_mutant >= 0 && robochart_mutant / 7 == site ? robochart_mutant % 7 : -1;
    switch (kind) {
        case 0: return holds(a, op ^ 1, b);
        case 1: return holds(a, op, b + step);
        case 2: return holds(a, op, b - step);
        case 3: return holds(a, op, b) || a > T(1000);
        case 4: return holds(a, op, b) && !(a < T(-1000));
        case 5: return holds(other, op, b);
        case 6: return holds(a, op ^ 2, b);
        default: return holds(a, op, b);
    }
}
/// `a < Bound{b}` with a fault.
template <class T>
struct Bound { T value; };
template <class T>
bool operator<(T a, Bound<T> b) {
    switch (robochart_mutant) {
        case -10: return a <= b.value;
        case -11: return a < b.value + T(0.25);
        case -12: return a < b.value - T(0.25);
        case -13: return a < b.value || a > T(1000);
        case -14: return a < b.value && !(a < T(-1000));
        default: return a < b.value;
    }
}
inline int one_less(int mutant) { return robochart_mutant == mutant ? -1 : 0; }
inline int one_more(int mutant) { return robochart_mutant == mutant ? 1 : 0; }
}
)";
static_assert(fault_kinds == 7, "robochart_mutant is 7 * site + kind");

/// Returns the generated code with a call of `compared` in place of every comparison in a guard.
std::string with_faults(const std::string& core, int& sites) {
    static const std::regex comparison(
        R"((state_\.[\w.]+) (<|<=|>|>=|==|!=) ((?:Real|Int)\(-?[\d.]+\)|state_\.[\w.]+))");
    const std::map<std::string, std::string> names{{"<", "less"},           {"<=", "less_equal"}, {">", "greater"},
                                                   {">=", "greater_equal"}, {"==", "equal"},      {"!=", "not_equal"}};
    std::string result;
    std::string rest = core;
    std::smatch found;
    while (std::regex_search(rest, found, comparison)) {
        const std::string left = found[1], right = found[3];
        std::string other = left;
        if (const std::size_t at = other.find("item_1"); at != std::string::npos)
            other.replace(at, 6, "item_2");
        else if (const std::size_t second = other.find("item_2"); second != std::string::npos)
            other.replace(second, 6, "item_1");
        else
            other = left + " + " + left;
        const std::string type = right.starts_with("Int") ? "Int" : "Real";
        result += found.prefix();
        result += fmt::format("mutants::compared<{}>({}, {}, mutants::{}, {}, {}, {})", type, sites++, left,
                              names.at(found[2]), right, other, type == "Int" ? "Int(1)" : "Real(0.25)");
        rest = found.suffix();
    }
    const std::string text = result + rest;
    const std::size_t at = text.find("\nnamespace ");
    return text.substr(0, at) + faulty_comparison + text.substr(at);
}

/// Replaces a line of the core by faulty ones. The variable selects them by numbers that no comparison uses.
struct Replacement {
    std::string from, to;
};

/// The compiled code of a machine with all its mutants.
class Mutants {
public:
    Mutants(const std::string& text, const std::string& machine, std::vector<Replacement> replacements = {})
        : folder_(text),
          model_(folder_.path()),
          component_(model_.machine_named(machine)),
          replacements_(std::move(replacements)) {
        timed_ = timed_model(model_.system, model_.instantiation, model_.sources, model_.diagnostics);
        const auto resolved =
            cpp_emit::resolve_component(model_.system, model_.instantiation, component_, model_.diagnostics);
        types_ = cpp_emit::tracked_types(model_.system, *resolved);
        const auto values = ir::value_model(model_.system, model_.instantiation, {ir::MachineId{0}}, {});
        EXPECT_TRUE(values.has_value()) << machine;
        if (!values) return;
        scale_ = values->scale;
        compile();
    }

    [[nodiscard]] bool is_compiled() const { return code_ != nullptr; }
    [[nodiscard]] int count() const { return sites_ * fault_kinds; }
    [[nodiscard]] std::int64_t scale() const { return scale_; }
    void select(int mutant) { *selected_ = mutant; }
    ForAllValues judge() { return judge_for_all_values(timed_, component_, *code_, {}, {}); }

    /// Returns what the selected mutant does with each of these values in a few cycles.
    std::vector<std::string> behaviours(const std::vector<NumberList>& values) {
        NumberList numbers;
        for (const NumberList& value : values) numbers.insert(numbers.end(), value.begin(), value.end());
        EXPECT_EQ(code_->tracking->types, 1U);
        EXPECT_NE(code_->tracking->set_values(0, static_cast<std::uint32_t>(values.size()), numbers.data()), 0U);
        std::vector<std::string> result;
        for (std::uint32_t v = 0; v < values.size(); ++v) result.push_back(behaviour(v));
        return result;
    }

    /// Returns what the selected mutant does over doubles with each of these sequences, in the first cycle that
    /// receives it.
    std::vector<std::string> on_robot(const std::vector<std::vector<double>>& sequences) {
        const rc_deployed& robot = *code_->tracking->deployed;
        NumberList numbers;
        for (const std::vector<double>& sequence : sequences) {
            numbers.push_back(static_cast<std::int64_t>(sequence.size()));
            for (const double number : sequence) numbers.push_back(std::bit_cast<std::int64_t>(number));
        }
        robot.set_values(0, static_cast<std::uint32_t>(sequences.size()), numbers.data());
        std::vector<std::string> result;
        for (std::uint32_t v = 0; v < sequences.size(); ++v) {
            std::vector<unsigned char> state(robot.state_size);
            robot.initial(state.data());
            std::vector<rc_record> records(64);
            rc_log log{};
            log.capacity = static_cast<std::uint32_t>(records.size());
            log.record = records.data();
            for (const std::uint32_t present : {0U, 1U}) {
                const std::vector<rc_register> registers(code_->inputs, rc_register{present, v});
                EXPECT_EQ(robot.step(state.data(), registers.data(), &log), RC_QUIESCENT);
            }
            std::string text;
            for (std::uint32_t r = 0; r < log.count; ++r) text += fmt::format("{} ", records[r].argument[0]);
            result.push_back(std::move(text));
        }
        return result;
    }

private:
    void compile() {
        cpp_emit::Options options;
        options.tracked_scale = scale_;
        cpp_emit::Emission emission =
            cpp_emit::emit(timed_.model.system, timed_.model.instantiation, component_, options, model_.diagnostics);
        for (cpp_emit::OutputFile& file : emission.files)
            if (file.path.ends_with("_core.hpp")) file.text = with_replacements(with_faults(file.text, sites_));
        const cpp_emit::BuildOptions build{"c++", "-std=c++17 -O0 -w -fno-exceptions -fno-rtti", ""};
        std::string error;
        library_ = cpp_emit::SharedLibrary::build(emission.files, {emission.shim}, build, error);
        EXPECT_TRUE(library_) << error;
        if (!library_) return;
        selected_ = static_cast<int*>(library_->find_symbol("robochart_mutant"));
        code_ = reinterpret_cast<const rc_interface* (*)()>(library_->find_symbol("robochart_explore"))();
    }

    [[nodiscard]] std::string with_replacements(std::string text) const {
        for (const auto& [from, to] : replacements_) {
            const std::size_t at = text.find(from);
            EXPECT_NE(at, std::string::npos) << from;
            if (at != std::string::npos) text.replace(at, from.size(), to);
        }
        return text;
    }

    /// Runs three cycles: the first without inputs, then with the value in every register, then only with events
    /// without values.
    std::string behaviour(std::uint32_t value) {
        std::vector<unsigned char> state(code_->state_size);
        code_->initial(state.data());
        std::vector<rc_record> records(64);
        rc_log log{};
        log.capacity = static_cast<std::uint32_t>(records.size());
        log.record = records.data();
        std::string text;
        for (int cycle = 0; cycle < 3; ++cycle) {
            std::vector<rc_register> registers(code_->inputs);
            for (std::uint32_t i = 0; i < code_->inputs; ++i) {
                const bool carries = code_->tracking->input[i] >= 0;
                registers[i] = {cycle == (carries ? 1 : 2) ? 1U : 0U, carries ? value : 0U};
            }
            text += fmt::format("{}:", static_cast<int>(code_->step(state.data(), registers.data(), &log)));
            for (std::uint32_t r = 0; r < log.count; ++r)
                text += fmt::format(" {}({})", records[r].output, records[r].count == 0 ? 0 : records[r].argument[0]);
        }
        return text;
    }

    test::ModelFolder folder_;
    test::Model model_;
    ir::ComponentRef component_;
    std::vector<Replacement> replacements_;
    TimedModel timed_;
    std::vector<ir::TypeId> types_;
    std::int64_t scale_ = 1;
    int sites_ = 0;
    std::unique_ptr<cpp_emit::SharedLibrary> library_;
    const rc_interface* code_ = nullptr;
    int* selected_ = nullptr;
};

constexpr const char* thermostat = R"(
interface Plant { heat() cool() rest() }
stm Thermostat {
	event degrees : real
	event shown : real
	requires Plant
	var t : real
	initial i
	state Resting { entry rest() }
	state Heating { entry heat() }
	state Cooling { entry cool() ; shown!t }
	junction k
	transition t0 { from i to Resting }
	transition t1 { from Resting to k trigger degrees?t }
	transition t2 { from Heating to k trigger degrees?t }
	transition t3 { from Cooling to k trigger degrees?t }
	transition t4 { from k to Heating condition t < 19.5 }
	transition t5 { from k to Cooling condition t > 21.25 }
	transition t6 { from k to Resting condition t >= 19.5 /\ t <= 21.25 }
}
)";

constexpr const char* valve = R"(
interface Plant { open() shut() rest() }
stm Valve {
	event level : int
	event tick
	requires Plant
	var v : int
	initial i
	state Low { entry rest() }
	state High { entry open() }
	junction k
	junction m
	transition t0 { from i to Low }
	transition t1 { from Low to k trigger level?v }
	transition t2 { from k to High condition v > 3 }
	transition t3 { from k to Low condition v <= 3 }
	transition t4 { from High to m trigger tick }
	transition t5 { from m to Low condition v == 7 action shut() }
	transition t6 { from m to Low condition v != 7 }
}
)";

constexpr const char* planner = R"(
enumeration Turn { both left_ right_ apart other }
stm Planner {
	event gap : real * real
	event turn : Turn
	var a : real * real
	initial i
	state Waiting { }
	junction k
	transition t0 { from i to Waiting }
	transition t1 { from Waiting to k trigger gap?a }
	transition t2 { from k to Waiting condition a[1] > 0 /\ a[2] > 0 action turn!Turn::both }
	transition t3 { from k to Waiting condition a[1] <= 0 /\ a[2] > 1.0 action turn!Turn::left_ }
	transition t4 { from k to Waiting condition a[1] > 0 /\ a[2] <= 0 action turn!Turn::right_ }
	transition t5 { from k to Waiting condition a[1] <= 0 /\ a[2] <= 0 /\ a[1] == a[2] action turn!Turn::apart }
	transition t6 { from k to Waiting condition a[1] <= 0 /\ a[2] <= 1.0 /\ a[1] != a[2] action turn!Turn::other }
}
)";

/// Returns each threshold plus each of the distances in `beside`, in units of 1/scale.
NumberList around(const std::vector<double>& thresholds, std::int64_t scale, const std::vector<double>& beside) {
    NumberList result;
    for (const double threshold : thresholds)
        for (const double distance : beside)
            result.push_back(std::llround((threshold + distance) * static_cast<double>(scale)));
    std::ranges::sort(result);
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

std::vector<NumberList> pairs_of(const NumberList& numbers, std::size_t parts) {
    std::vector<NumberList> result;
    for (const std::int64_t one : numbers) {
        if (parts == 1) result.push_back({one});
        for (std::size_t i = 0; parts == 2 && i < numbers.size(); ++i) result.push_back({one, numbers[i]});
    }
    return result;
}

struct MutantCase {
    const char* name;
    const char* text;
    const char* machine;
    bool whole;
    std::size_t parts;
    std::vector<double> thresholds;
    std::vector<double> beside;
    std::vector<std::vector<double>> witnesses;  ///< one value of each class of the model
    friend std::ostream& operator<<(std::ostream& out, const MutantCase& shown) { return out << shown.name; }
};

class AllValues : public testing::TestWithParam<MutantCase> {};

TEST_P(AllValues, EveryFaultyConditionIsFoundOrEquivalent) {
    const MutantCase& given = GetParam();
    Mutants mutants(given.text, given.machine);
    ASSERT_TRUE(mutants.is_compiled());
    const std::int64_t unit = given.whole ? 1 : mutants.scale();
    const auto points = pairs_of(around(given.thresholds, unit, given.beside), given.parts);
    std::vector<NumberList> witnesses;
    for (const auto& witness : given.witnesses) {
        NumberList& numbers = witnesses.emplace_back();
        for (const double number : witness) numbers.push_back(std::llround(number * static_cast<double>(unit)));
    }
    mutants.select(-1);
    const auto expected = mutants.behaviours(points);
    const auto few_expected = mutants.behaviours(witnesses);
    const ForAllValues original = mutants.judge();
    ASSERT_TRUE(original.result) << original.reason;
    ASSERT_EQ(original.result->outcome, Outcome::conforms) << original.result->reason;
    int killed = 0, survivors = 0;
    for (int mutant = 0; mutant < mutants.count(); ++mutant) {
        SCOPED_TRACE(fmt::format("comparison {}, fault {}", mutant / fault_kinds, mutant % fault_kinds));
        mutants.select(mutant);
        const bool differs = mutants.behaviours(points) != expected;
        const bool differs_in_witnesses = mutants.behaviours(witnesses) != few_expected;
        const ForAllValues judged = mutants.judge();
        ASSERT_TRUE(judged.result) << judged.reason;
        EXPECT_EQ(judged.result->outcome, differs ? Outcome::differs : Outcome::conforms) << judged.result->reason;
        if (differs) ++killed;
        if (differs && !differs_in_witnesses) ++survivors;
    }
    RecordProperty("mutants", mutants.count());
    RecordProperty("killed", killed);
    RecordProperty("survivors", survivors);
    EXPECT_GE(mutants.count(), 28);
    EXPECT_GE(killed, mutants.count() / 3);
    EXPECT_GE(survivors, 3) << "one value of each class of the model would find as much";
}

const std::vector<double> near_reals{-0.375, -0.25, -0.125, 0, 0.125, 0.25, 0.375};

INSTANTIATE_TEST_SUITE_P(
    Models, AllValues,
    testing::Values(
        MutantCase{"Thermostat",
                   thermostat,
                   "Thermostat",
                   false,
                   1,
                   {-1000, 0, 9.75, 10.625, 19.5, 21.25, 1000},
                   near_reals,
                   {{18}, {20}, {22}}},
        MutantCase{
            "Valve", valve, "Valve", true, 1, {-1000, 0, 3, 7, 1000}, {-4, -3, -2, -1, 0, 1, 2}, {{0}, {5}, {7}}},
        MutantCase{"Planner",
                   planner,
                   "Planner",
                   false,
                   2,
                   {-1000, 0, 1, 1000},
                   near_reals,
                   {{1, 1}, {-1, 2}, {1, -1}, {-1, -1}, {-2, -1}, {0, 0.5}}}),
    [](const auto& tested) { return std::string(tested.param.name); });

constexpr const char* scanner = R"(
import sequence_toolkit::*
import set_toolkit::*
import relation_toolkit::*
enumeration Side { ahead left_ long_ }
stm Scanner {
	event scan : Seq(real)
	event seen : Side
	var ranges : Seq(real)
	initial i
	state Waiting { }
	junction which
	transition t0 { from i to Waiting }
	transition t1 { from Waiting to which trigger scan?ranges }
	transition t2 { from which to Waiting condition min(ran(extract([2, 3], ranges))) < 0.5 action seen!Side::ahead }
	transition t3 { from which to Waiting condition not (min(ran(extract([2, 3], ranges))) < 0.5) /\
		min(ran(extract([4, 6], ranges))) < 0.5 action seen!Side::left_ }
	transition t4 { from which to Waiting condition size(ranges) > 7 /\ not (min(ran(extract([2, 3], ranges))) < 0.5) /\
		not (min(ran(extract([4, 6], ranges))) < 0.5) action seen!Side::long_ }
	transition t5 { from which to Waiting condition size(ranges) < 2 }
}
)";

/// The faults are in the first condition: in its bound, and in the places of its window. A faulty window is in the test
/// that the window contains a number, in the least number, or in both. A sequence is written as its length, followed by
/// its numbers in units of 1/scale.
TEST(AllValuesOfSequences, EveryFaultyWindowIsFound) {
    const std::string window = "Interval<Nat>(Nat(2), Nat(3))";
    Mutants mutants(scanner, "Scanner",
                    {{window, "Interval<Nat>(Nat(2 + mutants::one_less(-20) + mutants::one_more(-21)), Nat(3))"},
                     {window,
                      "Interval<Nat>(Nat(2 + mutants::one_less(-22) + mutants::one_more(-23)), "
                      "Nat(3 + mutants::one_less(-24) + mutants::one_more(-25)))"},
                     {"< Real(0.5)", "< mutants::Bound<Real>{Real(0.5)}"},
                     {"> Nat(7)", "> Nat(7 + mutants::one_less(-30) + mutants::one_more(-31))"}});
    ASSERT_TRUE(mutants.is_compiled());
    const ForAllValues original = mutants.judge();
    ASSERT_TRUE(original.result) << original.reason;
    ASSERT_EQ(original.result->outcome, Outcome::conforms) << original.result->reason;
    ASSERT_EQ(original.result->all_values.size(), 1U);
    EXPECT_TRUE(original.result->all_values.front().all_values);
    const std::vector<std::vector<double>> one_of_each_class{{},
                                                             {9},
                                                             {9, 0.25},
                                                             {9, 0.75},
                                                             {9, 0.25, 9, 0.25},
                                                             {9, 0.25, 9, 0.75},
                                                             {9, 0.75, 9, 0.25},
                                                             {9, 0.75, 9, 0.75},
                                                             {9, 0.75, 9, 0.75, 9, 9, 9, 9}};
    std::vector<NumberList> witnesses;
    for (const auto& witness : one_of_each_class) {
        NumberList& numbers = witnesses.emplace_back(NumberList{static_cast<std::int64_t>(witness.size())});
        for (const double number : witness)
            numbers.push_back(std::llround(number * static_cast<double>(mutants.scale())));
    }
    const auto expected = mutants.behaviours(witnesses);
    int survivors = 0;
    for (const int mutant : {-10, -11, -12, -13, -14, -20, -21, -22, -23, -24, -25, -30, -31}) {
        SCOPED_TRACE(mutant);
        mutants.select(mutant);
        const ForAllValues judged = mutants.judge();
        ASSERT_TRUE(judged.result) << judged.reason;
        EXPECT_EQ(judged.result->outcome, Outcome::differs);
        if (mutants.behaviours(witnesses) == expected) ++survivors;
    }
    EXPECT_GE(survivors, 3) << "one value of each class of the model would find as much";
}

constexpr const char* bumper = R"(
import sequence_toolkit::*
import set_toolkit::*
import relation_toolkit::*
enumeration Side { far near ahead }
stm Bumper {
	event scan : Seq(real)
	event seen : Side
	var ranges : Seq(real)
	initial i
	state Waiting { }
	junction which
	transition t0 { from i to Waiting }
	transition t1 { from Waiting to which trigger scan?ranges }
	transition t2 { from which to Waiting condition min(ran(ranges)) >= 0.5 action seen!Side::far }
	transition t3 { from which to Waiting condition min(ran(ranges)) < 0.5 /\
		not (min(ran(extract([2, 3], ranges))) < 0.5) action seen!Side::near }
	transition t4 { from which to Waiting condition min(ran(extract([2, 3], ranges))) < 0.5 action seen!Side::ahead }
	transition t5 { from which to Waiting condition size(ranges) < 2 }
}
)";

/// The first two faults overlook items after the ninth, or the first one. The next one takes an empty scan for a far
/// one, and the last one exchanges the least number for the greatest.
TEST(AllValuesOfSequences, TheLeastNumberOfAWholeSequenceIsDecided) {
    const std::string least = "robochart::view::min<Real>(robochart::view::items(local_ranges.value)) >= Real(0.5)";
    const std::string items = "robochart::view::items(local_ranges.value)";
    const auto window = [&](const char* first, const char* last) {
        return "robochart::view::min<Real>(robochart::view::extract(robochart::view::Interval<Nat>(Nat(" +
               std::string(first) + "), Nat(" + last + ")), " + items + ")) >= Real(0.5)";
    };
    Mutants mutants(
        bumper, "Bumper",
        {{"!robochart::view::empty(" + items + ") && " + least,
          "(robochart_mutant == -22 && robochart::view::empty(" + items + ")) || (!robochart::view::empty(" + items +
              ") && (robochart_mutant == -20 ? " + window("1", "9") + " : robochart_mutant == -21 ? " +
              window("2", "4095") + " : robochart_mutant == -23 ? robochart::view::max<Real>(" + items +
              ") >= Real(0.5) : " + least + "))"}});
    ASSERT_TRUE(mutants.is_compiled());
    const ForAllValues original = mutants.judge();
    ASSERT_TRUE(original.result) << original.reason;
    ASSERT_EQ(original.result->outcome, Outcome::conforms) << original.result->reason;
    ASSERT_EQ(original.result->all_values.size(), 1U);
    EXPECT_TRUE(original.result->all_values.front().all_values);
    for (const int mutant : {-20, -21, -22, -23}) {
        SCOPED_TRACE(mutant);
        mutants.select(mutant);
        const ForAllValues judged = mutants.judge();
        ASSERT_TRUE(judged.result) << judged.reason;
        EXPECT_EQ(judged.result->outcome, Outcome::differs);
    }
}

/// Returns the literals of Side that the scanner sends for this scan, computed in the RoboChart semantics with the
/// exact values of the doubles.
std::string side_seen(const std::vector<double>& scan) {
    const auto least = [&](std::size_t first, std::size_t last) -> std::optional<double> {
        std::optional<double> result;
        for (std::size_t place = first; place <= last && place <= scan.size(); ++place)
            result = std::min(scan[place - 1], result.value_or(scan[place - 1]));
        return result;
    };
    const std::optional<double> ahead = least(2, 3), left = least(4, 6);
    if (!ahead) return "";
    if (*ahead < 0.5) return "0 ";
    if (!left) return "";
    if (*left < 0.5) return "1 ";
    return scan.size() > 7 ? "2 " : "";
}

/// Returns scans of all lengths up to 9. In the places 1 to 4 they have all combinations of `numbers`.
std::vector<std::vector<double>> scans_of(const std::vector<double>& numbers) {
    std::vector<std::vector<double>> result;
    const std::size_t base = numbers.size();
    for (std::size_t length = 0; length <= 9; ++length)
        for (std::size_t combination = 0; combination < base * base * base * base; ++combination) {
            std::vector<double> scan(length, numbers.back());
            std::size_t rest = combination;
            for (std::size_t place = 0; place < std::min<std::size_t>(length, 4); ++place, rest /= base)
                scan[place] = numbers[rest % base];
            result.push_back(std::move(scan));
        }
    return result;
}

/// The verdict about all sequences is also true of the code over doubles. At the boundary, and at the doubles next to
/// it, code without a fault answers as the model does. Each fault that the verdict finds gives another answer for some
/// scan. With numbers that are not next to the boundary, two of these faults are not visible.
TEST(AllValuesOfSequences, AreThoseOfDoublesBesideTheBoundary) {
    Mutants mutants(
        scanner, "Scanner",
        {{"Interval<Nat>(Nat(2), Nat(3))",
          "Interval<Nat>(Nat(2 + mutants::one_less(-20) + mutants::one_more(-21)), Nat(3))"},
         {"Interval<Nat>(Nat(2), Nat(3))",
          "Interval<Nat>(Nat(2 + mutants::one_less(-22) + mutants::one_more(-23)), "
          "Nat(3 + mutants::one_less(-24) + mutants::one_more(-25) + "
          "(std::is_floating_point_v<Real> ? mutants::one_less(-50) : 0)))"},
         {"< Real(0.5)", "< mutants::Bound<Real>{robochart_mutant == -40 ? Real(1.1) - Real(0.6) : Real(0.5)}"}});
    ASSERT_TRUE(mutants.is_compiled());
    const double below = std::nextafter(0.5, 0.0), above = std::nextafter(0.5, 1.0);
    const auto scans = scans_of({below, 0.5, -0.0, above}), far = scans_of({0.25, 0.75});
    mutants.select(-1);
    const auto expected = mutants.on_robot(scans), expected_far = mutants.on_robot(far);
    for (std::size_t i = 0; i < scans.size(); ++i) ASSERT_EQ(expected[i], side_seen(scans[i])) << i;
    int unseen = 0;
    for (const int mutant : {-10, -11, -12, -22, -23, -24, -25}) {
        SCOPED_TRACE(mutant);
        mutants.select(mutant);
        EXPECT_NE(mutants.on_robot(scans), expected);
        if (mutants.on_robot(far) == expected_far) ++unseen;
        const ForAllValues judged = mutants.judge();
        ASSERT_TRUE(judged.result) << judged.reason;
        EXPECT_EQ(judged.result->outcome, Outcome::differs);
    }
    EXPECT_GE(unseen, 2);
    // The last fault is only in the code with doubles. 1.1 - 0.6 is 0.5, but over doubles the result is the double
    // above 0.5. The check runs this code too.
    for (const int mutant : {-40, -50}) {
        SCOPED_TRACE(mutant);
        mutants.select(mutant);
        const ForAllValues judged = mutants.judge();
        ASSERT_TRUE(judged.result) << judged.reason;
        EXPECT_EQ(judged.result->outcome, Outcome::rounds);
    }
    mutants.select(-40);
    const auto rounded = mutants.on_robot(scans);
    std::size_t differences = 0;
    for (std::size_t i = 0; i < scans.size(); ++i)
        if (rounded[i] != expected[i]) {
            ++differences;
            EXPECT_EQ(std::ranges::count(scans[i], 0.5) > 0, true) << i;
        }
    EXPECT_GT(differences, 0U);
}

constexpr const char* delay = R"(
stm Delay {
	event put : real
	event echo : real
	var x : real
	var y : real
	initial i
	state S { }
	transition t0 { from i to S }
	transition t1 { from S to S trigger put?x action echo!y ; y = x }
}
)";

/// The check distinguishes an older input, a newer one and a constant, although no condition reads the values.
TEST(AllValuesOfCopies, EveryOtherValueIsFound) {
    Mutants mutants(delay, "Delay",
                    {{"platform_.send_echo(state_.y)",
                      "platform_.send_echo(robochart_mutant == 1 ? state_.x : robochart_mutant == 2 ? Real(0.0) : "
                      "robochart_mutant == 3 ? state_.y + state_.x - state_.x : state_.y)"}});
    ASSERT_TRUE(mutants.is_compiled());
    const ForAllValues original = mutants.judge();
    ASSERT_TRUE(original.result) << original.reason;
    EXPECT_EQ(original.result->outcome, Outcome::conforms) << original.result->reason;
    ASSERT_EQ(original.result->all_values.size(), 1U);
    EXPECT_TRUE(original.result->all_values.front().nothing_tested);
    for (const int mutant : {1, 2}) {
        mutants.select(mutant);
        const ForAllValues judged = mutants.judge();
        ASSERT_TRUE(judged.result) << judged.reason;
        EXPECT_EQ(judged.result->outcome, Outcome::differs);
    }
    mutants.select(3);
    EXPECT_FALSE(mutants.judge().result) << "the sum of two inputs is no form of one input";
}

/// If the code does more with values than copy and compare them, the verdict stays open.
TEST(AllValuesOfCopies, OtherUsesAreNotDecided) {
    Mutants mutants(thermostat, "Thermostat",
                    {{"state_.t = inputs_.degrees.get();",
                      "{ const Real old = state_.t; state_.t = inputs_.degrees.get();"
                      "bool used = robochart_mutant == -2 && old < state_.t;"
                      "used = used || (robochart_mutant == -3 && state_.t * state_.t > Real(4.0));"
                      "used = used || (robochart_mutant == -4 && duration(state_.t) > 3); }"}});
    ASSERT_TRUE(mutants.is_compiled());
    const std::pair<int, const char*> uses[] = {{-2, "the code compares two inputs with each other"},
                                                {-3, "the code computes with inputs"},
                                                {-4, "an index, a duration or a loop of the code depends on an input"}};
    for (const auto& [mutant, reason] : uses) {
        mutants.select(mutant);
        const ForAllValues judged = mutants.judge();
        EXPECT_FALSE(judged.result) << mutant;
        EXPECT_EQ(judged.reason, reason);
    }
    mutants.select(-1);
    EXPECT_TRUE(mutants.judge().result);
}

/// A literal may have more decimals than the unit of the model. It is not rounded to a threshold of the model.
TEST(AllValuesOfCopies, LiteralsAreNotRounded) {
    Mutants mutants(thermostat, "Thermostat",
                    {{"state_.t = inputs_.degrees.get();",
                      "{ state_.t = inputs_.degrees.get();"
                      "if (robochart_mutant == -2 && state_.t > Real(19.500000001)) robochart_mutant = -2; }"}});
    ASSERT_TRUE(mutants.is_compiled());
    EXPECT_TRUE(mutants.judge().result);
    mutants.select(-2);
    const ForAllValues judged = mutants.judge();
    EXPECT_FALSE(judged.result);
    EXPECT_TRUE(judged.code_tests_values);
}

constexpr const char* gauge = R"(
interface Plant { open() shut() }
stm Gauge {
	event level : int
	requires Plant
	var v : int
	initial i
	state S { }
	junction k
	transition t0 { from i to S }
	transition t1 { from S to k trigger level?v }
	transition t2 { from k to S condition v > 1000.1234 action open() }
	transition t3 { from k to S condition v <= 1000.1234 action shut() }
}
)";

/// The code compares a whole number as a real one. The threshold 1200.5 in units, multiplied by the units of the
/// compared form, does not fit into 64 bits.
TEST(AllValuesOfCopies, WholeNumbersComparedAsRealsHaveTheirThresholds) {
    Mutants mutants(
        gauge, "Gauge",
        {{"Real(state_.v) > Real(1000.1234)",
          "(Real(state_.v) > Real(1000.1234) && !(robochart_mutant == 1 && Real(state_.v) > Real(1200.5)))"}});
    ASSERT_TRUE(mutants.is_compiled());
    const ForAllValues original = mutants.judge();
    ASSERT_TRUE(original.result) << original.reason;
    EXPECT_EQ(original.result->outcome, Outcome::conforms) << original.result->reason;
    mutants.select(1);
    const ForAllValues judged = mutants.judge();
    ASSERT_TRUE(judged.result) << judged.reason;
    EXPECT_EQ(judged.result->outcome, Outcome::differs);
}

/// The points of one period do not represent all values, whether the conditions read all parts of a value or not.
TEST(AllValuesOfModels, RemaindersKeepTheirCarriers) {
    for (const auto& [type, read] : {std::pair("int", "x"), std::pair("int * int", "x[1]")}) {
        test::ModelFolder folder(fmt::format(
            "stm M {{ event a : {} var x : {} initial i state S {{ }} state T {{ }} transition t0 {{ from i to S }} "
            "transition t1 {{ from S to S trigger a?x }} transition t2 {{ from S to T condition {} % 3 == 1 }} }}",
            type, type, read));
        test::Model model(folder.path());
        EXPECT_FALSE(ir::value_model(model.system, model.instantiation, {ir::MachineId{0}}, {})) << type;
    }
}

/// Computed data, and variables that are compared with each other, keep their carriers.
TEST(AllValuesOfModels, ComputedDataKeepTheirCarriers) {
    for (const char* condition : {"x < y", "x + y > 1.0", "x * x > 4.0", "x - x > since(C)"}) {
        test::ModelFolder folder(fmt::format(
            "stm M {{ clock C event a : real event b : real var x : real var y : real initial i state S {{ }} state T "
            "{{ }} transition t0 {{ from i to S }} transition t1 {{ from S to S trigger a?x }} transition t2 {{ from S "
            "to S trigger b?y }} transition t3 {{ from S to T condition {} }} }}",
            condition));
        test::Model model(folder.path());
        EXPECT_FALSE(ir::value_model(model.system, model.instantiation, {ir::MachineId{0}}, {})) << condition;
    }
}

/// Uses the models of the reference suite that the default carriers cannot decide.
TEST(AllValuesOfModels, TheSuiteConforms) {
    const std::filesystem::path suite = tests::shared_folder() / "suite/data";
    if (!std::filesystem::exists(suite)) GTEST_SKIP() << "no shared data";
    for (const auto& [name, classes] : {std::pair("hysteresis", 3U), {"two_reals", 13U}, {"later_guard", 3U}}) {
        test::Model model((suite / name).string());
        Options options;
        options.numbers = Numbers::all;
        const ir::Machine& machine = model.system.machines.at(0);
        const Result result = conform(model.system, model.instantiation, model.machine_named(machine.name), options,
                                      model.sources, model.diagnostics);
        EXPECT_EQ(result.outcome, Outcome::conforms) << name << ": " << result.reason;
        ASSERT_EQ(result.all_values.size(), 1U) << name << ": " << result.not_for_all;
        EXPECT_EQ(result.all_values.front().classes, classes) << name;
    }
}

}  // namespace
}  // namespace robochart::conformance::all_values_test
