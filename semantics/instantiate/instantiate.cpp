// SPDX-License-Identifier: Apache-2.0
// Chooses finite carriers, the scale and constants. instantiate.hpp states the defaults.

#include <algorithm>
#include <array>

#include "base/diagnostics/spelling.hpp"
#include "semantics/evaluate/evaluate.hpp"
#include "semantics/instantiate/compared.hpp"
#include "semantics/instantiate/constants.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/arithmetic.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/literals.hpp"
#include "semantics/ir/numbers.hpp"
#include "semantics/ir/query.hpp"
#include "semantics/rules.hpp"

namespace robochart::ir {
namespace {

using diagnostics::Diagnostics;

constexpr std::int64_t most_values = 1 << 20;

struct Range {
    std::int64_t low = 0;
    std::int64_t high = 0;
    bool chosen = false;  ///< an option gives the range

    void include_value(std::int64_t value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] bool has(std::int64_t value) const { return low <= value && value <= high; }
};

/// The ranges of nat, int and real, in this order. Values of each type can be used as values of the next type.
struct Ranges {
    std::array<Range, 3> by_type{Range{0, 2, false}, Range{-2, 2, false}, Range{-2, 2, false}};
    static constexpr std::array<const char*, 3> names{"nat", "int", "real"};
};

/// Rounds a decimal up to a whole number if `up` is true, and down otherwise.
std::int64_t round_to_whole(const Decimal& decimal, bool up) {
    const std::int64_t divisor = power_of_ten(decimal.decimals).value_or(1);
    const std::int64_t down = *floor_divide(decimal.unscaled, divisor);
    return up && *floor_modulus(decimal.unscaled, divisor) != 0 ? down + 1 : down;
}

void include_value(Range& range, const Decimal& decimal) {
    if (decimal.unscaled < 0)
        range.low = std::min(range.low, round_to_whole(decimal, true));
    else
        range.high = std::max(range.high, round_to_whole(decimal, false));
}

/// True if the name denotes a size, whose range starts at 0: the length of sequences, the time of clocks, the number of
/// elements of given types.
bool is_size(const std::string& name) {
    return name == "Seq" || name == "clock" || name == "given";
}

void read_range_options(const InstantiationOptions& options, Ranges& ranges, Diagnostics& diagnostics) {
    for (const auto& [name, bounds] : options.ranges) {
        if (is_size(name)) continue;
        const auto* at = std::ranges::find(Ranges::names, name);
        if (at == Ranges::names.end()) {
            const std::vector<std::string> known{"nat", "int", "real", "Seq", "clock", "given"};
            const std::string meant = diagnostics::nearest_spelling(name, known);
            diagnostics.report(rules::unknown_range_option, {},
                               {name, meant.empty() ? "" : "; did you mean '" + meant + "'?"});
            continue;
        }
        const auto [low, high] = bounds;
        const char* cause = nullptr;
        if (low > high)
            cause = "the range is empty";
        else if (low > 0 || high < 0)
            cause = "the range must hold 0";
        else if (name == std::string("nat") && low < 0)
            cause = "nat has no negative numbers";
        if (cause != nullptr)
            diagnostics.report(rules::bad_range, {}, {name, std::to_string(low), std::to_string(high), cause});
        else
            ranges.by_type[static_cast<std::size_t>(at - Ranges::names.begin())] = {low, high, true};
    }
}

void report_outside(const Range& range, const char* name, const std::string& literal, diagnostics::Span where,
                    Diagnostics& diagnostics) {
    diagnostics.report(rules::literal_outside_range, where,
                       {literal, std::to_string(range.low), std::to_string(range.high), name});
}

/// Widens the default ranges by the literals. A range that an option sets is not changed, and literals outside it are
/// reported.
void widen_by_literals(const Literals& literals, Ranges& ranges, Diagnostics& diagnostics) {
    const std::array<const std::set<std::int64_t>*, 2> whole_numbers{&literals.nat, &literals.integer};
    for (std::size_t i = 0; i < whole_numbers.size(); ++i)
        for (const auto literal : *whole_numbers[i]) {
            Range& range = ranges.by_type[i];
            if (!range.chosen)
                range.include_value(literal);
            else if (!range.has(literal))
                report_outside(range, Ranges::names[i], std::to_string(literal), literals.places.at(literal),
                               diagnostics);
        }
    Range& real = ranges.by_type[2];
    for (const auto& literal : literals.real)
        if (!real.chosen)
            include_value(real, literal);
        else if (literal.decimals == 0 && !real.has(literal.unscaled))
            report_outside(real, Ranges::names[2], to_string(literal), {}, diagnostics);
}

/// If no option sets the range of a type, extends the range beyond the numbers with which values are compared. The
/// range stays within the ranges that options set for wider types.
void reach_beyond(const Compared& compared, Ranges& ranges) {
    const std::array<const std::set<std::int64_t>*, 3> numbers{&compared.nat, &compared.integer, &compared.real};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (ranges.by_type[i].chosen) continue;
        for (const std::int64_t number : *numbers[i]) {
            const bool fits = std::all_of(ranges.by_type.begin() + i + 1, ranges.by_type.end(),
                                          [&](const Range& outer) { return !outer.chosen || outer.has(number); });
            if (fits) ranges.by_type[i].include_value(number);
        }
    }
}

/// Makes nat a part of int and int a part of real by widening ranges that no option chose.
void nest_ranges(Ranges& ranges, Diagnostics& diagnostics) {
    for (std::size_t i = 1; i < ranges.by_type.size(); ++i) {
        const Range inner = ranges.by_type[i - 1];
        Range& outer = ranges.by_type[i];
        if (outer.has(inner.low) && outer.has(inner.high)) continue;
        if (!outer.chosen) {
            outer.include_value(inner.low);
            outer.include_value(inner.high);
            continue;
        }
        diagnostics.report(
            rules::ranges_not_nested, {},
            {Ranges::names[i], std::to_string(outer.low), std::to_string(outer.high), Ranges::names[i - 1],
             std::to_string(inner.low), std::to_string(inner.high), Ranges::names[i - 1], Ranges::names[i]});
        outer.include_value(inner.low);
        outer.include_value(inner.high);
    }
}

/// Returns the place of the number in the model that makes a range large.
diagnostics::Span cause_of(const Range& range, const Literals& literals) {
    const bool upwards = range.high > -(range.low + 1);  // does not overflow, even for the least number
    auto found = literals.places.find(upwards ? range.high : range.low);
    // A range may extend one number beyond a number of the model.
    if (found == literals.places.end()) found = literals.places.find(upwards ? range.high - 1 : range.low + 1);
    return found == literals.places.end() ? diagnostics::Span{} : found->second;
}

/// Returns the numbers of a large range that conditions can distinguish: those of the narrower type, the ends of the
/// range, the whole numbers of the model, and the neighbours of all these.
std::vector<std::int64_t> distinguished_numbers(const Range& range, const std::vector<std::int64_t>& narrower,
                                                const Literals& literals) {
    std::set<std::int64_t> numbers(narrower.begin(), narrower.end());
    const auto add = [&](std::int64_t number) {
        for (const std::int64_t step : {-1, 0, 1})
            if (const auto near = checked_add(number, step); near && range.has(*near)) numbers.insert(*near);
    };
    for (const std::int64_t number : {std::int64_t{-1}, std::int64_t{1}, range.low, range.high}) add(number);
    for (const std::set<std::int64_t>* whole : {&literals.nat, &literals.integer})
        for (const std::int64_t number : *whole) add(number);
    for (const Decimal& decimal : literals.real)
        for (const bool up : {false, true}) add(round_to_whole(decimal, up));
    return {numbers.begin(), numbers.end()};
}

/// Returns the smallest power of ten that makes every decimal literal a whole number.
std::int64_t scale_of(const Literals& literals) {
    std::uint32_t places = 0;
    for (const auto* list : {&literals.real, &literals.real_time})
        for (const auto& decimal : *list) places = std::max(places, decimal.decimals);
    return power_of_ten(places).value_or(1);  // parse_decimal accepts at most 18 decimal places
}

/// Makes the carriers of the number types, and reports types that are too large. One report is enough, because the
/// types are nested.
class NumberCarriers {
public:
    NumberCarriers(const Literals& literals, Diagnostics& diagnostics)
        : literals_(literals), diagnostics_(diagnostics) {}

    /// Returns the carrier of a type. It has gaps if the range of the model's numbers is too large. `narrower` is the
    /// carrier of the subtype: that of nat for int, and that of int for real.
    [[nodiscard]] std::vector<std::int64_t> whole(const Range& range, const char* name,
                                                  const std::vector<std::int64_t>& narrower) {
        const auto size = checked_subtract(range.high, range.low);
        std::vector<std::int64_t> result;
        if (size && *size < most_values) {
            for (std::int64_t value = range.low; value <= range.high; ++value) result.push_back(value);
            return result;
        }
        const std::string count = size ? std::to_string(*size) : "over 2^63";
        result = range.chosen ? std::vector<std::int64_t>{0} : distinguished_numbers(range, narrower, literals_);
        if (reported_) return result;
        reported_ = true;
        if (range.chosen)
            diagnostics_.report(rules::range_too_large, {}, {name, count, std::to_string(most_values), name});
        else
            diagnostics_.report(rules::numbers_omitted, cause_of(range, literals_),
                                {name, count, std::to_string(most_values), std::to_string(result.size()), name});
        return result;
    }

    /// Returns the whole numbers of the range and every decimal literal, in units of 1/scale.
    [[nodiscard]] std::vector<std::int64_t> reals(const Range& range, const std::vector<std::int64_t>& narrower,
                                                  std::int64_t scale) {
        std::set<std::int64_t> units;
        bool fits = true;
        const auto add = [&](std::optional<std::int64_t> unit) {
            if (unit)
                units.insert(*unit);
            else
                fits = false;
        };
        for (const auto value : whole(range, "real", narrower)) add(checked_multiply(value, scale));
        for (const auto& literal : literals_.real)
            if (literal.decimals > 0) add(scale_decimal(literal, scale));
        if (!fits) diagnostics_.report(rules::scale_too_large, {}, {std::to_string(scale)});
        return {units.begin(), units.end()};
    }

private:
    const Literals& literals_;
    Diagnostics& diagnostics_;
    bool reported_ = false;
};

/// Returns the value at which all clocks of the model can saturate without a change of any comparison.
std::int64_t clock_need(const System& system, const Instantiation& instantiation) {
    std::int64_t result = 0;
    for (const auto& machine : system.machines)
        for (std::uint32_t i = 0; i < machine.clocks.size(); ++i)
            result = std::max(result, clock_saturation(system, instantiation, machine, ClockId{i}));
    return result;
}

/// Sets the sizes from options. The range of clocks must exceed the numbers with which clocks are compared.
void set_sizes(const InstantiationOptions& options, std::int64_t clocks, Instantiation& instantiation,
               Diagnostics& diagnostics) {
    for (const auto& [name, bounds] : options.ranges) {
        if (!is_size(name)) continue;
        const auto [low, high] = bounds;
        const std::string compared = "the model compares clocks with " + std::to_string(clocks - 1);
        const char* cause = nullptr;
        if (low != 0)
            cause = "it is counted from 0";
        else if (high < 0)
            cause = "the range is empty";
        else if (high >= most_values)
            cause = "it is too large";
        else if (name == "clock" && high < clocks)
            cause = compared.c_str();
        if (cause != nullptr)
            diagnostics.report(rules::bad_range, {}, {name, std::to_string(low), std::to_string(high), cause});
        else if (name == "Seq")
            instantiation.sequence_bound = high;
        else if (name == "clock")
            instantiation.clock_bound = high;
        else
            instantiation.given_size = high + 1;
    }
}

}  // namespace

Instantiation instantiate_system(const System& system, const InstantiationOptions& options, Diagnostics& diagnostics,
                                 Carriers carriers, const SetConstants& set) {
    Instantiation instantiation;
    instantiation.budget = diagnostics.budget();
    Literals literals = literals_of(system, carriers == Carriers::robotool || carriers_given(system));
    const auto chosen = chosen_constants(system, options.constants, set, literals, diagnostics);
    Ranges ranges;
    read_range_options(options, ranges, diagnostics);
    widen_by_literals(literals, ranges, diagnostics);
    if (carriers == Carriers::beyond && !carriers_given(system)) {
        const auto lengths = options.ranges.find("Seq");
        const std::int64_t longest =
            lengths == options.ranges.end() ? instantiation.sequence_bound : lengths->second.second;
        const Compared beyond = compared_values(system, chosen, literals, longest);
        reach_beyond(beyond, ranges);
        if (!ranges.by_type[2].chosen)
            literals.real.insert(literals.real.end(), beyond.between.begin(), beyond.between.end());
    }
    nest_ranges(ranges, diagnostics);
    instantiation.scale = scale_of(literals);
    literals.strings.insert("");
    instantiation.strings.assign(literals.strings.begin(), literals.strings.end());
    NumberCarriers numbers(literals, diagnostics);
    instantiation.nat = numbers.whole(ranges.by_type[0], "nat", {});
    instantiation.integer = numbers.whole(ranges.by_type[1], "int", instantiation.nat);
    instantiation.real = numbers.reals(ranges.by_type[2], instantiation.integer, instantiation.scale);
    set_constants(system, chosen, instantiation);
    check_shared_constants(system, instantiation, diagnostics);
    const std::int64_t clocks = clock_need(system, instantiation);
    instantiation.clock_bound = std::max(instantiation.clock_bound, clocks);
    set_sizes(options, clocks, instantiation, diagnostics);
    return instantiation;
}

}  // namespace robochart::ir
