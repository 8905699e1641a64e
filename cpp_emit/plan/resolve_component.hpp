// SPDX-License-Identifier: Apache-2.0
// Collects the data about a component of the IR that generation needs.
#pragma once

#include <optional>

#include "base/diagnostics/diagnostic.hpp"
#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Returns the component for the reference. Reports elements for which no code can be generated, and returns no value
/// after errors.
[[nodiscard]] std::optional<Component> resolve_component(const ir::System&, const ir::Instantiation&,
                                                         const ir::ComponentRef&, diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit
