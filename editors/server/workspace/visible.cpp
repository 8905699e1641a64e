// SPDX-License-Identifier: Apache-2.0
// Enumerates the visible names: first from the place outwards, then names of the package, names of imports, and
// qualified names.
#include "editors/server/workspace/visible.hpp"

#include <algorithm>
#include <set>

namespace robochart::lsp {

using namespace frontend;

namespace {

const Declaration* search_inside(const Declaration& in, Span name) {
    if (in.name_span == name) return &in;
    if (in.span.is_known() && (name.begin < in.span.begin || name.begin > in.span.end)) return nullptr;
    const auto among = [&](const auto& list) -> const Declaration* {
        for (const auto& declaration : list)
            if (const Declaration* found = search_inside(*declaration, name)) return found;
        return nullptr;
    };
    if (const auto* container = dynamic_cast<const NodeContainer*>(&in)) {
        if (const Declaration* found = among(container->nodes)) return found;
        if (const Declaration* found = among(container->transitions)) return found;
    }
    if (const auto* component = dynamic_cast<const Component*>(&in)) return among(component->order);
    return nullptr;
}

std::string join_parts(const std::vector<std::string>& parts, std::size_t count) {
    std::string out;
    for (std::size_t i = 0; i < count; ++i) out += (i > 0 ? "::" : "") + parts[i];
    return out;
}

void add_with_literals(std::vector<const Declaration*>& list, const Declaration& declaration) {
    list.push_back(&declaration);
    if (const auto* type = dynamic_cast<const TypeDeclaration*>(&declaration))
        for (const auto& literal : type->literals) list.push_back(literal.get());
}

bool imports_all(const File& file, const std::string& package) {
    return std::ranges::any_of(file.imports,
                               [&](const Import& import) { return import.wildcard && import.name.text() == package; });
}

bool imports_one(const File& file, const std::string& full_name) {
    return std::ranges::any_of(
        file.imports, [&](const Import& import) { return !import.wildcard && import.name.text() == full_name; });
}

/// Returns the declaration `A::B` after a package name of `first` parts; null if there is none.
const Declaration* declaration_along(const std::vector<const Declaration*>& start, const std::vector<std::string>& path,
                                     std::size_t first) {
    const auto found =
        std::ranges::find_if(start, [&](const Declaration* declaration) { return declaration->name == path[first]; });
    const Declaration* at = found != start.end() ? *found : nullptr;
    for (std::size_t i = first + 1; i < path.size() && at != nullptr; ++i) at = member_of(*at, path[i]);
    return at;
}

std::vector<const Declaration*> of_package(const Model& model, const std::string& package) {
    std::vector<const Declaration*> list;
    for (const auto& file : model.files)
        if (file->package.text() == package)
            for (const auto& declaration : file->declarations) add_with_literals(list, *declaration);
    return list;
}

}  // namespace

const Declaration* declared_at(const File& file, Span name) {
    if (!name.is_known()) return nullptr;
    for (const auto& declaration : file.declarations)
        if (const Declaration* found = search_inside(*declaration, name)) return found;
    return nullptr;
}

std::vector<const Declaration*> visible_from(const Model& model, const File& from) {
    std::vector<const Declaration*> list;
    for (const auto& file : model.files) {
        const std::string package = file->package.text();
        const bool whole = package.empty() || package == from.package.text() || imports_all(from, package);
        for (const auto& declaration : file->declarations)
            if (whole || imports_one(from, package + "::" + declaration->name)) add_with_literals(list, *declaration);
    }
    return list;
}

std::vector<const Declaration*> declarations_after(const Model& model, const File& from,
                                                   const std::vector<std::string>& qualifier) {
    std::vector<const Declaration*> list = of_package(model, join_parts(qualifier, qualifier.size()));
    for (std::size_t packages = 0; packages < qualifier.size(); ++packages) {
        const auto start =
            packages == 0 ? visible_from(model, from) : of_package(model, join_parts(qualifier, packages));
        if (const Declaration* found = declaration_along(start, qualifier, packages)) {
            const auto members = members_of(*found);
            list.insert(list.end(), members.begin(), members.end());
            break;
        }
    }
    return list;
}

std::vector<std::string> packages_behind(const Model& model, const std::vector<std::string>& qualifier) {
    std::set<std::string> names;
    for (const auto& file : model.files) {
        const auto& parts = file->package.parts;
        if (qualifier.empty() && file->package.text() == "core") continue;  // always visible
        if (parts.size() > qualifier.size() && std::equal(qualifier.begin(), qualifier.end(), parts.begin()))
            names.insert(parts[qualifier.size()]);
    }
    return {names.begin(), names.end()};
}

}  // namespace robochart::lsp
