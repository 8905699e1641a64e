// Component paths of assertions, walked through references. Private to semantics/lower*.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "semantics/lower/lowering.hpp"

namespace robochart::ir {

/// A component found by a path, with what lies above it.
struct FoundComponent {
    ComponentRef ref;
    const Module* module = nullptr;          ///< the path goes through it
    const Controller* controller = nullptr;  ///< the path goes through it, or the controller itself
    const Machine* machine = nullptr;        ///< the machine or operation itself
    std::string part;                        ///< of a machine inside a controller: name of the instance or definition
};

/// The component at the end of a path that name resolution found; empty if the path leads nowhere.
[[nodiscard]] std::optional<FoundComponent> component_at(const Lowering&, const frontend::ComponentPath&);

}  // namespace robochart::ir
