// SPDX-License-Identifier: Apache-2.0
// The data about a component, other than its code, that conformance needs: its process and events in the script, the
// meaning of its numbers, and external writes that cannot matter.
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

/// Sets the component prefix, sets the carriers of registers and outputs to the model's types, and blocks the external
/// writes to variables that the model never reads (docs/conformance.md, "Variables written from outside").
void complete(Interface&, const ir::System&, const ir::Instantiation&, const ir::ComponentRef&,
              const csp_emit::Provenance&);

/// Required variables of the component on which no expression of its machines depends.
[[nodiscard]] std::vector<std::string> unread_variables(const ir::System&, const ir::ComponentRef&);

}  // namespace robochart::conformance
