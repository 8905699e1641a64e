// SPDX-License-Identifier: Apache-2.0
// Looks up qualified names in the syntax tree of a script. A module is found by its name, and an instance by the name
// of its module.
#include "checker/cspm/syntax/lookup.hpp"

#include <algorithm>

namespace robochart::cspm {

namespace {

constexpr std::string_view separator = "::";

/// The lists of declarations that enclose a name, the outermost first.
using Scopes = std::vector<const std::vector<DeclPtr>*>;

bool declares_name(const Decl& decl, std::string_view name) {
    switch (decl.kind) {
        case DeclKind::value:
            return decl.patterns.front().front()->kind == PatternKind::name &&
                   decl.patterns.front().front()->text == name;
        case DeclKind::function:
        case DeclKind::channel:
        case DeclKind::datatype:
        case DeclKind::subtype:
        case DeclKind::nametype:
        case DeclKind::module:
        case DeclKind::instance:
            return std::ranges::find(decl.names, name) != decl.names.end();
        case DeclKind::timed:
        case DeclKind::transparent:
        case DeclKind::external:
        case DeclKind::annotation:
        case DeclKind::print:
        case DeclKind::assertion:
        case DeclKind::include:
            break;
    }
    return false;
}

/// Finds a declaration in a list. A timed section is no scope, so the declarations inside it are searched too.
DeclPtr find_declared(const std::vector<DeclPtr>& decls, std::string_view name) {
    for (const DeclPtr& decl : decls) {
        if (declares_name(*decl, name)) return decl;
        if (decl->kind != DeclKind::timed) continue;
        if (DeclPtr inside = find_declared(decl->decls, name)) return inside;
    }
    return nullptr;
}

DeclPtr find_inside(const DeclPtr& decl, std::string_view path, const Scopes& scopes);

DeclPtr find_path(std::string_view path, const Scopes& scopes) {
    const std::size_t end = path.find(separator);
    DeclPtr first = find_declared(*scopes.back(), path.substr(0, end));
    if (end == std::string_view::npos || !first) return first;
    return find_inside(first, path.substr(end + separator.size()), scopes);
}

/// Finds the rest of a path inside a declaration. The declaration of an instance must be able to see its module. A
/// module inside another can use the declarations around it.
DeclPtr find_inside(const DeclPtr& decl, std::string_view path, const Scopes& scopes) {
    if (decl->kind == DeclKind::module) {
        for (const auto* part : {&decl->exports, &decl->decls}) {
            Scopes within = scopes;
            within.push_back(part);
            if (DeclPtr result = find_path(path, within)) return result;
        }
        return nullptr;
    }
    if (decl->kind != DeclKind::instance) return nullptr;
    for (Scopes around = scopes; !around.empty(); around.pop_back())
        if (const DeclPtr module = find_path(decl->text, around); module && module->kind == DeclKind::module)
            return find_inside(module, path, around);
    return nullptr;
}

}  // namespace

std::vector<std::string> declared_names(const Decl& decl) {
    std::vector<std::string> names = decl.names;
    if (decl.kind == DeclKind::value)
        for (const PatternPtr& pattern : decl.patterns.front()) names.push_back(pattern->text);
    for (const Constructor& constructor : decl.constructors) names.push_back(constructor.name);
    return names;
}

DeclPtr declaration_of(const Script& script, std::string_view path) {
    if (path.substr(0, separator.size()) == separator) path.remove_prefix(separator.size());
    return find_path(path, {&script.decls});
}

std::vector<DeclPtr> assertions_in(const std::vector<DeclPtr>& decls) {
    std::vector<DeclPtr> result;
    for (const DeclPtr& decl : decls) {
        if (decl->kind == DeclKind::assertion) result.push_back(decl);
        for (const auto* const inside : {&decl->decls, &decl->exports})
            for (DeclPtr& assertion : assertions_in(*inside)) result.push_back(std::move(assertion));
    }
    return result;
}

}  // namespace robochart::cspm
