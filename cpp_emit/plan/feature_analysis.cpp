// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/plan/feature_analysis.hpp"

#include <algorithm>

#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/plan/views.hpp"
#include "cpp_emit/plan/walk.hpp"
#include "semantics/evaluate/preconditions.hpp"
#include "semantics/evaluate/toolkit.hpp"

namespace robochart::cpp_emit {

using ir::ExprKind;
using ir::TypeKind;

namespace {

/// Returns the types whose values an expression enumerates. A bound variable with a generator is excluded, because it
/// ranges over a collection and not over a type.
std::vector<ir::TypeId> visited_types(const ir::System& system, const ir::Expr& expr) {
    std::vector<ir::TypeId> result;
    if (ir::binds_names(expr.kind)) {
        const std::vector<Generator> sources = generators(system, expr);
        for (std::size_t i = 0; i < sources.size(); ++i)
            if (sources[i].collection == nullptr) result.push_back(expr.bound_types.at(i));
        return result;
    }
    if (expr.kind == ExprKind::function_value) result.push_back(system.type(expr.type).args.at(0));
    if (expr.kind == ExprKind::range) {
        const ir::TypeId member = system.type(expr.type).args.at(0);
        if (system.type(member).kind == TypeKind::real) result.push_back(member);
    }
    if (expr.kind == ExprKind::toolkit)
        for (const std::size_t place : ir::toolkit_carriers(expr.text)) result.push_back(expr.bound_types.at(place));
    return result;
}

class Uses {
public:
    Uses(Component& component, const ir::System& system) : component_(component), system_(system) {}

    void collect_all() {
        for (const Part& part : component_.parts)
            for (const EventUse& event : part.events)
                if (event.type) use_type(*event.type);
        for (const FunctionHook& hook : component_.functions) use_signature(system_.functions[hook.id.index]);
        for (const PlatformCall& call : component_.calls)
            for (const ir::TypeId parameter : call.signature->parameters) use_type(parameter);
        for (const Unit& unit : component_.units) {
            for (const ir::Node& node : unit.machine->nodes)
                component_.probabilistic = component_.probabilistic || node.kind == ir::NodeKind::probabilistic;
            for (const ir::Variable& variable : unit.machine->variables) use_type(variable.type);
            visit_expressions(*unit.machine, [&](const ir::Expr& expr) { use_expression(expr); });
            visit_communications(*unit.machine, [&](const ir::Communication& communication, bool) {
                use_reception(*unit.machine, communication);
            });
        }
        visit_tested_preconditions(component_, system_, [&](const ir::Expr& expr) { use_expression(expr); });
        // Each of these headers includes the next one.
        component_.toolkit = component_.toolkit || component_.views;
        component_.matrices = component_.matrices || component_.toolkit;
    }

private:
    void use_signature(const ir::Function& function) {
        for (const ir::TypeId parameter : function.parameters) use_type(parameter);
        use_type(function.result);
    }

    void use_expression(const ir::Expr& expr) {
        if (expr.type.is_valid()) use_type(expr.type);
        const bool converts = expr.kind == ExprKind::toolkit || expr.kind == ExprKind::cast ||
                              expr.kind == ExprKind::apply || expr.kind == ExprKind::function_value ||
                              expr.kind == ExprKind::set_range || expr.kind == ExprKind::range ||
                              expr.kind == ExprKind::is_type;
        const bool with_parts = expr.type.is_valid() && is_composed(system_.type(expr.type));
        component_.toolkit = component_.toolkit || (converts && (with_parts || expr.kind != ExprKind::cast));
        for (const ir::ExprPtr& part : expr.args)
            if (part && part->type.is_valid() && with_parts && has_parts(part->type)) component_.toolkit = true;
        component_.views = component_.views || visits_in_place(system_, expr);
        for (const ir::TypeId type : visited_types(system_, expr)) use_carrier(type);
    }

    /// Records the uses of a reception. If the variable has another type than a received value with parts, the value
    /// needs a conversion, which the toolkit provides.
    void use_reception(const ir::Machine& machine, const ir::Communication& communication) {
        if (!communication.event.is_valid() || !communication.variable.is_valid()) return;
        const ir::TypeId variable = machine.variables[communication.variable.index].type;
        const std::optional<ir::TypeId> event = machine.events[communication.event.index].type;
        const bool converts = event && is_composed(system_.type(variable)) && *event != variable;
        component_.toolkit = component_.toolkit || converts;
    }

    /// True if values of the type have parts. Such values need a conversion when they are used as values of another
    /// type.
    [[nodiscard]] bool has_parts(ir::TypeId id) const { return is_composed(system_.type(id)); }

    void use_carrier(ir::TypeId id) {
        const auto same = [&](const CarrierUse& use) { return use.type == id; };
        if (std::ranges::any_of(component_.carriers, same)) return;
        component_.carriers.push_back({id, scope_.unique_name("any_" + system_.type(id).name)});
    }

    // Records the use of a type. Types may be recursive.
    void use_type(ir::TypeId id) {
        if (std::ranges::find(seen_, id) != seen_.end()) return;
        seen_.push_back(id);
        const ir::Type& found = system_.type(id);
        component_.matrices = component_.matrices || is_block_type(found);
        component_.sequences = component_.sequences || found.kind == TypeKind::sequence;
        component_.lists = component_.lists || has_lists(system_, id);
        component_.strings = component_.strings || found.kind == TypeKind::string;
        const bool of_parts = found.kind == TypeKind::set && is_composed(system_.type(found.args.at(0)));
        component_.toolkit = component_.toolkit || has_pairs(found) || of_parts;
        component_.ordered = component_.ordered || has_pairs(found) || of_parts;
        for (const ir::TypeId part : found.args) use_type(part);
        for (const auto& arguments : found.literal_args)
            for (const ir::TypeId part : arguments) use_type(part);
    }

    Component& component_;
    const ir::System& system_;
    NameScope scope_;
    std::vector<ir::TypeId> seen_;
};

}  // namespace

void collect_uses(Component& component, const ir::System& system) {
    Uses(component, system).collect_all();
}

}  // namespace robochart::cpp_emit
