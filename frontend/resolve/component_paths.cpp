// SPDX-License-Identifier: Apache-2.0
// See component_paths.hpp.
#include "frontend/resolve/component_paths.hpp"

#include <algorithm>

namespace robochart::frontend {

const Kinds component_kinds = {DeclKind::module, DeclKind::controller, DeclKind::state_machine, DeclKind::operation,
                               DeclKind::simulation};

QualifiedName first_parts(const QualifiedName& name, std::size_t count) {
    QualifiedName result;
    const auto n = static_cast<std::ptrdiff_t>(count);
    result.parts.assign(name.parts.begin(), name.parts.begin() + n);
    result.spans.assign(name.spans.begin(), name.spans.begin() + n);
    result.span = name.span;
    return result;
}

bool is_component(const Declaration* part) {
    const Declaration* behind = follow_reference(part);
    return behind != nullptr && component_kinds.has(behind->kind);
}

const Context* platform_of(const Declaration* whole, const std::string& name) {
    const auto* module = follow_to<Component>(whole);
    if (module == nullptr) return nullptr;
    for (const Declaration* part : module->order) {
        const auto* behind = follow_to<Context>(part);
        if (part->name == name && behind != nullptr && behind->kind == DeclKind::platform) return behind;
    }
    return nullptr;
}

namespace {

/// Returns the component with this name in a module or controller. If there is none, the result is the reference to a
/// definition with this simple name, if only one exists.
const Declaration* part_of(const Declaration* whole, const std::string& name) {
    const auto* component = follow_to<Component>(whole);
    if (component == nullptr) return nullptr;
    const Declaration* by_definition = nullptr;
    for (const Declaration* part : component->order) {
        if (!is_component(part)) continue;
        if (part->name == name) return part;
        const Declaration* behind = follow_reference(part);
        const bool process = behind->kind == DeclKind::operation && name == "OP_" + behind->name;
        if (behind->name != name && !process) continue;
        if (by_definition != nullptr) return nullptr;
        by_definition = part;
    }
    return by_definition;
}

/// Returns the only component of this name and dialect in any package.
const Declaration* in_some_package(const Model& model, const std::string& name, Dialect dialect) {
    const Declaration* found = nullptr;
    for (const auto& file : model.files) {
        if (file->dialect != dialect) continue;
        for (const auto& declaration : file->declarations) {
            if (declaration->name != name || !component_kinds.has(declaration->kind)) continue;
            if (found != nullptr) return nullptr;
            found = declaration.get();
        }
    }
    return found;
}

}  // namespace

const State* state_at(const NodeContainer& top, const QualifiedName& name, std::size_t at) {
    const NodeContainer* container = &top;
    const State* state = nullptr;
    for (std::size_t i = at; i < name.parts.size(); ++i) {
        const auto& nodes = container->nodes;
        const auto found = std::ranges::find_if(nodes, [&](const auto& node) { return node->name == name.parts[i]; });
        if (found == nodes.end()) return nullptr;
        state = found->get();
        container = state;
    }
    const bool fits = state != nullptr && (state->kind == DeclKind::state || state->kind == DeclKind::final);
    return fits ? state : nullptr;
}

Way walk_components(Way from, const QualifiedName& name, std::size_t at) {
    from.used = at;
    while (from.used < name.parts.size()) {
        const Declaration* part = part_of(from.end(), name.parts[from.used]);
        if (part == nullptr) break;
        if (part->name != name.parts[from.used]) ++from.by_definition;
        from.path.steps.push_back(part);
        ++from.used;
    }
    return from;
}

Way component_way(const Model& model, const Names& names, const File& file, const QualifiedName& name,
                  std::optional<Dialect> dialect) {
    Way best;
    const auto try_top = [&](const Declaration* top, std::size_t parts) {
        if (top == nullptr) return;
        Way found = walk_components({{{top}, nullptr}, 0, 0}, name, parts);
        const bool better =
            found.used > best.used || (found.used == best.used && found.by_definition < best.by_definition);
        if (better) best = std::move(found);
    };
    const std::size_t most = std::min(name.parts.size(), names.most_parts());
    for (std::size_t parts = 1; parts <= most; ++parts)
        try_top(names.find({&file, nullptr, dialect}, first_parts(name, parts), component_kinds), parts);
    const Dialect own = dialect.value_or(file.dialect);
    const Dialect other = own == Dialect::robosim ? Dialect::robochart : Dialect::robosim;
    for (const Dialect one : {own, other})
        if (best.used == 0 && !name.empty()) try_top(in_some_package(model, name.parts.front(), one), 1);
    return best;
}

void collect_paths_of(const NodeContainer& container, const std::string& name, const std::string& above,
                      std::vector<std::string>& paths) {
    for (const auto& node : container.nodes) {
        const std::string path = above + node->name;
        const bool state = node->kind == DeclKind::state || node->kind == DeclKind::final;
        if (state && node->name == name) paths.push_back(path);
        collect_paths_of(*node, name, path + "::", paths);
    }
}

void collect_states(const NodeContainer& container, std::vector<std::string>& names) {
    for (const auto& node : container.nodes) {
        if (node->kind == DeclKind::state || node->kind == DeclKind::final) names.push_back(node->name);
        collect_states(*node, names);
    }
}

}  // namespace robochart::frontend
