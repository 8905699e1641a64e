// SPDX-License-Identifier: Apache-2.0
// Components found along paths through references, such as `Module::controller_ref::machine_ref`. The resolver uses
// them, and so do readers of the paths in probabilistic assertions.
#pragma once

#include <optional>
#include <string>

#include "frontend/names/names.hpp"
#include "frontend/names/scopes.hpp"

namespace robochart::frontend {

/// The kinds that assertions call components.
extern const Kinds component_kinds;

/// A path, and the number of name parts that it uses.
struct Way {
    ComponentPath path;
    std::size_t used = 0;
    std::size_t by_definition = 0;  ///< number of parts that name a definition instead of the reference to it

    [[nodiscard]] const Declaration* end() const { return path.steps.empty() ? nullptr : path.steps.back(); }
};

/// The first `count` parts of a name.
[[nodiscard]] QualifiedName first_parts(const QualifiedName& name, std::size_t count);
/// True for a component or a reference to one.
[[nodiscard]] bool is_component(const Declaration* part);
/// The platform of this name in a module; null if there is none.
[[nodiscard]] const Context* platform_of(const Declaration* whole, const std::string& name);
/// The state or final state to which the parts of a name from index `at` lead; null if there is none.
[[nodiscard]] const State* state_at(const NodeContainer& top, const QualifiedName& name, std::size_t at);
/// Extends a path along the parts of a name from index `at`, while they name components.
[[nodiscard]] Way walk_components(Way from, const QualifiedName& name, std::size_t at);
/// The path for the longest prefix of the name that leads to declarations. The search starts at the file's package, its
/// imports, unnamed packages, or the package with which the name begins. If it fails and only one component of all
/// packages has the name, the result is that component. If several paths have equally long prefixes, the result is the
/// path with the fewest names of definitions instead of references: `P::S` is the machine S of package P even if P has
/// a controller P with a reference to S. Components of the dialect, which is the file's unless one is given, are
/// preferred to those of the other.
[[nodiscard]] Way component_way(const Model& model, const Names& names, const File& file, const QualifiedName& name,
                                std::optional<Dialect> dialect = std::nullopt);
/// Collects the paths of the inner states with this name, for a suggestion.
void collect_paths_of(const NodeContainer& container, const std::string& name, const std::string& above,
                      std::vector<std::string>& paths);
/// Collects the names of all inner states, for a suggestion.
void collect_states(const NodeContainer& container, std::vector<std::string>& names);

}  // namespace robochart::frontend
