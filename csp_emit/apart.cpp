// See apart.hpp. What both declare at the top under one name and nobody can rename, a channel of RoboTool's library or
// a component, stays as it is: the type checker says where it is declared twice.
#include "csp_emit/apart.hpp"

#include "checker/cspm/builtins.hpp"
#include "checker/cspm/lookup.hpp"

namespace robochart::csp_emit {

using cspm::DeclKind;
using cspm::DeclPtr;

namespace {

bool predefined(const std::string& name) {
    const cspm::BuiltinName* builtin = cspm::find_builtin(name);
    if (builtin == nullptr) return false;
    return builtin->visibility == cspm::Visibility::always || builtin->visibility == cspm::Visibility::timed_sections;
}

}  // namespace

UserNames user_names(const std::vector<DeclPtr>& blocks) {
    UserNames result;
    for (const DeclPtr& decl : blocks) {
        if (decl->kind == DeclKind::transparent || decl->kind == DeclKind::external) continue;
        if (decl->kind == DeclKind::timed) {
            UserNames inside = user_names(decl->decls);
            result.constructors.merge(inside.constructors);
            result.all.merge(inside.all);
            continue;
        }
        for (const std::string& name : cspm::declared_names(*decl)) result.all.insert(name);
        if (decl->kind == DeclKind::channel) result.constructors.insert(decl->names.begin(), decl->names.end());
        for (const cspm::Constructor& each : decl->constructors)
            if (decl->kind == DeclKind::datatype) result.constructors.insert(each.name);
    }
    result.functions = defined_names(blocks);
    return result;
}

std::set<std::string> defined_names(const std::vector<DeclPtr>& decls) {
    std::set<std::string> result;
    for (const DeclPtr& decl : decls) {
        if (decl->kind == DeclKind::function) result.insert(decl->names.begin(), decl->names.end());
        if (decl->kind == DeclKind::value && decl->patterns.front().front()->kind == cspm::PatternKind::name)
            result.insert(decl->patterns.front().front()->text);
        if (decl->kind == DeclKind::timed) result.merge(defined_names(decl->decls));
    }
    return result;
}

cspm::NewNames new_names_of_ours(const UserNames& theirs, const std::vector<DeclPtr>& library,
                                 const std::vector<DeclPtr>& generated, NameManager& names) {
    cspm::NewNames result;
    const auto rename = [&](const std::string& name) { result.try_emplace(name, names.unique(name)); };
    if (!theirs.constructors.empty())
        for (const std::string& name : cspm::bound_names(generated))
            if (theirs.constructors.contains(name)) rename(name);
    for (const std::string& name : defined_names(library))
        if (theirs.all.contains(name)) rename(name);
    if (theirs.all.contains("r__")) rename("r__");
    return result;
}

cspm::NewNames new_names_of_theirs(const UserNames& theirs, const std::vector<DeclPtr>& generated, NameManager& names) {
    cspm::NewNames result;
    const auto rename = [&](const std::string& name) { result.try_emplace(name, names.unique(name)); };
    for (const std::string& name : theirs.all)
        if (predefined(name)) rename(name);
    if (!theirs.constructors.empty())
        for (const std::string& name : cspm::value_names(generated))
            if (theirs.constructors.contains(name)) rename(name);
    return result;
}

}  // namespace robochart::csp_emit
