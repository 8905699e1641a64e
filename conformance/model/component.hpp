// SPDX-License-Identifier: Apache-2.0
// Finds the data that the conformance check of a component needs in addition to the code: the process and the events in
// the script, the meaning of numbers, and the external writes without effect.
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

/// Returns the component's process `D__`, applied to the default constants of the component. Returns null if the script
/// does not contain the component.
[[nodiscard]] cspm::ExprPtr component_process(const cspm::Script&, const ir::ComponentRef&);

/// Completes the interface of the code with the data of the model. Sets the component prefix, and sets the carriers of
/// registers and outputs according to the model's types. Blocks the external writes of variables that the model never
/// reads (docs/conformance.md, "Variables written from outside").
void complete_interface(Interface&, const ir::System&, const ir::Instantiation&, const ir::ComponentRef&,
                        const csp_emit::Provenance&);

/// Returns the required variables of the component that no expression of its machines reads.
[[nodiscard]] std::vector<std::string> unread_variables(const ir::System&, const ir::ComponentRef&);

}  // namespace robochart::conformance
