// SPDX-License-Identifier: Apache-2.0
#include "tests/csp_emit/robotool_scripts.hpp"

#include <algorithm>

#include "checker/cspm/syntax/build.hpp"

namespace robochart::csp_emit::testing {

namespace b = cspm::build;
using cspm::DeclKind;
using cspm::DeclPtr;

std::set<std::string> names_of(const std::vector<DeclPtr>& decls) {
    std::set<std::string> result;
    for (const DeclPtr& decl : decls) {
        result.insert(decl->names.begin(), decl->names.end());
        if (decl->kind == DeclKind::value && !decl->patterns.empty())
            for (const auto& pattern : decl->patterns.front()) result.insert(pattern->text);
        const auto inner = names_of(decl->kind == DeclKind::timed ? decl->decls : std::vector<DeclPtr>{});
        result.insert(inner.begin(), inner.end());
    }
    return result;
}

namespace {

bool defines_nothing_new(const DeclPtr& decl, const std::set<std::string>& known) {
    const auto names = names_of({decl});
    return std::ranges::any_of(names, [&](const std::string& n) { return known.count(n) != 0; });
}

}  // namespace

cspm::Script join_scripts(const cspm::Script& theirs, const Emission& ours) {
    const auto known = names_of(theirs.decls);
    cspm::Script result = theirs;
    std::erase_if(result.decls, [](const DeclPtr& decl) { return decl->kind == DeclKind::assertion; });
    std::vector<DeclPtr> components;
    for (const DeclPtr& decl : ours.definitions.decls) {
        if (decl->kind == DeclKind::module)
            components.push_back(decl);
        else if (decl->kind != DeclKind::timed && !defines_nothing_new(decl, known))
            result.decls.push_back(decl);
    }
    result.decls.push_back(b::module_("ours__", {}, {}, components));
    return result;
}

}  // namespace robochart::csp_emit::testing
