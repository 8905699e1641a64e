// Names of the script. Elements of the model keep RoboTool's names (semantics 3.2, 3.12); names of our own
// (parameters, program points) are made unique against everything that is a channel, constructor or function,
// because a CSPM parameter of such a name would be a constructor pattern.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// Hands out names that nothing else in scope has.
class NameManager {
public:
    void reserve(const std::string& name) { taken_.insert(name); }
    [[nodiscard]] bool taken(const std::string& name) const { return taken_.count(name) != 0; }
    /// `name` itself or `name_2`, `name_3`..., behind an `n` if it does not begin with a letter; the result is taken
    /// from now on.
    [[nodiscard]] std::string unique(const std::string& name);

private:
    std::set<std::string> taken_;
    std::map<std::string, int> last_suffix_;  ///< tried so far for each name, so that long series stay linear
};

/// `A::B` as `A_B`; letters, digits and underscores only.
[[nodiscard]] std::string flatten(std::string_view name);
/// `P::X`, or `X` if the package is unnamed.
[[nodiscard]] std::string qualified(const std::string& package, const std::string& name);
/// The module of a machine: its name, or `OP_o` for an operation.
[[nodiscard]] std::string module_name(const ir::Machine&);
/// A letter, then letters, digits and underscores: the names that CSPM can write.
[[nodiscard]] bool is_identifier(const std::string& name);
/// Keywords of CSPM, its predefined names, those of our library and what is no identifier: no element at the top of the
/// script may carry one.
[[nodiscard]] bool is_reserved(const std::string& name);
/// Those of them that mean something to what is written inside the modules of components.
[[nodiscard]] bool is_reserved_inside(const std::string& name);
/// The name in the script of a parameter or bound variable of the model's: no element ends so.
[[nodiscard]] std::string bound_name(const std::string& name);
/// Whether a name ends as those of our own parameters and processes, or of bound variables, do.
[[nodiscard]] bool ends_as_ours(const std::string& name);
/// What CSPM defines in every script, or in timed sections.
[[nodiscard]] bool is_predefined(const std::string& name);
/// The reserved names, so that a NameManager can avoid them.
void reserve_all(NameManager&);

}  // namespace robochart::csp_emit
