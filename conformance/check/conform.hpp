// Does the generated code refine the model? NF_c(M) [FD= L(G), by exploring the compiled code over all inputs
// (docs/conformance.md; the relation is RoboTool's NormalForm with its three simulation assumptions).
#pragma once

#include "conformance/check/result.hpp"
#include "cpp_emit/runtime/explore_abi.h"
#include "csp_emit/base/emission.hpp"
#include "diagnostics/diagnostic.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// Checks loaded code against the timed script of its model.
[[nodiscard]] Result judge_code(const csp_emit::Emission& script, const ir::System&, const ir::Instantiation&,
                                const ir::ComponentRef&, const rc_interface& code, const Options&);

/// Generates, compiles, explores and checks one component.
[[nodiscard]] Result conform(const ir::System&, const ir::Instantiation&, const ir::ComponentRef& component,
                             const Options&, diagnostics::SourceManager&, diagnostics::Diagnostics&);

}  // namespace robochart::conformance
