// SPDX-License-Identifier: Apache-2.0
// Follows component paths of assertions through references. Private to semantics/lower*.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "semantics/lower/lowering.hpp"

namespace robochart::ir {

/// A component found by a path, with the components that contain it.
struct FoundComponent {
    ComponentRef ref;
    const Module* module = nullptr;          ///< set if the path leads through a module
    const Controller* controller = nullptr;  ///< set if the path leads through or to a controller
    const Machine* machine = nullptr;        ///< set if the path leads to a machine or operation
    std::string part;                        ///< the name of the instance or definition, for a machine in a controller
};

/// Returns the component at the end of a path that name resolution found, or no value if the path is unresolved.
[[nodiscard]] std::optional<FoundComponent> component_at(const Lowering&, const frontend::ComponentPath&);

}  // namespace robochart::ir
