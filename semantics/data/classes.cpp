// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/classes.hpp"

#include <algorithm>
#include <initializer_list>
#include <set>
#include <utility>

#include "semantics/data/linear.hpp"
#include "semantics/data/solver.hpp"
#include "semantics/data/windows.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::ir {
namespace {

constexpr std::size_t most_conditions = 64;
constexpr std::size_t most_classes = 256;
constexpr std::size_t most_solver_numbers = 8;  // limit on the numbers in one value that the solver reads

/// Collects the kinds of the leaves of a type. A leaf is a type without parts (such as numbers), a sequence, a
/// function, a relation or a matrix. Recursion depth: the depth of the type.
void collect_leaves(const System& system, TypeId id, std::set<TypeKind>& leaves) {
    const Type& type = system.type(id);
    if (type.kind == TypeKind::sequence) leaves.insert(type.kind);
    if (type.args.empty() && type.literal_args.empty()) leaves.insert(type.kind);
    if (type.kind == TypeKind::function || type.kind == TypeKind::relation || type.kind == TypeKind::matrix)
        leaves.insert(type.kind);
    for (const TypeId part : type.args) collect_leaves(system, part, leaves);
    for (const auto& arguments : type.literal_args)
        for (const TypeId part : arguments) collect_leaves(system, part, leaves);
}

class Division {
public:
    Division(const System& system, const Sampling& sampling, TypeId type, const Uses& uses)
        : system_(system), sampling_(sampling), type_(type), uses_(uses) {}

    /// Returns classes of all values of the type, or only of the values that occur. Returns no value if the conditions
    /// do not have a supported form. `only_by_events`: all values come from events. `only_copied`: no value is
    /// computed.
    std::optional<ValueClasses> divide(bool all_values, bool only_by_events, bool only_copied);
    /// Returns true if the division stopped because it found too many classes.
    [[nodiscard]] bool has_too_many() const { return result_.witnesses.size() > most_classes; }

private:
    /// The answer of each condition: 1, 0 or -1 (undefined).
    using Answers = std::vector<int>;

    [[nodiscard]] std::optional<std::vector<Value>> candidates() const;
    [[nodiscard]] std::optional<std::vector<Value>> sequence_candidates() const;
    [[nodiscard]] ClosedValue closed_of(MachineId machine) const {
        return [this, machine](const Expr& expr) { return sampling_.closed_value(machine, expr); };
    }
    [[nodiscard]] std::optional<Answers> answers_for(const Value& value) const;
    [[nodiscard]] std::vector<Value> written_values() const;
    [[nodiscard]] bool is_refused(const Answers& answers) const;
    bool add_value(const Value& value, bool written);

    const System& system_;
    const Sampling& sampling_;
    TypeId type_;
    const Uses& uses_;
    bool only_by_events_ = false;
    std::map<std::pair<Answers, Value>, std::size_t> numbers_;  ///< contains the value if no two values share a class
    bool separate_ = false;
    ValueClasses result_;
};

std::optional<Division::Answers> Division::answers_for(const Value& value) const {
    Answers result;
    for (const Condition& condition : uses_.conditions) {
        sampling_.instantiation().poll();
        const auto answer = sampling_.truth(condition.machine, *condition.body, value);
        if (!answer) return std::nullopt;
        result.push_back(*answer);
    }
    return result;
}

/// Returns the values that the model writes. The first one is the default value.
std::vector<Value> Division::written_values() const {
    std::vector<Value> result{default_value(system_, sampling_.instantiation(), type_)};
    for (const Written& written : uses_.writes)
        if (written.closed && written.expr != nullptr)
            result.push_back(*sampling_.closed_value(written.machine, *written.expr));
    return result;
}

std::optional<std::vector<Value>> Division::sequence_candidates() const {
    SequenceConditions sequences(system_, sampling_.instantiation().scale);
    for (const Condition& condition : uses_.conditions)
        if (!sequences.add(*condition.body, closed_of(condition.machine))) return std::nullopt;
    const TypeId element = system_.type(type_).args.at(0);
    Value other = default_value(system_, sampling_.instantiation(), element);
    if (system_.type(element).kind == TypeKind::real) other.number = sampling_.instantiation().scale;
    return sequences.values(element, other);
}

std::optional<std::vector<Value>> Division::candidates() const {
    if (uses_.conditions.empty()) return std::vector<Value>{};
    if (system_.type(type_).kind == TypeKind::sequence) return sequence_candidates();
    return values_for_answers(system_, sampling_, type_, uses_.conditions);
}

/// Returns true for the answers of a value that no transition accepts.
bool Division::is_refused(const Answers& answers) const {
    if (!only_by_events_ || uses_.entries.empty()) return false;
    for (const Expr* entry : uses_.entries) {
        const auto found = std::ranges::find(uses_.conditions, entry, &Condition::expr);
        if (entry == nullptr || found == uses_.conditions.end()) return false;
        if (answers[static_cast<std::size_t>(found - uses_.conditions.begin())] == 1) return false;
    }
    return true;
}

/// Adds a value to its class. A value that no transition accepts is never stored, so its class does not matter. The
/// first class gets it.
bool Division::add_value(const Value& value, bool written) {
    const auto answers = answers_for(value);
    if (!answers) return false;
    if (!written && is_refused(*answers)) return true;
    const auto [found, added] =
        numbers_.emplace(std::pair(*answers, separate_ ? value : Value{}), result_.witnesses.size());
    if (added) result_.witnesses.push_back(value);
    if (written) result_.of_value.emplace(value, found->second);
    if (!added) return true;
    for (std::size_t c = 0; c < uses_.conditions.size(); ++c)
        result_.answers[uses_.conditions[c].expr].push_back((*answers)[c] == 1);
    return !has_too_many();
}

/// Computes the classes. If values are only copied, the classes are the values that the model writes, and one further
/// value. (With only one class, two outputs with different values would have the same name, and a nondeterministic
/// model could seem deterministic.) Reason why these classes suffice: suppose that after one trace, outputs of v and
/// of another value are possible. Rename v to the further value, unless the model writes v, and all other values to
/// one value that the model writes. After the renamed trace, both outputs are possible, too (Lazić, A semantic study
/// of data independence, 1999, chapter 5). The arbitrary values of empty registers in RoboSim are renamed like
/// inputs.
std::optional<ValueClasses> Division::divide(bool all_values, bool only_by_events, bool only_copied) {
    if (uses_.conditions.size() > most_conditions) return std::nullopt;
    only_by_events_ = only_by_events;
    result_.nothing_tested = all_values && uses_.conditions.empty();
    separate_ = !all_values || (result_.nothing_tested && only_copied);
    result_.all_values = all_values;
    result_.exact_outputs = !all_values || (result_.nothing_tested && only_copied);
    for (const Value& value : written_values())
        if (!add_value(value, true)) return std::nullopt;
    if (!all_values) return std::move(result_);
    if (result_.nothing_tested) {
        if (only_copied) result_.witnesses.push_back(result_.witnesses.front());
        return std::move(result_);
    }
    const auto found = candidates();
    if (!found) return std::nullopt;
    for (const Value& value : *found)
        if (!add_value(value, false)) return std::nullopt;
    return std::move(result_);
}

/// Decides which flow classes keep their values. If a value is kept, so are all values from which it is computed.
class Choice {
public:
    Choice(const System& system, const Sampling& sampling, const Places& places, const std::map<PlaceId, Uses>& uses,
           Computed computed)
        : system_(system), sampling_(sampling), places_(places), uses_(uses), computed_(computed) {}

    DividedData choose() {
        for (const auto& [flow, uses] : uses_) choose_classes(flow, uses);
        while (give_up_one()) {
        }
        return {std::move(chosen_), std::move(kept_)};
    }

private:
    [[nodiscard]] static bool is_computed(const Uses& uses) {
        return std::ranges::any_of(uses.writes, [](const Written& written) { return !written.closed; });
    }

    /// Returns true if the class model may choose the classes of computed values. It chooses when a statement computes
    /// the value, so it cannot choose the class of an initial value.
    [[nodiscard]] bool may_be_chosen(const Uses& uses) const {
        return computed_ == Computed::freely && std::ranges::none_of(uses.writes, [](const Written& written) {
                   return written.initial && !written.closed;
               });
    }

    [[nodiscard]] bool from_outside(PlaceId flow) const { return places_[flow].input || places_[flow].shared; }

    /// Returns a reason to keep the values. Considers neither other flow classes nor the form of conditions.
    [[nodiscard]] std::optional<Keep> reason_to_keep(PlaceId flow, const Uses& uses) const {
        const Place& place = places_[flow];
        if (!is_replaceable(system_, place.type)) return Keep{KeepReason::type, {}};
        if (uses.needs_values) return uses.needs_values;
        if (place.opaque) return Keep{KeepReason::other_place, {}};
        const auto computed = std::ranges::find_if(uses.writes, [](const Written& written) { return !written.closed; });
        if (computed == uses.writes.end() || uses.conditions.empty() || may_be_chosen(uses)) return std::nullopt;
        return Keep{KeepReason::computed, computed->expr->span};
    }

    void choose_classes(PlaceId flow, const Uses& uses) {
        if (const auto keep = reason_to_keep(flow, uses)) {
            kept_.emplace(flow, *keep);
            return;
        }
        const Place& place = places_[flow];
        const bool computed = is_computed(uses);
        Division division(system_, sampling_, place.type, uses);
        auto classes = division.divide(from_outside(flow) || computed, !place.shared && !computed, !computed);
        if (classes)
            chosen_.emplace(flow, std::move(*classes));
        else
            kept_.emplace(flow, reason_without_classes(place.type, uses, division.has_too_many()));
    }

    /// Returns the reason why no classes can be derived from the conditions.
    [[nodiscard]] Keep reason_without_classes(TypeId type, const Uses& uses, bool too_many) const {
        for (const Condition& condition : uses.conditions)
            if (!can_divide(system_, sampling_, condition.machine, type, *condition.body))
                return {KeepReason::form, condition.expr->span};
        if (uses.conditions.size() > most_conditions) return {KeepReason::conditions, {}};
        if (too_many) return {KeepReason::classes, {}};
        if (system_.type(type).kind == TypeKind::sequence) return reason_of_sequences(uses);
        LinearConditions linear(system_, sampling_.instantiation());
        for (const Condition& condition : uses.conditions)
            (void)linear.add(*condition.body,
                             [&](const Expr& part) { return sampling_.closed_value(condition.machine, part); });
        return {linear.components().size() > most_solver_numbers ? KeepReason::numbers : KeepReason::points, {}};
    }

    [[nodiscard]] Keep reason_of_sequences(const Uses& uses) const {
        SequenceConditions sequences(system_, sampling_.instantiation().scale);
        for (const Condition& condition : uses.conditions)
            (void)sequences.add(*condition.body,
                                [&](const Expr& part) { return sampling_.closed_value(condition.machine, part); });
        return {sequences.has_both_extremes() ? KeepReason::extremes : KeepReason::classes, {}};
    }

    /// Returns the flow classes whose values this program cannot compute. Their values come from outside, or are
    /// computed from such values.
    [[nodiscard]] std::set<PlaceId> unknown_values() const {
        std::set<PlaceId> unknown;
        for (const auto& [flow, classes] : chosen_)
            if (from_outside(flow)) unknown.insert(flow);
        for (std::size_t before = unknown.size() + 1; before != unknown.size();) {
            before = unknown.size();
            for (const auto& [flow, classes] : chosen_)
                for (const PlaceId read : flows_read(uses_.at(flow)))
                    if (unknown.contains(read)) unknown.insert(flow);
        }
        return unknown;
    }

    /// Returns true if this program can compute the values from carriers.
    [[nodiscard]] bool is_known(const Uses& uses, PlaceId flow, const std::set<PlaceId>& unknown) const {
        return computed_ == Computed::exactly && is_computed(uses) && !unknown.contains(flow);
    }

    [[nodiscard]] std::set<PlaceId> flows_read(const Uses& uses) const {
        std::set<PlaceId> result;
        for (const Written& written : uses.writes)
            for (const PlaceId read : written.reads) result.insert(places_.class_of(read));
        return result;
    }

    /// Makes one more flow class keep its values. It is a class whose values this program can compute, or one from
    /// which a kept value is computed. Returns false if there is none.
    bool give_up_one() {
        const std::set<PlaceId> unknown = unknown_values();
        for (const auto& [flow, uses] : uses_) {
            const bool chosen = chosen_.contains(flow);
            if (chosen && !is_known(uses, flow, unknown)) continue;
            for (const Written& written : uses.writes) {
                if (written.closed) continue;
                if (chosen) return keep_values(flow, {KeepReason::from_carriers, written.expr->span});
                for (const PlaceId read : written.reads)
                    if (keep_values(places_.class_of(read), {KeepReason::computed_from, written.expr->span}))
                        return true;
            }
        }
        return false;
    }
    /// Records that the flow class keeps its values. Returns false if this was already known.
    bool keep_values(PlaceId flow, const Keep& keep) {
        if (chosen_.erase(flow) == 0) return false;
        kept_.emplace(flow, keep);
        return true;
    }

    const System& system_;
    const Sampling& sampling_;
    const Places& places_;
    const std::map<PlaceId, Uses>& uses_;
    Computed computed_;
    std::map<PlaceId, ValueClasses> chosen_;
    std::map<PlaceId, Keep> kept_;
};

}  // namespace

bool is_replaceable(const System& system, TypeId id) {
    std::set<TypeKind> leaves;
    collect_leaves(system, id, leaves);
    const auto has = [&](std::initializer_list<TypeKind> kinds) {
        return std::ranges::any_of(kinds, [&](TypeKind kind) { return leaves.contains(kind); });
    };
    return has({TypeKind::nat, TypeKind::integer, TypeKind::real, TypeKind::string, TypeKind::given,
                TypeKind::sequence}) &&
           !has({TypeKind::function, TypeKind::relation, TypeKind::matrix});
}

std::optional<std::vector<Value>> values_for_answers(const System& system, const Sampling& sampling, TypeId type,
                                                     const std::vector<Condition>& conditions) {
    LinearConditions linear(system, sampling.instantiation());
    const bool all_linear = std::ranges::all_of(conditions, [&](const Condition& condition) {
        return linear.add(*condition.body,
                          [&](const Expr& part) { return sampling.closed_value(condition.machine, part); });
    });
    const auto points = all_linear ? linear.points() : std::nullopt;
    if (!points) return solve_answers(system, sampling, type, conditions);
    std::vector<Value> result;
    for (const std::vector<std::int64_t>& point : *points)
        result.push_back(value_at(system, sampling.instantiation(), type, linear.components(), point));
    return result;
}

bool can_divide(const System& system, const Sampling& sampling, MachineId machine, TypeId type, const Expr& condition) {
    const ClosedValue closed = [&](const Expr& expr) { return sampling.closed_value(machine, expr); };
    if (system.type(type).kind == TypeKind::sequence)
        return SequenceConditions(system, sampling.instantiation().scale).add(condition, closed);
    return LinearConditions(system, sampling.instantiation()).add(condition, closed);
}

DividedData divide_values(const System& system, const Sampling& sampling, const Places& places,
                          const std::map<PlaceId, Uses>& uses, Computed computed) {
    return Choice(system, sampling, places, uses, computed).choose();
}

}  // namespace robochart::ir
