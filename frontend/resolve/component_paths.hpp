// SPDX-License-Identifier: Apache-2.0
// Finds components by paths through references, such as `Module::controller_ref::machine_ref`. The resolver and the
// code that reads probabilistic assertions use these functions.
#pragma once

#include <optional>
#include <string>

#include "frontend/names/names.hpp"
#include "frontend/names/scopes.hpp"

namespace robochart::frontend {

/// The kinds of declarations that are components in assertions.
extern const Kinds component_kinds;

/// A path of components, and the number of parts of the name that it consumed.
struct Way {
    ComponentPath path;
    std::size_t used = 0;
    std::size_t by_definition = 0;  ///< number of parts that name a definition, although a reference to it exists

    [[nodiscard]] const Declaration* end() const { return path.steps.empty() ? nullptr : path.steps.back(); }
};

/// Returns the first `count` parts of a name.
[[nodiscard]] QualifiedName first_parts(const QualifiedName& name, std::size_t count);
/// True for a component or a reference to one.
[[nodiscard]] bool is_component(const Declaration* part);
/// Returns the platform of this name in a module, or null if there is none.
[[nodiscard]] const Context* platform_of(const Declaration* whole, const std::string& name);
/// Returns the state or final state to which the parts of a name from index `at` lead, or null if there is none.
[[nodiscard]] const State* state_at(const NodeContainer& top, const QualifiedName& name, std::size_t at);
/// Extends the path with the components that the parts of the name denote, from index `at` up to the first part that
/// names no component.
[[nodiscard]] Way walk_components(Way from, const QualifiedName& name, std::size_t at);
/// Returns the path for the longest prefix of the name that leads to declarations. The search starts in the file's
/// package, in its imports, in unnamed packages, and in the package with which the name begins. If it finds nothing and
/// only one component in all packages has the name, the result is that component. If several paths have equally long
/// prefixes, the result is the path with the fewest names of definitions instead of references: `P::S` is the machine S
/// of package P even if P has a controller P with a reference to S. Components of the given dialect (by default that of
/// the file) are preferred to components of the other dialect.
[[nodiscard]] Way component_way(const Model& model, const Names& names, const File& file, const QualifiedName& name,
                                std::optional<Dialect> dialect = std::nullopt);
/// Collects the paths of the inner states with this name, for a suggestion.
void collect_paths_of(const NodeContainer& container, const std::string& name, const std::string& above,
                      std::vector<std::string>& paths);
/// Collects the names of all inner states, for a suggestion.
void collect_states(const NodeContainer& container, std::vector<std::string>& names);

}  // namespace robochart::frontend
