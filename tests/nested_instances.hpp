// SPDX-License-Identifier: Apache-2.0
// Finds instances inside parameterised modules. FDR's front end accepts them and cannot evaluate them: an instance of
// the module does not contain the names of the nested instance, so their first use ends with "lookup not found".
#pragma once

#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::tests {

/// Returns "M::i" for each instance i anywhere inside a parameterised module M.
inline std::vector<std::string> nested_instances(const std::vector<cspm::DeclPtr>& decls, const std::string& path = "",
                                                 bool parameterised = false) {
    std::vector<std::string> result;
    for (const cspm::DeclPtr& decl : decls) {
        const std::string name = path + (decl->names.empty() ? "" : decl->names.front());
        if (decl->kind == cspm::DeclKind::instance && parameterised) result.push_back(name);
        for (const auto* const inside : {&decl->decls, &decl->exports}) {
            const bool around = parameterised || !decl->parameters.empty();
            const std::string below = decl->kind == cspm::DeclKind::module ? name + "::" : path;
            for (std::string& instance : nested_instances(*inside, below, around))
                result.push_back(std::move(instance));
        }
    }
    return result;
}

}  // namespace robochart::tests
