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
    std::size_t used = 0;                    ///< how many parts of the name it took
};

/// The component that the longest prefix of `name` leads to, from the file's package, its imports, unnamed packages,
/// a written package, or else any package where it is the only one of that name.
[[nodiscard]] std::optional<FoundComponent> find_component(const Lowering&, const frontend::File&,
                                                           const frontend::QualifiedName& name);
/// Goes on from a component as far as the names lead; `used` counts from `from`.
[[nodiscard]] FoundComponent walk(const Lowering&, FoundComponent from, const std::vector<std::string>& names);
/// The node of a machine by the names of a path below it; null if there is none.
[[nodiscard]] const Node* find_node(const Machine&, const std::vector<std::string>& names, std::size_t from);
/// Every component of the System, for suggestions.
[[nodiscard]] std::vector<std::string> component_paths(const Lowering&);
/// All parts below a component that run this machine: controller parts, through the controllers of a module.
[[nodiscard]] std::vector<FoundComponent> instances_of(const Lowering&, const FoundComponent& above, MachineId);

}  // namespace robochart::ir
