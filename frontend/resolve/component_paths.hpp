// Components along paths through references, `Module::controller_ref::machine_ref`: for the resolver, and for what
// reads the paths of probabilistic assertions once more.
#pragma once

#include <string>

#include "frontend/names/names.hpp"
#include "frontend/names/scopes.hpp"

namespace robochart::frontend {

/// What assertions call components.
extern const Kinds component_kinds;

/// A path with the number of parts of the name that it took.
struct Way {
    ComponentPath path;
    std::size_t used = 0;
    std::size_t by_definition = 0;  ///< of these, how many name what is behind a reference, and not the reference

    [[nodiscard]] const Declaration* end() const { return path.steps.empty() ? nullptr : path.steps.back(); }
};

/// The name's first parts.
[[nodiscard]] QualifiedName first_parts(const QualifiedName& name, std::size_t count);
/// Is it a component, or a reference to one?
[[nodiscard]] bool is_component(const Declaration* part);
/// The platform of this name in a module; null if there is none.
[[nodiscard]] const Context* platform_of(const Declaration* whole, const std::string& name);
/// The state or final state that the parts of a name from `at` on lead to; null if there is none.
[[nodiscard]] const State* state_at(const NodeContainer& top, const QualifiedName& name, std::size_t at);
/// Goes on from a component along the parts of a name from `at` on, as far as they name components.
[[nodiscard]] Way walk_components(Way from, const QualifiedName& name, std::size_t at);
/// The declarations that the longest beginning of a name leads to, from the file's package, its imports, unnamed
/// packages or a package that is written in front; else from any package, if there is one component of the name. Of
/// equally long beginnings that with the fewest names of definitions in the place of references is meant: `P::S` is the
/// machine S of package P even where P has a controller P with a reference to S.
[[nodiscard]] Way component_way(const Model& model, const Names& names, const File& file, const QualifiedName& name);
/// The paths of the states inside that are called so, for a suggestion.
void collect_paths_of(const NodeContainer& container, const std::string& name, const std::string& above,
                      std::vector<std::string>& paths);
/// The names of all states inside, for a suggestion.
void collect_states(const NodeContainer& container, std::vector<std::string>& names);

}  // namespace robochart::frontend
