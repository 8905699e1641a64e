// SPDX-License-Identifier: Apache-2.0
// Combines a model with values for its constants. An instance packs states and compiles expressions over them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "prism/checks/checked.hpp"
#include "prism/explore/code.hpp"
#include "prism/explore/layout.hpp"

namespace robochart::prism {

class Instance {
public:
    /// `model` must outlive the object. Throws EvaluationError.
    Instance(const CheckedModel& model, const Values& constants);

    [[nodiscard]] const CheckedModel& model() const { return model_; }
    /// Returns the values of the model's constants.
    [[nodiscard]] const Values& constants() const { return constants_; }
    [[nodiscard]] const Layout& layout() const { return layout_; }
    /// Returns an object that compiles and evaluates expressions over the states, with additional constants. In a
    /// state, two booleans with the following names may come after the values of the variables. Throws EvaluationError.
    [[nodiscard]] Code code(const Values& more = {}) const;

    /// The names of the booleans that follow the variables in a state. They tell whether the state is a deadlock and
    /// whether it is initial.
    static constexpr const char* deadlock_name = "\"deadlock\"";
    static constexpr const char* initial_name = "\"init\"";

private:
    const CheckedModel& model_;
    Values constants_;
    Layout layout_;
};

/// Calls `found` with the values of each initial state. For init ... endinit, it assigns the variables one after the
/// other, and evaluates each conjunct as soon as its variables have values. Throws EvaluationError.
void list_initial_states(const Instance& instance, Code& code, diagnostics::Budget* budget,
                         const std::function<void(const std::int32_t*)>& found);

}  // namespace robochart::prism
