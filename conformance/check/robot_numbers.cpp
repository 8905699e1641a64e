// SPDX-License-Identifier: Apache-2.0
// Tests code with numbers of the robot. The model treats a number like an explored value of the same region, and the
// search has compared the code with the model for this explored value. So a run with other numbers of the same regions
// must have the outputs and states of the explored run, with the other numbers in them.
#include "conformance/check/robot_numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>
#include <numeric>
#include <set>

#include "base/diagnostics/budget.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/text.hpp"
#include "conformance/check/compared_numbers.hpp"
#include "conformance/check/numbers_to_try.hpp"
#include "conformance/model/rules.hpp"

namespace robochart::conformance {

namespace {

constexpr std::size_t random_values = 16;  ///< number of random values of each region
constexpr std::size_t most_cycles = 20'000;
constexpr std::size_t most_bytes = std::size_t{256} << 20U;  ///< of all states of a run

/// The numbers of a run: for each tracked type, the value that replaces each explored value.
using Assignment = std::vector<std::vector<TriedValue>>;

/// A tracked type with the numbers that are tried.
struct TestedType {
    NumberSpace space;
    const ir::ExploredValues* explored = nullptr;
    std::vector<TriedValue> explored_values;
    std::vector<TriedRegion> regions;

    [[nodiscard]] bool is_written(std::size_t place) const { return place < explored->written; }
    /// Returns the explored values of a region whose numbers may be chosen. The model itself writes the others.
    [[nodiscard]] std::vector<std::size_t> free_places(const TriedRegion& region) const {
        std::vector<std::size_t> result;
        std::ranges::copy_if(region.places, std::back_inserter(result),
                             [&](std::size_t place) { return !is_written(place); });
        return result;
    }
};

std::vector<std::int64_t> bits_of(const TriedValue& value) {
    std::vector<std::int64_t> bits;
    for (const TriedNumber& number : value) bits.push_back(number.bits);
    return bits;
}

bool same_signs(const NumberSpace& space, const TriedValue& one, const TriedValue& other) {
    return std::ranges::all_of(
        space.cuts, [&](const ir::Cut& cut) { return sign_of(space, cut, one) == sign_of(space, cut, other); });
}

std::string words_of(rc_result result) {
    if (result == RC_TERMINATED) return ", then terminates";
    if (result == RC_STEP_BOUND) return ", and does not end its cycle";
    if (result == RC_PRECONDITION) return ", then calls outside a precondition";
    if (result == RC_DEADLINE) return ", then misses a deadline";
    return "";
}

/// A value in the report of a comparison. A comparison of a window depends only on the window's number.
std::string text_of(const ir::ModelComparison& comparison, const ComparedNumbers& robot, const NumberSpace& space,
                    const TriedValue& value) {
    if (!comparison.cut) return value_text(space, value);
    return fmt::format("a window with the number {}", comparison.window == 0 ? robot.left : robot.right);
}

class RobotTest {
public:
    RobotTest(const ExploredValuesOfCode& explored, diagnostics::Pollable& budget)
        : explored_(explored), budget_(budget) {}

    void run(Result& result) {
        RobotNumbers& found = result.robot.emplace();
        choose_numbers(found);
        const TrackedCycles cycles = explore_tracked(explored_.code, explored_.interface, most_cycles, budget_);
        if (!cycles.all) found.limit = fmt::format("{} cycles were run with each number", cycles.cycles.size());
        if (!fits(found, cycles)) return;
        PartsOfTypes parts;
        for (const TestedType& type : types_) parts.push_back(type.space.parts);
        DeployedCode code(explored_.code, cycles, parts, explored_.output_types, budget_);
        for (std::size_t round = 0; round < rounds_; ++round) {
            const Assignment numbers = assignment(round);
            const auto deviation = code.first_deviation(tables_of(numbers));
            if (!deviation) continue;
            Result described = result;
            const std::vector<ValuePlace> used = report(described, numbers, cycles, code, *deviation);
            if (!is_inherent(described, numbers, used)) {
                result = std::move(described);
                return;
            }
            if (found.difference.empty()) found.difference = described.reason;
        }
        [[maybe_unused]] const auto again = code.first_deviation(tables_of(assignment(0)));  // the baseline
        assert(!again);
        try_special_values(found, code);
    }

private:
    void choose_numbers(RobotNumbers& found);
    [[nodiscard]] bool fits(RobotNumbers& found, const TrackedCycles& cycles) const;
    [[nodiscard]] Assignment assignment(std::size_t round) const;
    [[nodiscard]] static NumberTables tables_of(const Assignment& numbers);
    /// Reports the difference. Returns the values that the run uses.
    std::vector<ValuePlace> report(Result& result, const Assignment& numbers, const TrackedCycles& cycles,
                                   const DeployedCode& code, const Deviation& deviation) const;
    [[nodiscard]] static bool is_inherent(const Result& described, const Assignment& numbers,
                                          const std::vector<ValuePlace>& used);
    void name_comparisons(Result& result, const Assignment& numbers, const std::vector<ValuePlace>& used) const;
    [[nodiscard]] std::vector<ValuePlace> used_values(const TrackedCycle& cycle) const;
    [[nodiscard]] Interface interface_with(const Assignment& numbers) const;
    void try_special_values(RobotNumbers& found, DeployedCode& code) const;
    void try_special_value(RobotNumbers& found, RobotNumbers::Special special, bool real, std::int64_t bits,
                           DeployedCode& code) const;
    [[nodiscard]] std::set<std::uint32_t> inputs_unlike_numbers(std::uint32_t type, const TriedValue& value, bool limit,
                                                                DeployedCode& code) const;

    const ExploredValuesOfCode& explored_;
    diagnostics::Pollable& budget_;
    std::vector<TestedType> types_;
    std::size_t rounds_ = 1;
};

/// Chooses the numbers of the run. Only values that come from inputs get new numbers; the model writes the others
/// itself.
void RobotTest::choose_numbers(RobotNumbers& found) {
    for (const ir::TypeId type : explored_.types) {
        const auto place = std::ranges::find(explored_.values.types, type, &ir::ExploredValues::type);
        const auto number = static_cast<std::size_t>(place - explored_.values.types.begin());
        TestedType& tested = types_.emplace_back();
        tested.space = number_space(explored_.system, explored_.values, number);
        tested.explored = &*place;
        for (const auto& numbers : place->values)
            tested.explored_values.push_back(nearest_value(tested.space, numbers));
        tested.space.most_items = explored_.code.tracking->deployed->capacity[types_.size() - 1];
        const std::int32_t* const inputs = explored_.code.tracking->input;
        const auto own = static_cast<std::int32_t>(types_.size() - 1);
        if (std::find(inputs, inputs + explored_.code.inputs, own) == inputs + explored_.code.inputs) continue;
        tested.regions = numbers_to_try(tested.space, *place, random_values, budget_);
        found.regions += tested.regions.size();
        for (const TriedRegion& region : tested.regions) {
            const std::size_t free = tested.free_places(region).size();
            found.numbers += free == 0 ? region.places.size() : region.values.size();
            if (free > 0) rounds_ = std::max(rounds_, (region.values.size() + free - 1) / free);
        }
    }
}

/// Whether the code has places for the explored sequences, and the states of a run fit into memory.
bool RobotTest::fits(RobotNumbers& found, const TrackedCycles& cycles) const {
    for (const TestedType& type : types_) {
        const std::size_t longest =
            std::ranges::max(type.explored->values, {}, [](const auto& value) { return value.size(); }).size();
        if (type.space.sequences && longest > type.space.most_items)
            found.limit = fmt::format("the code has no place for sequences of {} items", longest);
    }
    if (cycles.images * std::size_t{explored_.code.tracking->deployed->state_size} > most_bytes)
        found.limit = "the states of the code are too large";
    return found.limit.empty();
}

/// Returns the numbers of a round. Round 0 assigns the explored values themselves, and so do all other rounds for types
/// without inputs. In each round, all free values of a region get further values of this region.
Assignment RobotTest::assignment(std::size_t round) const {
    Assignment result;
    for (const TestedType& type : types_) {
        std::vector<TriedValue>& values = result.emplace_back(type.explored_values);
        for (const TriedRegion& region : type.regions) {
            const std::size_t free = type.free_places(region).size();
            for (std::size_t p = 0; p < region.places.size(); ++p) {
                const bool fixed = type.is_written(region.places[p]);
                const std::size_t chosen = fixed ? p : (p + round * free) % region.values.size();
                values[region.places[p]] = region.values[chosen];
            }
        }
    }
    return result;
}

NumberTables RobotTest::tables_of(const Assignment& numbers) {
    NumberTables tables;
    for (const std::vector<TriedValue>& values : numbers) {
        std::vector<NumbersOfValue>& table = tables.emplace_back();
        for (const TriedValue& value : values) table.push_back(bits_of(value));
    }
    return tables;
}

std::vector<ValuePlace> RobotTest::used_values(const TrackedCycle& cycle) const {
    std::vector<ValuePlace> result;
    for (std::uint32_t i = 0; i < cycle.registers.size(); ++i) {
        const std::int32_t type = explored_.code.tracking->input[i];
        if (type >= 0 && cycle.registers[i].present != 0)
            result.push_back({static_cast<std::uint32_t>(type), cycle.registers[i].value});
    }
    return result;
}

/// Returns the interface with the texts of these numbers in place of those of the explored values.
Interface RobotTest::interface_with(const Assignment& numbers) const {
    Interface interface = explored_.interface;
    const auto set_texts = [&](Carrier& carrier, std::size_t type) {
        for (std::size_t v = 0; v < numbers[type].size() && v < carrier.literals.size(); ++v)
            carrier.literals[v] = value_text(types_[type].space, numbers[type][v]);
    };
    for (std::size_t i = 0; i < interface.inputs.size(); ++i)
        if (const std::int32_t type = explored_.code.tracking->input[i]; type >= 0)
            set_texts(interface.inputs[i].carrier, static_cast<std::size_t>(type));
    for (std::size_t o = 0; o < interface.outputs.size(); ++o)
        for (std::size_t a = 0; a < interface.outputs[o].arguments.size(); ++a)
            if (const auto type = explored_.output_types[o][a]) set_texts(interface.outputs[o].arguments[a], *type);
    return interface;
}

/// Names the comparisons of the model that have another answer in the code for one of the values.
void RobotTest::name_comparisons(Result& result, const Assignment& numbers, const std::vector<ValuePlace>& used) const {
    std::set<std::string> known;
    for (const auto& [type, place] : used) {
        const TestedType& tested = types_[type];
        const TriedValue& value = numbers[type][place];
        for (const ir::ModelComparison& comparison : explored_.values.comparisons) {
            if (comparison.type != tested.explored->type || !comparison.expr->span.is_known()) continue;
            const auto robot = compare_on_robot(explored_.system, comparison, tested.space, value);
            if (!robot) continue;
            const bool answer = answer_in_model(comparison, tested.space, value, place);
            if (robot->answer == answer) continue;
            const diagnostics::Span span = comparison.expr->span;
            const std::string_view source = explored_.sources.source_text(span.source);
            const std::string text = diagnostics::escape_for_display(
                diagnostics::on_one_line(source.substr(span.begin, span.end - span.begin)));
            const std::string where = fmt::format("`{}` ({})", text, explored_.sources.path_and_line(span));
            if (!known.insert(where).second) continue;
            result.explanation.where.push_back(where);
            if (known.size() == 1)
                result.reason = fmt::format("`{}` is {} for {}, but {} in the code, which compares {} with {}", text,
                                            answer, text_of(comparison, *robot, tested.space, value), robot->answer,
                                            robot->left, robot->right);
        }
    }
}

/// Returns whether every implementation with these types has the difference. This is so if a condition of the model has
/// another answer when it is computed with doubles, for a double that is next to a boundary and not a decimal of the
/// model.
bool RobotTest::is_inherent(const Result& described, const Assignment& numbers, const std::vector<ValuePlace>& used) {
    const bool rounded = !described.explanation.where.empty();
    return rounded && std::ranges::any_of(used, [&](const ValuePlace& value) {
               return std::ranges::any_of(numbers[value.type][value.value],
                                          [](const TriedNumber& number) { return !number.units; });
           });
}

std::vector<ValuePlace> RobotTest::report(Result& result, const Assignment& numbers, const TrackedCycles& cycles,
                                          const DeployedCode& code, const Deviation& deviation) const {
    process::EventTable events;
    const Alphabet alphabet(interface_with(numbers), events);
    const auto outputs_of = [&](const std::vector<rc_record>& writes) {
        std::vector<std::string> texts;
        for (const rc_record& record : writes)
            texts.push_back(alphabet.describe_event(
                alphabet.write_event(record.output, {record.argument, record.argument + record.count})));
        return texts;
    };
    std::vector<ValuePlace> used;
    for (const std::size_t number : code.path_to(deviation.cycle)) {
        const TrackedCycle& passed = cycles.cycles[number];
        const std::vector<ValuePlace> values = used_values(passed);
        used.insert(used.begin(), values.begin(), values.end());
        Cycle& cycle = result.cycles.emplace_back();
        for (std::uint32_t i = 0; i < passed.registers.size(); ++i)
            if (passed.registers[i].present != 0)
                cycle.inputs.push_back(alphabet.describe_event(alphabet.read_event(i, passed.registers[i].value + 1)));
        cycle.outputs = outputs_of(number == deviation.cycle ? deviation.writes : passed.writes);
    }
    const TrackedCycle& last = cycles.cycles[deviation.cycle];
    result.cycles.back().state = deviation.state;
    result.outcome = Outcome::rounds;
    result.reason = "with a number of the robot, the code does something else than with the number of the model";
    result.explanation.rule = &rules::rounded;
    result.expected = fmt::format("out <{}>{}", fmt::join(outputs_of(last.writes), ", "), words_of(last.outcome));
    if (!deviation.expected_state.empty()) result.expected += "  " + deviation.expected_state;
    name_comparisons(result, numbers, used);
    return used;
}

void RobotTest::try_special_values(RobotNumbers& found, DeployedCode& code) const {
    using Doubles = std::numeric_limits<double>;
    using Wholes = std::numeric_limits<std::int64_t>;
    for (const double value : {Doubles::quiet_NaN(), Doubles::infinity(), -Doubles::infinity(), -0.0})
        try_special_value(found, {fmt::format("{}", value), false, {}}, true, std::bit_cast<std::int64_t>(value), code);
    for (const double value : {Doubles::max(), Doubles::lowest()})
        try_special_value(found, {fmt::format("{}", value), true, {}}, true, std::bit_cast<std::int64_t>(value), code);
    for (const std::int64_t value : {Wholes::max(), Wholes::min()})
        try_special_value(found, {fmt::format("{}", value), true, {}}, false, value, code);
}

/// Returns the sets of parts that special values replace together: each number alone; for a sequence, the first item of
/// each window, and all items.
std::vector<std::vector<std::size_t>> replaced_parts(const NumberSpace& space, const TriedValue& value) {
    std::set<std::vector<std::size_t>> result;
    if (!space.sequences) {
        for (std::size_t part = 0; part < value.size(); ++part) result.insert({part});
    } else if (!value.empty()) {
        for (const ir::Cut& cut : space.cuts) {
            if (!cut.window || cut.window->places.empty()) continue;
            const auto first = static_cast<std::size_t>(cut.window->places.front() - 1);
            if (first < value.size()) result.insert({first});
        }
        std::vector<std::size_t> all(value.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        result.insert(std::move(all));
    }
    return {result.begin(), result.end()};
}

/// Tries the special value in the parts of a value. The other parts come from each region that is not a boundary.
void RobotTest::try_special_value(RobotNumbers& found, RobotNumbers::Special special, bool real, std::int64_t bits,
                                  DeployedCode& code) const {
    bool possible = false;
    std::set<std::uint32_t> unlike;
    for (std::uint32_t type = 0; type < types_.size(); ++type) {
        const NumberSpace& space = types_[type].space;
        std::set<std::vector<std::int64_t>> tried;
        for (const TriedRegion& region : types_[type].regions) {
            if (region.boundary && (space.sequences || space.parts.size() > 1)) continue;
            for (const std::vector<std::size_t>& parts : replaced_parts(space, region.values.front())) {
                const ir::TypeKind kind = space.part(parts.front()).kind;
                if ((kind == ir::TypeKind::real) != real || (kind == ir::TypeKind::nat && bits < 0)) continue;
                TriedValue value = region.values.front();
                for (const std::size_t part : parts) value[part] = {bits, std::nullopt};
                if (!tried.insert(bits_of(value)).second) continue;
                possible = true;
                unlike.merge(inputs_unlike_numbers(type, value, special.limit, code));
            }
        }
    }
    for (const std::uint32_t input : unlike) special.unlike.push_back(input_name(explored_.interface.inputs[input]));
    if (possible) found.special.push_back(std::move(special));
}

/// Returns the inputs in which the value has effects that no explored value has. An input is not included if an
/// explored value has the same effects in all cycles. For a limit of a type, only explored values in the region of this
/// limit are compared.
std::set<std::uint32_t> RobotTest::inputs_unlike_numbers(std::uint32_t type, const TriedValue& value, bool limit,
                                                         DeployedCode& code) const {
    std::set<std::uint32_t> unlike;
    for (std::uint32_t i = 0; i < explored_.code.inputs; ++i)
        if (explored_.code.tracking->input[i] == static_cast<std::int32_t>(type)) unlike.insert(i);
    const NumberSpace& space = types_[type].space;
    for (const TriedRegion& region : types_[type].regions) {
        if (unlike.empty()) break;
        if (limit && !same_signs(space, value, region.values.front())) continue;
        const std::vector<std::size_t> free = types_[type].free_places(region);
        const ValuePlace place{type, static_cast<std::uint32_t>(free.empty() ? region.places.front() : free.front())};
        std::set<std::uint32_t> deviating;
        for (const std::size_t cycle : code.deviations(place, bits_of(value))) {
            std::vector<std::size_t> path = code.path_to(cycle);
            std::vector<std::uint32_t> readers;
            for (; !path.empty() && readers.empty(); path.pop_back()) readers = code.readers(path.back(), place);
            deviating.insert(readers.begin(), readers.end());
        }
        std::erase_if(unlike, [&](std::uint32_t input) { return !deviating.contains(input); });
    }
    return unlike;
}

}  // namespace

void test_on_robot(Result& result, const ExploredValuesOfCode& explored, bool rounding_allowed,
                   diagnostics::Pollable& budget) {
    if (explored.code.tracking->deployed == nullptr) return;
    Result tested = result;
    try {
        RobotTest(explored, budget).run(tested);
    } catch (const diagnostics::LimitReached& limit) {
        tested.robot->limit = limit.what();
    }
    if (tested.outcome == Outcome::conforms || !rounding_allowed) {
        result = std::move(tested);
        return;
    }
    result.robot = std::move(tested.robot);
    result.robot->difference = std::move(tested.reason);
}

}  // namespace robochart::conformance
