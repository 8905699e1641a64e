// SPDX-License-Identifier: Apache-2.0
// Makes the model with the seeded fault of a run. The plan is that of the unchanged model.
#pragma once

#include <deque>
#include <optional>

#include "cpp_emit/faults/mutation.hpp"
#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// The input of the emitters. Without a fault, it is the model and its component. A fault changes the units' machines,
/// initial values, or the preconditions of functions. The rest of the plan (stored variables, the boundary, capacities)
/// is that of the model, so that code with a fault has the same interface.
class FaultyModel {
public:
    /// All arguments must outlive the object.
    FaultyModel(const ir::System&, const ir::Instantiation&, const Component&, Mutation&);
    FaultyModel(const FaultyModel&) = delete;
    FaultyModel& operator=(const FaultyModel&) = delete;

    [[nodiscard]] const ir::System& system() const { return changed_system_ ? *changed_system_ : system_; }
    [[nodiscard]] const Component& component() const { return changed_component_ ? *changed_component_ : component_; }

private:
    void change_functions(const ir::Instantiation&, Mutation&);
    void change_initials(const ir::Instantiation&, Mutation&);

    const ir::System& system_;
    const Component& component_;
    std::deque<ir::Machine> machines_;  ///< machines of the changed component's units
    std::optional<ir::System> changed_system_;
    std::optional<Component> changed_component_;
};

}  // namespace robochart::cpp_emit
