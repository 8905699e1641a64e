// SPDX-License-Identifier: Apache-2.0
// Gives the types of CSPM's built-in names in FDR's notation (FDR manual, "Built-in definitions").
#pragma once

#include <map>
#include <string_view>

#include "checker/cspm/types/terms.hpp"

namespace robochart::cspm::types {

class BuiltinTypes {
public:
    explicit BuiltinTypes(TypeStore& store) : store_(store) {}

    enum class Where { script, timed_section, transparent_line, external_line };
    /// Returns the built-in with this name if a script may use or import it in such a place, otherwise null.
    Symbol* find(std::string_view name, Where where);
    /// Returns the line that a script needs to use an extra function ("transparent" or "external"). Returns "timed" for
    /// functions that exist only in timed sections, and "" for all others.
    [[nodiscard]] static std::string_view hint(std::string_view name);

private:
    TypeStore& store_;
    std::map<std::string_view, Symbol> made_;
};

}  // namespace robochart::cspm::types
