// What conformance needs to know about a component besides its code: where its process and events are in the script,
// what its numbers mean, and which external writes cannot matter.
#pragma once

#include <string>
#include <vector>

#include "conformance/code/interface.hpp"
#include "csp_emit/emit.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// "P::S": the qualified CSPM module of the component.
[[nodiscard]] std::string component_prefix(const ir::ComponentRef&);

/// The component's process `D__` applied to its default constants; null if the script has none.
[[nodiscard]] cspm::ExprPtr component_process(const cspm::Script&, const ir::ComponentRef&);

/// Sets the component prefix, gives registers and outputs the carriers of the model's types, and blocks the external
/// writes to variables that the model never reads (docs/conformance.md, "Variables written from outside").
void complete(Interface&, const ir::System&, const ir::Instantiation&, const ir::ComponentRef&,
              const csp_emit::Provenance&);

/// Required variables of the component that no expression of its machines depends on.
[[nodiscard]] std::vector<std::string> unread_variables(const ir::System&, const ir::ComponentRef&);

}  // namespace robochart::conformance
