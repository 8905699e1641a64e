// The model under the names that its script keeps: where CSPM means something else by a name, model and code are
// compared under the name with a number behind it (csp_emit/passes/safe_names.hpp).
#pragma once

#include "diagnostics/diagnostic.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

struct RenamedModel {
    ir::System system;
    ir::Instantiation instantiation;
    ir::ComponentRef component;
};

/// Without CSP blocks and properties, which belong to assertions.
[[nodiscard]] RenamedModel renamed_model(const ir::System&, const ir::Instantiation&, const ir::ComponentRef&,
                                         diagnostics::Diagnostics&);

}  // namespace robochart::conformance
