// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/class_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "semantics/data/classes.hpp"
#include "semantics/data/free_conditions.hpp"
#include "semantics/data/relations.hpp"
#include "semantics/data/rewriter.hpp"
#include "semantics/evaluate/carrier.hpp"
#include "semantics/ir/number_parts.hpp"

namespace robochart::ir {
namespace {

bool have_small_carriers(const System& system, const Instantiation& instantiation, const std::set<TypeId>& types) {
    constexpr std::size_t most_values = 64;
    try {
        for (const TypeId type : types) (void)carrier_values(system, instantiation, type, most_values);
    } catch (const std::length_error&) {
        return false;
    }
    return true;
}

/// Returns the types of data that could be replaced.
std::set<TypeId> replaceable_types(const System& system) {
    std::set<TypeId> result;
    const Places places(system);
    for (PlaceId place = 0; place < places.size(); ++place)
        if (is_replaceable(system, places[place].type)) result.insert(places[place].type);
    return result;
}

std::string name_of(const Machine& machine) {
    return machine.package.empty() ? machine.path : machine.package + "::" + machine.path;
}

std::set<std::string> outputs_replaced(const System& system, const Places& places,
                                       const std::map<PlaceId, ValueClasses>& classes) {
    std::set<std::string> result;
    for (std::uint32_t m = 0; m < system.machines.size(); ++m) {
        const Machine& machine = system.machines[m];
        const auto note = [&](PlaceId place) {
            const auto found = classes.find(places.class_of(place));
            if (found != classes.end() && !found->second.exact_outputs) result.insert(name_of(machine));
        };
        for (std::uint32_t e = 0; e < machine.events.size(); ++e)
            if (machine.events[e].output && machine.events[e].type) note(places.event(MachineId{m}, EventId{e}));
        for (std::uint32_t o = 0; o < machine.operations.size(); ++o)
            for (std::size_t p = 0; p < machine.operations[o].parameters.size(); ++p)
                note(places.parameter(MachineId{m}, OperationId{o}, p));
        for (std::uint32_t v = 0; v < machine.variables.size(); ++v)
            if (machine.variables[v].scope == VariableScope::required || machine.variables[v].output)
                note(places.variable(MachineId{m}, VariableId{v}));
    }
    return result;
}

/// Finds classes for a system. Holders may already have replaced groups of related variables.
class Attempt {
public:
    Attempt(RelatedSystem related, const Instantiation& instantiation, Computed computed)
        : instantiation_(instantiation),
          related_(std::move(related)),
          sampling_(related_.system, instantiation),
          places_(related_.system) {
        for (const Relation& relation : related_.relations)
            for (const auto& [variable, coefficient] : relation.term.coefficients)
                places_.unite(holder_of(relation),
                              places_.variable(relation.group.first, VariableId{static_cast<std::uint32_t>(variable)}));
        uses_ = collect_uses(related_.system, sampling_, places_, computed);
        DividedData divided = divide_values(related_.system, sampling_, places_, uses_, computed);
        classes_ = std::move(divided.classes);
        kept_ = std::move(divided.kept);
        for (const Relation& relation : related_.relations)
            terms_[places_.class_of(holder_of(relation))] = relation.text;
    }

    /// Returns the first group of related variables whose holder has no classes.
    [[nodiscard]] std::optional<GroupId> relation_without_classes() const {
        for (const Relation& relation : related_.relations)
            if (!classes_.contains(places_.class_of(holder_of(relation)))) return relation.group;
        return std::nullopt;
    }
    /// Returns the conditions on values without classes, unless another use requires the values themselves.
    [[nodiscard]] std::set<const Expr*> conditions_without_classes() const {
        std::set<const Expr*> result;
        for (const auto& [flow, uses] : uses_) {
            if (classes_.contains(flow) || uses.needs_values) continue;
            if (!is_replaceable(related_.system, places_[flow].type)) continue;
            for (const Condition& condition : uses.conditions) result.insert(condition.expr);
        }
        return result;
    }
    /// Returns no value if classes replace no data.
    [[nodiscard]] std::optional<ClassModel> result() const;
    [[nodiscard]] std::vector<KeptData> kept_data() const {
        std::vector<KeptData> result;
        for (const auto& [flow, keep] : kept_)
            if (has_numbers(related_.system, places_[flow].type)) result.push_back({names_in(places_, flow), keep});
        return result;
    }

private:
    [[nodiscard]] RelatedVariables described(const Relation& relation) const;
    [[nodiscard]] PlaceId holder_of(const Relation& relation) const {
        return places_.variable(relation.group.first, relation.group.second);
    }

    const Instantiation& instantiation_;
    RelatedSystem related_;
    Sampling sampling_;
    Places places_;
    std::map<PlaceId, Uses> uses_;
    std::map<PlaceId, ValueClasses> classes_;
    std::map<PlaceId, Keep> kept_;
    std::map<PlaceId, std::string> terms_;  ///< the terms of the holders, by flow class
};

RelatedVariables Attempt::described(const Relation& relation) const {
    const Machine& machine = related_.system.machine(relation.group.first);
    const auto name = [&](std::size_t variable) { return machine.variables.at(variable).name; };
    const TypeId type = machine.variables.at(relation.group.second.index).type;
    RelatedVariables result;
    result.machine = name_of(machine);
    result.holder = name(relation.group.second.index);
    result.scale = sampling_.instantiation().scale;
    result.whole = related_.system.type(type).kind == TypeKind::integer;
    result.assigned = relation.assigned;
    for (const auto& [variable, coefficient] : relation.term.coefficients)
        result.variables.push_back(
            {name(variable), coefficient, relation.initial.at(VariableId{static_cast<std::uint32_t>(variable)})});
    for (const auto& [element, variable] : relation.stored_by) result.stored_by[element] = name(variable.index);
    for (const Value& witness : classes_.at(places_.class_of(holder_of(relation))).witnesses) {
        std::int64_t units = witness.number;
        if (result.whole) units *= result.scale;
        result.term_values[term_value_text(related_.system, result.scale, relation.text, type, witness)] = units;
    }
    return result;
}

std::optional<ClassModel> Attempt::result() const {
    if (classes_.empty()) return std::nullopt;
    const System& system = related_.system;
    std::set<TypeId> types;
    for (const auto& [flow, divided] : classes_) types.insert(places_[flow].type);
    ClassModel result{with_classes(system, sampling_, places_, uses_, classes_, terms_),
                      instantiation_,
                      {},
                      have_small_carriers(system, instantiation_, types),
                      outputs_replaced(system, places_, classes_),
                      0,
                      {}};
    for (const auto& [flow, divided] : classes_) {
        const auto term = terms_.find(flow);
        std::string term_text;
        if (term != terms_.end()) term_text = term->second;
        result.data.push_back({names_in(places_, flow), std::move(term_text), divided.witnesses.size(),
                               uses_.at(flow).conditions.size(), divided.all_values, divided.nothing_tested});
    }
    for (const Relation& relation : related_.relations) result.related.push_back(described(relation));
    return result;
}

RelatedSystem related_system(const System& system, const Instantiation& instantiation,
                             const std::set<GroupId>& refused) {
    // In RoboSim, an input is communicated before it is stored, so a class of a term cannot replace the input.
    if (std::ranges::any_of(system.machines, &Machine::robosim)) return {system, {}};
    const Sampling sampling(system, instantiation);
    Places places(system);
    (void)collect_uses(system, sampling, places);  // unites the places between which values are copied
    return relate_variables(system, sampling, places, refused);
}

}  // namespace

bool has_data(const System& system) {
    return !replaceable_types(system).empty();
}

bool has_large_carriers(const System& system, const Instantiation& instantiation) {
    return !have_small_carriers(system, instantiation, replaceable_types(system));
}

Classification classify_data(const System& system, const Instantiation& instantiation) {
    std::set<GroupId> refused;
    for (;;) {
        const Attempt attempt(related_system(system, instantiation, refused), instantiation, Computed::exactly);
        const auto kept = attempt.relation_without_classes();
        if (!kept) return {attempt.result(), attempt.kept_data()};
        refused.insert(*kept);
    }
}

std::optional<ClassModel> free_model(const System& system, const Instantiation& instantiation) {
    const Sampling sampling(system, instantiation);
    std::set<const Expr*> unanswered;
    for (;;) {
        FreedSystem freed = free_conditions(system, sampling, unanswered);
        const Attempt attempt({std::move(freed.system), {}}, instantiation, Computed::freely);
        const std::size_t before = unanswered.size();
        unanswered.merge(attempt.conditions_without_classes());
        if (unanswered.size() > before) continue;
        auto result = attempt.result();
        if (result) result->free_conditions = freed.conditions;
        return result;
    }
}

std::vector<std::string> describe_classes(const System& class_model) {
    std::vector<std::string> lines;
    for (const Type& type : class_model.types) {
        if (type.shown.empty()) continue;
        lines.push_back(fmt::format("{}: classes of values of {}", type.name, type.values_of));
        for (std::size_t i = 0; i < type.shown.size(); ++i)
            lines.push_back(fmt::format("  {}, for example {}", type.labels[i], type.shown[i]));
    }
    return lines;
}

}  // namespace robochart::ir
