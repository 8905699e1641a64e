// SPDX-License-Identifier: Apache-2.0
// The model with the names of its script. If a name has another meaning in CSPM, model and code are compared under the
// name with a number appended (csp_emit/passes/safe_names.hpp).
#pragma once

#include "base/diagnostics/diagnostic.hpp"
#include "conformance/model/longer_lists.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// The renamed system, which all components of a model share. It has no CSP blocks and no properties, which belong to
/// assertions: a block that replaces the instantiation would give the model other values than the code.
struct RenamedSystem {
    ir::System system;
    ir::Instantiation instantiation;
    bool changed = false;         ///< some name differs
    ListBounds list_bounds = {};  ///< for the types of the lists that the machines build (longer_lists.hpp)
};

/// Reports findings about names to the diagnostics.
[[nodiscard]] RenamedSystem renamed_system(const ir::System&, const ir::Instantiation&, diagnostics::Diagnostics&);
/// The component under its names in the renamed system.
[[nodiscard]] ir::ComponentRef renamed_component(const RenamedSystem&, const ir::ComponentRef&);

struct RenamedModel {
    ir::System system;
    ir::Instantiation instantiation;
    ir::ComponentRef component;
};

/// The renamed system and component.
[[nodiscard]] RenamedModel renamed_model(const ir::System&, const ir::Instantiation&, const ir::ComponentRef&,
                                         diagnostics::Diagnostics&);

}  // namespace robochart::conformance
