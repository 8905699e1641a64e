// SPDX-License-Identifier: Apache-2.0
// Determines which shipped headers a component needs, and which types have values that its expressions enumerate.
#pragma once

#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Fills Component::carriers, matrices, toolkit, strings and ordered from the types and expressions of its units.
void collect_uses(Component&, const ir::System&);

}  // namespace robochart::cpp_emit
