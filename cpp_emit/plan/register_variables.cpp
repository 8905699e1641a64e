// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/plan/register_variables.hpp"

#include <algorithm>
#include <optional>

#include "cpp_emit/plan/rules.hpp"
#include "semantics/evaluate/carrier.hpp"
#include "semantics/instantiate/instantiate.hpp"

namespace robochart::cpp_emit {

namespace {

const ir::Variable* find_named(const std::vector<ir::Variable>& variables, const std::string& name) {
    const auto found = std::ranges::find(variables, name, &ir::Variable::name);
    return found == variables.end() ? nullptr : &*found;
}

/// A variable of a controller or platform.
struct Declared {
    const ir::Variable* variable = nullptr;
    const void* level = nullptr;  ///< StoredVariable::level
    bool shown = false;           ///< whether writes are outputs of the component
    std::string once;             ///< the mark of the level's limit of one write per cycle, if it has one
};

/// The levels and their limits are those of csp_emit/compose/cycles.cpp: add_variable.
class VariableConnections {
public:
    VariableConnections(Component& component, const ir::System& system, const ir::Instantiation& inst,
                        const ir::Module* module, const std::vector<const ir::Controller*>& contexts,
                        diagnostics::Diagnostics& diagnostics)
        : component_(component),
          system_(system),
          inst_(inst),
          module_(module),
          contexts_(contexts),
          diagnostics_(diagnostics) {}

    void connect() {
        if (module_ == nullptr)
            for (const ir::Variable& variable : contexts_.front()->variables)
                if (variable.scope == ir::VariableScope::required) (void)memory_of({&variable, nullptr, false, ""});
        for (std::size_t part = 0; part < component_.parts.size(); ++part)
            for (const auto& [name, index] : component_.parts[part].variables)
                if (component_.variables[index].variable->scope == ir::VariableScope::reg) connect(part, index);
    }

private:
    void connect(std::size_t part, std::size_t index) {
        const std::string name = component_.variables[index].name();
        component_.variables[index].copy = true;
        const std::optional<Declared> declared = declaration_of(part, name);
        const std::string own = to_identifier(component_.parts[part].name + "_own_set_" + name);
        if (!declared) {
            component_.variables[index].once = own;
            return;
        }
        const std::size_t memory = memory_of(*declared);
        StoredVariable& variable = component_.variables[index];
        StoredVariable& stored = component_.variables[memory];
        if (variable.variable->type != stored.variable->type) return refuse_type(part, name);
        variable.memory = memory;
        stored.visible = stored.visible || (declared->shown && variable.visible);
        if (!declared->shown) variable.once = declared->once.empty() ? own : declared->once;
        if (!variable.external || !variable.read) return;
        variable.local = true;
        stored.read = true;
    }

    /// Returns the variable of the composition that a machine's register is connected to. If there is none, the value
    /// of the register is arbitrary.
    [[nodiscard]] std::optional<Declared> declaration_of(std::size_t part, const std::string& name) const {
        const std::size_t index = component_.parts[part].controller;
        const ir::Variable* const own = find_named(contexts_[part]->variables, name);
        if (own == nullptr) return std::nullopt;
        const void* const level =
            module_ == nullptr ? static_cast<const void*>(contexts_[part]) : &module_->controllers[index];
        if (own->scope != ir::VariableScope::required) return Declared{own, level, false, ""};
        if (module_ == nullptr) return Declared{own, nullptr, true, ""};
        if (const ir::Variable* const of_platform = find_named(module_->platform.variables, name))
            return Declared{of_platform, module_, true, ""};
        return Declared{own, level, false, to_identifier(module_->controllers[index].name + "_by_set_" + name)};
    }

    /// Returns the index of the register of a variable of the composition, and adds it if it is missing.
    std::size_t memory_of(const Declared& declared) {
        auto& variables = component_.variables;
        const auto known = std::ranges::find_if(variables, [&](const StoredVariable& other) {
            return other.shared && other.level == declared.level && other.variable->name == declared.variable->name;
        });
        if (known != variables.end()) return static_cast<std::size_t>(known - variables.begin());
        StoredVariable added;
        added.variable = declared.variable;
        added.level = declared.level;
        added.shared = true;
        added.external = declared.level == nullptr;
        added.initial = initial_of(declared);
        variables.push_back(std::move(added));
        return variables.size() - 1;
    }

    /// Returns the declared initial value, or the default of the type. Before the first cycle, a register outside the
    /// component has the default of its type.
    [[nodiscard]] ir::Value initial_of(const Declared& declared) const {
        const ir::Variable& variable = *declared.variable;
        const ir::Value otherwise = ir::default_value(system_, inst_, variable.type);
        if (!variable.initial || declared.level == nullptr) return otherwise;
        const auto value = ir::evaluate_constant(system_, inst_, nullptr, *variable.initial);
        if (!value)
            diagnostics_.report(rules::unsupported_expr, variable.initial->span, {"an initial value", variable.name});
        return value.value_or(otherwise);
    }

    void refuse_type(std::size_t part, const std::string& name) {
        diagnostics_.report(
            rules::no_component, component_.origin.span,
            {component_.name, "the variable '" + name + "' of machine '" + component_.root_unit(part).machine->name +
                                  "' has another type than that of the controller or platform"});
    }

    Component& component_;
    const ir::System& system_;
    const ir::Instantiation& inst_;
    const ir::Module* module_;
    const std::vector<const ir::Controller*>& contexts_;
    diagnostics::Diagnostics& diagnostics_;
};

}  // namespace

void connect_variables(Component& component, const ir::System& system, const ir::Instantiation& inst,
                       const ir::Module* module, const std::vector<const ir::Controller*>& contexts,
                       diagnostics::Diagnostics& diagnostics) {
    VariableConnections(component, system, inst, module, contexts, diagnostics).connect();
}

}  // namespace robochart::cpp_emit
