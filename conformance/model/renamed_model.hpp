// The model under the names that its script keeps: where CSPM means something else by a name, model and code are
// compared under the name with a number behind it (csp_emit/passes/safe_names.hpp).
#pragma once

#include "diagnostics/diagnostic.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// The same for all components of a model. Without CSP blocks and properties, which belong to assertions: a block that
/// replaces the instantiation would make the model range over other values than the code.
struct RenamedSystem {
    ir::System system;
    ir::Instantiation instantiation;
    bool changed = false;  ///< some name is another
};

/// Findings about names go to the diagnostics.
[[nodiscard]] RenamedSystem renamed_system(const ir::System&, const ir::Instantiation&, diagnostics::Diagnostics&);
/// The same component under the names that it has there.
[[nodiscard]] ir::ComponentRef renamed_component(const RenamedSystem&, const ir::ComponentRef&);

struct RenamedModel {
    ir::System system;
    ir::Instantiation instantiation;
    ir::ComponentRef component;
};

/// Both, for one component.
[[nodiscard]] RenamedModel renamed_model(const ir::System&, const ir::Instantiation&, const ir::ComponentRef&,
                                         diagnostics::Diagnostics&);

}  // namespace robochart::conformance
