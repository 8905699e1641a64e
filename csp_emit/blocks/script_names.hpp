// SPDX-License-Identifier: Apache-2.0
// Lists the names that CSP blocks can use: the declarations of the emitted script, module by module.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "csp_emit/base/emission.hpp"

namespace robochart::csp_emit {

/// A declared name of the script.
struct ScriptName {
    std::string qualifier;  ///< "P::M"; "" at the top
    std::string name;
    cspm::DeclKind kind = cspm::DeclKind::value;
    bool directed = false;  ///< a channel whose first field is `in` or `out`
};

class ScriptNames {
public:
    explicit ScriptNames(const cspm::Script& script);

    [[nodiscard]] const std::vector<ScriptName>& all() const { return names_; }
    /// Returns the names that can follow `QUALIFIER::`, in the order of the script.
    [[nodiscard]] std::vector<const ScriptName*> names_after(std::string_view qualifier) const;
    /// Returns suggestions for a name that a block uses and that is not in scope: the same name in a component, or
    /// similar names. Returns at most three names, the best one first.
    [[nodiscard]] std::vector<std::string> suggest_names(std::string_view written) const;

private:
    void add(const std::vector<cspm::DeclPtr>& decls, const std::string& qualifier);

    std::vector<ScriptName> names_;
    std::map<std::string, const cspm::Decl*> modules_;
};

}  // namespace robochart::csp_emit
