// SPDX-License-Identifier: Apache-2.0
// Chooses the names in the script. Elements of the model have RoboTool's names (semantics 3.2, 3.12). Generated names
// (parameters, program points) differ from all channels, constructors and functions. Otherwise CSPM would read a
// parameter with such a name as a constructor pattern.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// Generates names that are unique in the scope.
class NameManager {
public:
    void reserve(const std::string& name) { taken_.insert(name); }
    [[nodiscard]] bool is_taken(const std::string& name) const { return taken_.count(name) != 0; }
    /// Returns `name`, or `name_2`, `name_3`... if it is already in use. Puts `n` before a name that does not begin
    /// with a letter. Afterwards, the result is in use.
    [[nodiscard]] std::string unique_name(const std::string& name);

private:
    std::set<std::string> taken_;
    std::map<std::string, int> last_suffix_;  ///< for each name, the last suffix that was tried; this makes long series
                                              ///< of names take linear time
};

/// Converts `A::B` to `A_B`. The result contains only letters, digits and underscores.
[[nodiscard]] std::string flatten_name(std::string_view name);
/// Returns `P::X`, or `X` if the package is unnamed.
[[nodiscard]] std::string qualified_name(const std::string& package, const std::string& name);
/// Returns the module of a machine: its name, or `OP_o` for an operation.
[[nodiscard]] std::string module_name(const ir::Machine&);
/// True if CSPM can write the name: a letter, then letters, digits and underscores.
[[nodiscard]] bool is_identifier(const std::string& name);
/// True if an element at the top of the script must not have this name, because it is a keyword of CSPM, a predefined
/// name, a name of our library, or not an identifier.
[[nodiscard]] bool is_reserved(const std::string& name);
/// True if the name is reserved and has a meaning inside the modules of components.
[[nodiscard]] bool is_reserved_inside(const std::string& name);
/// Returns the script's name for a parameter or a bound variable of the model. It has an ending that no element of the
/// model has.
[[nodiscard]] std::string bound_name(const std::string& name);
/// True if the name has the ending of generated parameters and processes, or of bound variables.
[[nodiscard]] bool has_generated_suffix(const std::string& name);
/// True if CSPM predefines the name, in every script or in timed sections.
[[nodiscard]] bool is_predefined(const std::string& name);
/// Marks all reserved names as used in the NameManager.
void reserve_all(NameManager&);

}  // namespace robochart::csp_emit
