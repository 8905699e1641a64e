// SPDX-License-Identifier: Apache-2.0
// Renames the elements of a model to their names in its script. If a name has another meaning in CSPM, the new name is
// the old name with an appended number. Model and code are compared under the new name
// (csp_emit/passes/safe_names.hpp).
#pragma once

#include "base/diagnostics/diagnostic.hpp"
#include "conformance/model/longer_lists.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// The renamed system, which all components of a model share. The renamed system has no CSP blocks and no properties,
/// because both belong to assertions. If a block replaced the instantiation, the model would have other values than the
/// code.
struct RenamedSystem {
    ir::System system;
    ir::Instantiation instantiation;
    bool changed = false;         ///< some name differs
    ListBounds list_bounds = {};  ///< for the types of the lists that the machines build (longer_lists.hpp)
};

/// Renames the system. Reports findings about names to the diagnostics.
[[nodiscard]] RenamedSystem renamed_system(const ir::System&, const ir::Instantiation&, diagnostics::Diagnostics&);
/// Returns the component under its names in the renamed system.
[[nodiscard]] ir::ComponentRef renamed_component(const RenamedSystem&, const ir::ComponentRef&);

struct RenamedModel {
    ir::System system;
    ir::Instantiation instantiation;
    ir::ComponentRef component;
};

/// Returns the renamed system and component.
[[nodiscard]] RenamedModel renamed_model(const ir::System&, const ir::Instantiation&, const ir::ComponentRef&,
                                         diagnostics::Diagnostics&);

}  // namespace robochart::conformance
