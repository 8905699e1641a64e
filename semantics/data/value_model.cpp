// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/value_model.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "base/diagnostics/containers.hpp"
#include "semantics/data/classes.hpp"
#include "semantics/data/linear.hpp"
#include "semantics/data/rewriter.hpp"
#include "semantics/data/windows.hpp"
#include "semantics/evaluate/carrier.hpp"
#include "semantics/ir/arithmetic.hpp"
#include "semantics/ir/number_parts.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

constexpr std::size_t most_modelled_values = 512;
constexpr std::size_t fresh_values = 2;

std::int64_t& number_at(Value& value, const NumberPart& part) {
    Value* at = &value;
    for (const std::size_t position : part.path) at = &at->parts.at(position);
    return at->number;
}

/// True for a literal, which every finite instantiation contains.
bool is_literal(const Expr& root) {
    if (root.kind == ExprKind::sequence && root.args.empty()) return true;
    const Expr& expr = root.kind == ExprKind::negate ? *root.args.at(0) : root;
    return expr.kind == ExprKind::integer || expr.kind == ExprKind::real;
}

/// Returns true for expressions whose result does not depend on whether numbers have carriers.
bool is_free_of_carriers(const Expr& root) {
    bool result = true;
    visit_operands(root, [&](const Expr& expr) {
        const bool atom = expr.kind == ExprKind::boolean || expr.kind == ExprKind::integer ||
                          expr.kind == ExprKind::real || expr.kind == ExprKind::enum_literal ||
                          expr.kind == ExprKind::variable || expr.kind == ExprKind::trigger_value ||
                          expr.kind == ExprKind::constant || is_clock(expr.kind);
        const bool built = expr.kind == ExprKind::is_in || expr.kind == ExprKind::set || expr.kind == ExprKind::tuple ||
                           expr.kind == ExprKind::record || expr.kind == ExprKind::member ||
                           expr.kind == ExprKind::if_then_else;
        result = result && (atom || built || is_connective(expr.kind) || is_comparison(expr.kind));
    });
    return result;
}

class Explorer {
public:
    Explorer(const System& system, const Instantiation& instantiation, const std::vector<MachineId>& machines,
             const std::vector<Cut>& cuts)
        : system_(system),
          sampling_(system, instantiation),
          machines_(machines),
          cuts_(cuts),
          places_(system),
          uses_(collect_uses(system, sampling_, places_)),
          classes_(divide_values(system, sampling_, places_, uses_).classes) {}

    std::optional<ValueModel> explore() {
        ValueModel result;
        if (!find_flows() || flows_.empty()) return std::nullopt;
        std::map<PlaceId, ValueClasses> divided;
        for (const auto& [type, flows] : flows_)
            if (!divide_type(type, flows, divided, result)) return std::nullopt;
        result.system = with_classes(system_, sampling_, places_, uses_, divided);
        if (!machines_are_free(result.system)) return std::nullopt;
        result.scale = sampling_.instantiation().scale;
        diagnostics::sort_unique(result.cuts);
        for (const auto& [flow, classes] : divided) {
            const ValueClasses& own = classes_.at(flow);
            result.data.push_back({names_in(places_, flow), "", own.witnesses.size(), uses_.at(flow).conditions.size(),
                                   own.all_values, own.nothing_tested});
        }
        return result;
    }

private:
    using Numbers = std::vector<std::int64_t>;

    bool find_flows();
    bool add_place(PlaceId place);
    [[nodiscard]] bool machines_are_free(const System& rewritten) const;
    bool divide_type(TypeId type, const std::set<PlaceId>& flows, std::map<PlaceId, ValueClasses>& divided,
                     ValueModel& result) const;
    bool divide_numbers(TypeId type, const std::set<PlaceId>& flows, std::vector<Value>& values,
                        ValueModel& result) const;
    bool divide_sequences(TypeId type, const std::set<PlaceId>& flows, std::vector<Value>& values,
                          ValueModel& result) const;
    [[nodiscard]] ClosedValue closed_of(MachineId machine) const {
        return [this, machine](const Expr& expr) { return sampling_.closed_value(machine, expr); };
    }
    [[nodiscard]] std::vector<Value> written_values(TypeId type, const std::set<PlaceId>& flows) const;
    [[nodiscard]] bool add_conditions(LinearConditions& linear, TypeId type, const std::set<PlaceId>& flows) const;
    [[nodiscard]] std::optional<std::vector<Value>> values_in_regions(const LinearConditions& linear, TypeId type,
                                                                      const std::vector<Value>& written) const;
    [[nodiscard]] bool add_regions(const LinearConditions& linear, TypeId type, std::vector<Value>& values) const;
    void add_cuts(const LinearConditions& linear, TypeId type, std::vector<Cut>& cuts) const;
    void add_comparisons(const Condition& condition, TypeId type, const std::vector<Value>& values,
                         ValueModel& result) const;
    void add_window(MachineId machine, ModelComparison& comparison) const;
    [[nodiscard]] std::optional<ValueClasses> classes_for(PlaceId flow, const std::vector<Value>& values) const;

    const System& system_;
    const Sampling sampling_;
    const std::vector<MachineId>& machines_;
    const std::vector<Cut>& cuts_;
    Places places_;
    std::map<PlaceId, Uses> uses_;
    std::map<PlaceId, ValueClasses> classes_;
    std::map<TypeId, std::set<PlaceId>> flows_;  ///< the flow classes of the machines, by type
};

/// Adds the flow class of a place. Returns false if values of it are computed, or if a use needs the values
/// themselves.
bool Explorer::add_place(PlaceId place) {
    if (place == no_id || !has_numbers(system_, places_[place].type)) return true;
    const PlaceId flow = places_.class_of(place);
    const auto uses = uses_.find(flow);
    const TypeId type = places_[flow].type;
    const bool numbers = !number_parts(system_, type).empty() || is_number_sequence(system_, type);
    const bool copied = classes_.contains(flow) && numbers && uses != uses_.end() &&
                        std::ranges::all_of(uses->second.writes, [](const Written& written) { return written.closed; });
    if (copied) flows_[type].insert(flow);
    return copied;
}

bool Explorer::find_flows() {
    for (const MachineId id : machines_) {
        const Machine& machine = system_.machine(id);
        for (std::uint32_t v = 0; v < machine.variables.size(); ++v)
            if (!add_place(places_.variable(id, VariableId{v}))) return false;
        for (std::uint32_t e = 0; e < machine.events.size(); ++e)
            if (!add_place(places_.event(id, EventId{e}))) return false;
        for (std::uint32_t o = 0; o < machine.operations.size(); ++o)
            for (std::size_t p = 0; p < machine.operations[o].parameters.size(); ++p)
                if (!add_place(places_.parameter(id, OperationId{o}, p))) return false;
    }
    return true;
}

/// Returns true if the machines compute the same results with and without carriers. Checks constants and initial values
/// in the model itself, because they are computed before code is generated.
bool Explorer::machines_are_free(const System& rewritten) const {
    return std::ranges::all_of(machines_, [&](MachineId id) {
        bool result = sampling_.has_finite_constants(id);
        for (const Variable& variable : system_.machine(id).variables)
            result = result &&
                     (!variable.initial || is_literal(*variable.initial) || is_free_of_carriers(*variable.initial));
        visit_running(rewritten.machine(id),
                      [&](const Expr& expr, ExprRole) { result = result && is_free_of_carriers(expr); });
        return result;
    });
}

/// Returns the values that the model writes: the default value, and then the others in ascending order.
std::vector<Value> Explorer::written_values(TypeId type, const std::set<PlaceId>& flows) const {
    const Value standard = default_value(system_, sampling_.instantiation(), type);
    std::set<Value> others;
    for (const PlaceId flow : flows)
        for (const Written& written : uses_.at(flow).writes)
            if (written.expr != nullptr) others.insert(*sampling_.closed_value(written.machine, *written.expr));
    others.erase(standard);
    std::vector<Value> result{standard};
    result.insert(result.end(), others.begin(), others.end());
    return result;
}

bool Explorer::add_conditions(LinearConditions& linear, TypeId type, const std::set<PlaceId>& flows) const {
    for (const PlaceId flow : flows) {
        for (const Condition& condition : uses_.at(flow).conditions) {
            if (!linear.add(*condition.expr, closed_of(condition.machine))) return false;
        }
    }
    const std::vector<NumberPart> parts = number_parts(system_, type);
    for (const Cut& cut : cuts_) {
        if (cut.type != type) continue;
        std::map<NumberPart, std::int64_t> coefficients;
        for (std::size_t i = 0; i < parts.size(); ++i) coefficients[parts[i]] = cut.coefficients.at(i);
        if (!linear.add_form(coefficients, cut.constant)) return false;
    }
    return true;
}

/// Returns candidates in each region: two more than the number of written values, or all values of the region if it has
/// fewer. If the conditions ignore some numbers of a value, the candidates of a region differ in an ignored number.
std::optional<std::vector<Value>> Explorer::values_in_regions(const LinearConditions& linear, TypeId type,
                                                              const std::vector<Value>& written) const {
    if (linear.has_remainders()) return std::nullopt;  // points() returns only the points of one period
    const std::size_t count = written.size() + fresh_values;
    std::vector<NumberPart> unread = number_parts(system_, type);
    std::erase_if(unread, [&](const NumberPart& part) {
        return std::ranges::find(linear.components(), part) != linear.components().end();
    });
    const auto points = unread.empty() ? linear.points_in_regions(count) : linear.points();
    if (!points) return std::nullopt;
    std::vector<Value> result;
    for (const Numbers& point : *points) {
        Value value = written.front();
        for (std::size_t i = 0; i < point.size(); ++i) number_at(value, linear.components()[i]) = point[i];
        if (unread.empty()) result.push_back(value);
        for (std::size_t i = 1; !unread.empty() && i <= count; ++i) {
            const bool real = unread.front().kind == TypeKind::real;
            number_at(value, unread.front()) =
                static_cast<std::int64_t>(i) * (real ? sampling_.instantiation().scale : 1);
            result.push_back(value);
        }
    }
    return result;
}

/// Adds `fresh_values` values of each region that the model does not write, or all values of a region that has fewer.
/// Returns false if these are too many.
bool Explorer::add_regions(const LinearConditions& linear, TypeId type, std::vector<Value>& values) const {
    const std::vector<Value> written = values;
    const auto candidates = values_in_regions(linear, type, written);
    if (!candidates) return false;
    std::map<std::vector<int>, std::size_t> found;
    for (Value value : *candidates) {
        if (std::ranges::find(written, value) != written.end()) continue;
        Numbers point;
        for (const NumberPart& part : linear.components()) point.push_back(number_at(value, part));
        if (++found[linear.signs_at(point)] <= fresh_values) values.push_back(std::move(value));
    }
    return values.size() <= most_modelled_values;
}

void Explorer::add_cuts(const LinearConditions& linear, TypeId type, std::vector<Cut>& cuts) const {
    const std::vector<NumberPart> parts = number_parts(system_, type);
    for (const auto& [coefficients, constant] : linear.forms()) {
        Cut cut{type, Numbers(parts.size(), 0), constant};
        for (const auto& [part, coefficient] : coefficients)
            cut.coefficients[static_cast<std::size_t>(std::ranges::find(parts, part) - parts.begin())] = coefficient;
        cuts.push_back(normalized(std::move(cut)));
    }
}

/// Adds the comparisons of a sequence's numbers. Also adds, for each window, the comparison of the size that decides
/// whether the window contains a place of the sequence: it does if the form 2 * size - (2 * first - 1) is positive.
void add_sequence_cuts(const SequenceConditions& conditions, TypeId type, std::vector<Cut>& cuts) {
    for (const auto& [window, threshold] : conditions.comparisons()) {
        cuts.push_back({type, {1}, -threshold, window});
        if (window && !window->places.empty()) cuts.push_back({type, {2}, 1 - 2 * window->places.front()});
    }
}

/// Adds a comparison of the code. Returns false if it does not compare one number with a threshold.
bool add_sequence_cut(SequenceConditions& conditions, const Cut& cut) {
    const std::int64_t coefficient = cut.coefficients.at(0);
    if (cut.window) return coefficient == 1 && conditions.add_threshold(*cut.window, -cut.constant);
    // The sign of size - threshold determines the sign of coefficient * size + constant.
    const std::int64_t threshold = *floor_divide(-cut.constant, coefficient);
    return threshold < 0 || conditions.add_size(threshold);
}

/// Finds another sequence in the same region, or shows that there is none. Statement: a region has only one sequence if
/// two conditions hold. (1) No item can be appended to this sequence. (2) Each of its items is the only item in some
/// window that is equal to the number of the window, and this number is a threshold. Reason: the lengths with the same
/// nonempty windows are an interval, so by (1) no sequence of the region is longer. The windows of the greatest items
/// (with `max`: the least items) contain no other items, so every sequence of the region has these items in these
/// places. The windows of the next items contain only these items and the previous ones, and so on.
class SequenceChanges {
public:
    /// `unit` is the unit of one item.
    SequenceChanges(const SequenceConditions& conditions, std::int64_t unit, bool natural)
        : conditions_(conditions), unit_(unit), natural_(natural) {}

    [[nodiscard]] std::optional<Value> other(const Value& value) const {
        const std::vector<int> signs = conditions_.signs_at(value);
        std::optional<Value> result;
        const auto try_value = [&](Value changed) {
            if (!result && changed != value && conditions_.signs_at(changed) == signs) result = std::move(changed);
        };
        for (const std::int64_t item : {beyond(1), beyond(-1)}) {
            Value longer = value;
            longer.parts.push_back({item, {}});
            try_value(std::move(longer));
        }
        if (!value.parts.empty()) {
            Value shorter = value;
            shorter.parts.pop_back();
            try_value(std::move(shorter));
        }
        for (std::size_t place = 0; place < value.parts.size() && !result; ++place) {
            if (place > most_places && place + 1 < value.parts.size()) continue;
            for (const std::int64_t change : {unit_, -unit_, std::int64_t{1}, std::int64_t{-1}}) {
                Value changed = value;
                changed.parts[place].number += change;
                if (!natural_ || changed.parts[place].number >= 0) try_value(std::move(changed));
            }
        }
        return result;
    }

    /// Returns true if the region is known to have no other sequence. `other` must have found none before.
    [[nodiscard]] bool is_alone(const Value& value) const {
        const std::vector<SequenceConditions::Comparison> comparisons = conditions_.comparisons();
        if (value.parts.size() > comparisons.size()) return false;
        const auto length = static_cast<std::int64_t>(value.parts.size());
        const std::vector<int> signs = conditions_.signs_at(value);
        std::set<std::int64_t> fixed;
        for (std::size_t i = 0; i < comparisons.size(); ++i) {
            if (!comparisons[i].window || signs[i] != 0) continue;
            std::vector<std::int64_t> equal;
            for (const std::int64_t place : comparisons[i].window->places)
                if (place <= length &&
                    value.parts[static_cast<std::size_t>(place - 1)].number == comparisons[i].threshold)
                    equal.push_back(place);
            if (equal.size() == 1) fixed.insert(equal.front());
        }
        return static_cast<std::int64_t>(fixed.size()) == length;
    }

private:
    static constexpr std::size_t most_places = 64;

    /// Returns a number on this side of all thresholds. On the lower side of natural numbers, returns the least one.
    [[nodiscard]] std::int64_t beyond(std::int64_t side) const {
        std::int64_t greatest = 0;
        for (const auto& [window, threshold] : conditions_.comparisons())
            if (window) greatest = std::max(greatest, std::abs(threshold));
        const std::int64_t result = side * (greatest + unit_);
        return natural_ ? std::max<std::int64_t>(result, 0) : result;
    }

    const SequenceConditions& conditions_;
    std::int64_t unit_;
    bool natural_;
};

/// Adds `fresh_values` sequences of each region, or its only sequence. Returns false if these are too many, or if the
/// region may have further sequences that were not found.
bool Explorer::divide_sequences(TypeId type, const std::set<PlaceId>& flows, std::vector<Value>& values,
                                ValueModel& result) const {
    if (values.size() > 1) return false;  // the code cannot build other sequences than the empty one
    SequenceConditions conditions(system_, sampling_.instantiation().scale);
    for (const PlaceId flow : flows)
        for (const Condition& condition : uses_.at(flow).conditions)
            if (!conditions.add(*condition.expr, closed_of(condition.machine))) return false;
    for (const Cut& cut : cuts_) {
        if (cut.type != type) continue;
        if (!add_sequence_cut(conditions, cut)) return false;
        result.cuts.push_back(cut);
    }
    for (const PlaceId flow : flows)
        for (const Condition& condition : uses_.at(flow).conditions) add_comparisons(condition, type, values, result);
    const TypeId element = system_.type(type).args.at(0);
    const bool real = system_.type(element).kind == TypeKind::real;
    const std::int64_t unit = real ? sampling_.instantiation().scale : 1;
    const auto candidates = conditions.values(element, {unit, {}});
    if (!candidates) return false;
    const SequenceChanges changes(conditions, unit, system_.type(element).kind == TypeKind::nat);
    std::set<std::vector<int>> regions;
    for (const Value& value : *candidates) {
        sampling_.instantiation().poll();
        if (!regions.insert(conditions.signs_at(value)).second) continue;
        if (value != values.front()) values.push_back(value);
        auto other = changes.other(value);
        if (!other && !changes.is_alone(value)) return false;
        if (other && *other != values.front()) values.push_back(std::move(*other));
        if (values.size() > most_modelled_values) return false;
    }
    add_sequence_cuts(conditions, type, result.cuts);
    return true;
}

/// Makes one class for each value.
std::optional<ValueClasses> Explorer::classes_for(PlaceId flow, const std::vector<Value>& values) const {
    ValueClasses result;
    const bool sequences = is_number_sequence(system_, places_[flow].type);
    result.witnesses = values;
    for (std::size_t v = 0; v < values.size(); ++v) result.of_value.emplace(values[v], v);
    for (const Condition& condition : uses_.at(flow).conditions) {
        std::vector<bool>& answers = result.answers[condition.expr];
        for (const Value& value : values) {
            sampling_.instantiation().poll();
            const auto answer = sampling_.truth(condition.machine, *condition.expr, value);
            // The model takes no transition with an undefined guard. Conditions about numbers are defined.
            if (!answer || (*answer < 0 && !sequences)) return std::nullopt;
            answers.push_back(*answer == 1);
        }
    }
    return result;
}

/// Sets the cut of a comparison of a window with a constant.
void Explorer::add_window(MachineId machine, ModelComparison& comparison) const {
    const Expr& expr = *comparison.expr;
    if (system_.type(system_.type(comparison.type).args.at(0)).kind != TypeKind::real) return;
    SequenceConditions conditions(system_, sampling_.instantiation().scale);
    if (!conditions.add(expr, closed_of(machine))) return;
    for (const auto& [window, threshold] : conditions.comparisons()) {
        if (!window) continue;
        comparison.cut = Cut{comparison.type, {1}, -threshold, window};
        comparison.window = closed_of(machine)(*expr.args.at(1)) ? 0 : 1;
    }
}

/// Adds those comparisons in a condition that have an answer for each value. Sequences need no answers.
void Explorer::add_comparisons(const Condition& condition, TypeId type, const std::vector<Value>& values,
                               ValueModel& result) const {
    visit_operands(*condition.expr, [&](const Expr& expr) {
        if (!is_comparison(expr.kind) || expr.args.size() != 2) return;
        ModelComparison comparison{type, &expr, {}, {}, {}, 0};
        const bool sequences = is_number_sequence(system_, type);
        if (sequences) add_window(condition.machine, comparison);
        for (const Value& value : sequences ? std::vector<Value>() : values) {
            const auto answer = sampling_.truth(condition.machine, expr, value);
            if (!answer || *answer < 0) return;
            comparison.answers.push_back(*answer == 1);
        }
        visit_operands(expr, [&](const Expr& operand) {
            if (operand.kind != ExprKind::constant) return;
            const auto value = sampling_.closed_value(condition.machine, operand);
            if (value) comparison.constants.emplace(&operand, value->number);
        });
        result.comparisons.push_back(std::move(comparison));
    });
}

bool Explorer::divide_type(TypeId type, const std::set<PlaceId>& flows, std::map<PlaceId, ValueClasses>& divided,
                           ValueModel& result) const {
    std::vector<Value> values = written_values(type, flows);
    const std::size_t written = values.size();
    const bool sequences = is_number_sequence(system_, type);
    const bool found =
        sequences ? divide_sequences(type, flows, values, result) : divide_numbers(type, flows, values, result);
    if (!found) return false;
    for (const PlaceId flow : flows) {
        auto classes = classes_for(flow, values);
        if (!classes) return false;
        divided.emplace(flow, std::move(*classes));
    }
    ExploredValues& explored = result.types.emplace_back(ExploredValues{type, {}, written});
    for (Value& value : values) {
        Numbers& numbers = explored.values.emplace_back();
        if (sequences)
            for (const Value& item : value.parts) numbers.push_back(item.number);
        for (const NumberPart& part : number_parts(system_, type)) numbers.push_back(number_at(value, part));
    }
    return true;
}

bool Explorer::divide_numbers(TypeId type, const std::set<PlaceId>& flows, std::vector<Value>& values,
                              ValueModel& result) const {
    LinearConditions linear(system_, sampling_.instantiation());
    if (!add_conditions(linear, type, flows) || !add_regions(linear, type, values)) return false;
    add_cuts(linear, type, result.cuts);
    for (const PlaceId flow : flows)
        for (const Condition& condition : uses_.at(flow).conditions) add_comparisons(condition, type, values, result);
    return true;
}

}  // namespace

Cut normalized(Cut cut) {
    std::int64_t divisor = cut.constant;
    for (const std::int64_t coefficient : cut.coefficients) divisor = std::gcd(divisor, coefficient);
    const auto first = std::ranges::find_if(cut.coefficients, [](std::int64_t number) { return number != 0; });
    if (first == cut.coefficients.end() || divisor == 0) return cut;
    if (*first < 0) divisor = -divisor;
    for (std::int64_t& coefficient : cut.coefficients) coefficient /= divisor;
    cut.constant /= divisor;
    return cut;
}

std::optional<ValueModel> value_model(const System& system, const Instantiation& instantiation,
                                      const std::vector<MachineId>& machines, const std::vector<Cut>& cuts) {
    return Explorer(system, instantiation, machines, cuts).explore();
}

}  // namespace robochart::ir
