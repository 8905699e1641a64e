// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/faults/faulty_model.hpp"

#include "cpp_emit/faults/expression_faults.hpp"
#include "cpp_emit/faults/machine_faults.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::cpp_emit {

FaultyModel::FaultyModel(const ir::System& system, const ir::Instantiation& inst, const Component& component,
                         Mutation& mutation)
    : system_(system), component_(component) {
    if (mutation.fault() == Fault::none) return;
    changed_component_ = component;
    for (Unit& unit : changed_component_->units) {
        inst.poll();
        machines_.push_back(faulty_machine(system, inst, component, unit, mutation));
        unit.machine = &machines_.back();
    }
    change_initials(inst, mutation);
    change_functions(inst, mutation);
}

/// Changes initial values. With Fault::initial_lost, the variable starts with the default value of its type.
void FaultyModel::change_initials(const ir::Instantiation& inst, Mutation& mutation) {
    const auto change = [&](const ir::Variable& variable, ir::Value& initial) {
        const ir::Value lost = ir::default_value(system_, inst, variable.type);
        if (lost != initial && mutation.hits(Fault::initial_lost)) initial = lost;
    };
    for (StoredVariable& variable : changed_component_->variables)
        if (variable.has_member()) change(*variable.variable, variable.initial);
    for (Unit& unit : changed_component_->units)
        for (std::size_t index = 0; index < unit.variable_fields.size(); ++index)
            if (!unit.variable_fields[index].empty()) change(unit.machine->variables[index], unit.initials[index]);
}

/// Changes the conditions that code tests before it calls a function.
void FaultyModel::change_functions(const ir::Instantiation& inst, Mutation& mutation) {
    for (const FunctionHook& hook : component_.functions) {
        if (!hook.guarded) continue;
        if (!changed_system_) changed_system_ = system_;
        ExpressionFaults expressions(system_, inst, mutation);
        for (ir::ExprPtr& condition : changed_system_->functions[hook.id.index].preconditions)
            condition = expressions.rewrite(condition);
    }
}

}  // namespace robochart::cpp_emit
