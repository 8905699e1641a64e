// SPDX-License-Identifier: Apache-2.0
// Finds the data about a component that conformance needs in addition to its code: the process and the events in the
// script, the meaning of numbers, and external writes without effect.
#pragma once

#include <string>
#include <vector>

#include "conformance/code/interface.hpp"
#include "csp_emit/emit.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// Returns the qualified CSPM module of the component, such as "P::S".
[[nodiscard]] std::string component_prefix(const ir::ComponentRef&);

/// Returns the component's process `D__`, applied to its default constants. Returns null if the script does not contain
/// the component.
[[nodiscard]] cspm::ExprPtr component_process(const cspm::Script&, const ir::ComponentRef&);

/// Sets the component prefix. Sets the carriers of registers and outputs to the model's types. Blocks the external
/// writes to variables that the model never reads (docs/conformance.md, "Variables written from outside").
void complete_interface(Interface&, const ir::System&, const ir::Instantiation&, const ir::ComponentRef&,
                        const csp_emit::Provenance&);

/// Returns the required variables of the component that no expression of its machines reads.
[[nodiscard]] std::vector<std::string> unread_variables(const ir::System&, const ir::ComponentRef&);

}  // namespace robochart::conformance
