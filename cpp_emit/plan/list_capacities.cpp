// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/plan/list_capacities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "cpp_emit/plan/list_growth.hpp"
#include "cpp_emit/plan/rules.hpp"
#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/plan/walk.hpp"
#include "semantics/ir/number_parts.hpp"

namespace robochart::cpp_emit {

using ir::ExprKind;
using ir::TypeKind;

namespace {

/// Visits the outermost types of lists in a type that has_lists. Such lists may be longer than their capacity.
void visit_list_types(const ir::System& system, ir::TypeId id, const std::function<void(ir::TypeId)>& visitor) {
    const ir::Type& type = system.type(id);
    if (is_list(type) && ir::has_numbers(system, id)) return visitor(id);
    for (const ir::TypeId part : type.args) visit_list_types(system, part, visitor);
    for (const auto& arguments : type.literal_args)
        for (const ir::TypeId part : arguments) visit_list_types(system, part, visitor);
}

/// Visits the types of the events and variables of this name whose values contain lists.
void visit_named(const ir::System& system, const Component& component, const std::string& name,
                 const std::function<void(ir::TypeId)>& visitor) {
    const auto visit_type = [&](ir::TypeId type) {
        if (has_lists(system, type)) visitor(type);
    };
    for (const Part& part : component.parts)
        for (const EventUse& event : part.events)
            if (event.name == name && event.type) visit_type(*event.type);
    for (const EventPort& event : component.events)
        if (event.outside == name && event.type) visit_type(*event.type);
    for (const Unit& unit : component.units)
        for (const ir::Variable& variable : unit.machine->variables)
            if (variable.name == name) visit_type(variable.type);
}

using Capacities = std::map<ir::TypeId, std::size_t>;

void raise_capacity(Capacities& capacities, ir::TypeId type, std::size_t least) {
    std::size_t& capacity = capacities[type];
    capacity = std::max(capacity, least);
}

/// Finds the longest literals, constants and initial values, because they may have more elements than the usual
/// capacity.
class LongestValues {
public:
    LongestValues(const ir::System& system, Capacities& capacities) : system_(system), capacities_(capacities) {}

    void add_component(const Component& component) {
        const auto add_literal = [&](const ir::Expr& expr) {
            if (expr.kind == ExprKind::sequence || expr.kind == ExprKind::set) add(expr.type, expr.args.size());
        };
        visit_tested_preconditions(component, system_, add_literal);
        for (const Unit& unit : component.units) {
            visit_expressions(*unit.machine, add_literal);
            for (std::size_t i = 0; i < unit.constants.size(); ++i)
                add_value(unit.machine->constants.at(i).type, unit.constants[i]);
            for (std::size_t i = 0; i < unit.initials.size(); ++i)
                add_value(unit.machine->variables.at(i).type, unit.initials[i]);
        }
        for (const StoredVariable& variable : component.variables) add_value(variable.variable->type, variable.initial);
    }
    [[nodiscard]] std::size_t longest_with_usual_capacity() const { return longest_; }

private:
    void add_value(ir::TypeId id, const ir::Value& value) {
        if (!has_lists(system_, id)) return;
        const ir::Type& type = system_.type(id);
        if (is_list(type)) add(id, value.parts.size());
        if (has_pairs(type)) {
            for (const ir::Value& pair : value.parts) add_parts(type.args, pair);
        } else if (type.kind == TypeKind::enumeration) {
            const auto literal = static_cast<std::size_t>(value.number);
            if (literal < type.literal_args.size()) add_parts(type.literal_args[literal], value);
        } else {
            add_parts(type.args, value);
        }
    }
    /// Adds the parts of a value. If `types` has one element, all parts have this type; otherwise it contains the type
    /// of each part.
    void add_parts(const std::vector<ir::TypeId>& types, const ir::Value& value) {
        for (std::size_t i = 0; i < value.parts.size(); ++i)
            add_value(types.at(types.size() > 1 ? i : 0), value.parts[i]);
    }
    void add(ir::TypeId id, std::size_t elements) {
        const ir::Type& type = system_.type(id);
        if (!is_list(type) || !has_lists(system_, id)) return;
        const auto chosen = capacities_.find(id);
        const std::size_t capacity = chosen == capacities_.end() ? deployed_capacity(system_, type) : chosen->second;
        if (elements > capacity) raise_capacity(capacities_, id, elements);
        if (given_capacity(type) == 0) longest_ = std::max(longest_, elements);
    }

    const ir::System& system_;
    Capacities& capacities_;
    std::size_t longest_ = 0;
};

}  // namespace

bool has_capacity(const ir::System& system, const Component& component, const std::string& name) {
    bool found = false;
    visit_named(system, component, name, [&](ir::TypeId) { found = true; });
    return found;
}

std::optional<ir::System> with_capacities(const ir::System& system, const Component& component,
                                          const Options& options) {
    Capacities capacities;
    for (const auto& given : options.capacities)
        visit_named(system, component, given.first, [&](ir::TypeId type) {
            visit_list_types(system, type, [&](ir::TypeId list) { raise_capacity(capacities, list, given.second); });
        });
    LongestValues(system, capacities).add_component(component);
    if (capacities.empty()) return std::nullopt;
    ir::System result = system;
    for (const auto& [type, capacity] : capacities)
        result.types[type.index].sizes = {static_cast<std::int64_t>(capacity)};
    return result;
}

std::size_t least_longest(const ir::System& system, const Component& component) {
    Capacities capacities;
    LongestValues values(system, capacities);
    values.add_component(component);
    return values.longest_with_usual_capacity();
}

namespace {

/// A toolkit function whose result is an element of an operand, or contains only such elements.
struct Selection {
    std::string_view function;
    std::size_t operand = 0;
    bool one = false;  ///< true: the result is one element
};

constexpr Selection selections[] = {
    {"sequence_toolkit_tail"},
    {"sequence_toolkit_front"},
    {"sequence_toolkit_reverse"},
    {"sequence_toolkit_filter"},
    {"sequence_toolkit_extract", 1},
    {"set_toolkit_inter"},
    {"set_toolkit_diff"},
    {"relation_toolkit_dres", 1},
    {"relation_toolkit_dsub", 1},
    {"relation_toolkit_rres"},
    {"relation_toolkit_rsub"},
    {"sequence_toolkit_head", 0, true},
    {"sequence_toolkit_last", 0, true},
    {"relation_toolkit_first", 0, true},
    {"relation_toolkit_second", 0, true},
};

bool selects_elements(const ir::System& system, const ir::Expr& expr) {
    const auto* const selection = std::ranges::find(selections, std::string_view(expr.text), &Selection::function);
    if (selection == std::end(selections)) return false;
    const ir::TypeId whole = expr.args.at(selection->operand)->type;
    return selection->one ? std::ranges::count(system.type(whole).args, expr.type) > 0 : whole == expr.type;
}

}  // namespace

bool may_overflow(const ir::System& system, const ir::Expr& expr) {
    if (!expr.type.is_valid() || !has_lists(system, expr.type)) return false;
    switch (expr.kind) {
        case ExprKind::concat:
        case ExprKind::set_comprehension:
        case ExprKind::lambda:
        case ExprKind::function_value:
        case ExprKind::set_range:
        case ExprKind::range:
        case ExprKind::call:
        case ExprKind::apply:
            return true;
        case ExprKind::toolkit:
            return !selects_elements(system, expr);
        case ExprKind::boolean:
        case ExprKind::integer:
        case ExprKind::real:
        case ExprKind::string:
        case ExprKind::enum_literal:
        case ExprKind::variable:
        case ExprKind::trigger_value:
        case ExprKind::constant:
        case ExprKind::since:
        case ExprKind::since_entry:
        case ExprKind::negate:
        case ExprKind::logical_not:
        case ExprKind::iff:
        case ExprKind::implies:
        case ExprKind::disjunction:
        case ExprKind::conjunction:
        case ExprKind::equal:
        case ExprKind::not_equal:
        case ExprKind::greater:
        case ExprKind::greater_equal:
        case ExprKind::less:
        case ExprKind::less_equal:
        case ExprKind::plus:
        case ExprKind::minus:
        case ExprKind::times:
        case ExprKind::divide:
        case ExprKind::modulus:
        case ExprKind::if_then_else:
        case ExprKind::tuple:
        case ExprKind::record:
        case ExprKind::sequence:
        case ExprKind::set:
        case ExprKind::matrix:
        case ExprKind::member:
        case ExprKind::index:
        case ExprKind::is_in:
        case ExprKind::cast:
        case ExprKind::bound:
        case ExprKind::forall:
        case ExprKind::exists:
        case ExprKind::exists_unique:
        case ExprKind::the:
        case ExprKind::let:
        case ExprKind::is_type:
        case ExprKind::transpose:
            break;
    }
    return false;
}

namespace {

/// Returns the capacity of the outermost lists in the type.
std::size_t capacity_of_lists(const ir::System& system, ir::TypeId type) {
    std::size_t result = usual_capacity;
    visit_list_types(system, type, [&](ir::TypeId list) { result = deployed_capacity(system, system.type(list)); });
    return result;
}

}  // namespace

void report_capacities(const ir::System& system, const Component& component, const Options& options,
                       diagnostics::Diagnostics& diagnostics) {
    std::set<std::string> reported;
    const auto report = [&](const std::string& name, ir::TypeId type, diagnostics::Span span,
                            const std::string& reason) {
        if (!has_lists(system, type) || options.capacities.contains(name) || !reported.insert(name).second) return;
        const char* const mapped =
            options.mapping == nullptr ? "" : " (for an event, also `capacity N` in the mapping)";
        diagnostics.report(rules::usual_capacity, span,
                           {name, fmt::format("{}", capacity_of_lists(system, type)), reason, name, mapped});
    };
    for (const Unit& unit : component.units) {
        for (const ListGrowth& growth : growing_lists(system, *unit.machine)) {
            const ir::Variable& variable = unit.machine->variables[growth.variable.index];
            report(variable.name, variable.type, growth.span, growth.reason);
        }
    }
    for (const EventPort& event : component.events)
        if (event.received && event.type)
            report(event.model_name, *event.type, component.origin.span, "the model does not bound what it receives");
}

}  // namespace robochart::cpp_emit
