// SPDX-License-Identifier: Apache-2.0
// Collects the names that CSPM declarations introduce: constructors, modules, and all others.
#include "csp_emit/base/user_names.hpp"

#include "checker/cspm/syntax/lookup.hpp"

namespace robochart::csp_emit {

using cspm::DeclKind;
using cspm::DeclPtr;

UserNames user_names(const std::vector<DeclPtr>& blocks) {
    UserNames result;
    for (const DeclPtr& decl : blocks) {
        if (decl->kind == DeclKind::transparent || decl->kind == DeclKind::external) continue;
        if (decl->kind == DeclKind::annotation || decl->kind == DeclKind::include) continue;
        if (decl->kind == DeclKind::timed) {
            UserNames inside = user_names(decl->decls);
            result.constructors.merge(inside.constructors);
            result.all.merge(inside.all);
            result.modules.merge(inside.modules);
            continue;
        }
        for (const std::string& name : cspm::declared_names(*decl)) result.all.insert(name);
        if (decl->kind == DeclKind::channel) result.constructors.insert(decl->names.begin(), decl->names.end());
        if (decl->kind == DeclKind::module || decl->kind == DeclKind::instance)
            result.modules.insert(decl->names.begin(), decl->names.end());
        for (const cspm::Constructor& constructor : decl->constructors)
            if (decl->kind == DeclKind::datatype) result.constructors.insert(constructor.name);
    }
    return result;
}

}  // namespace robochart::csp_emit
