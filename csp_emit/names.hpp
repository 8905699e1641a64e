// Names of the script. Elements of the model keep RoboTool's names (semantics 3.2, 3.12); names of our own
// (parameters, program points) are made unique against everything that is a channel, constructor or function,
// because a CSPM parameter of such a name would be a constructor pattern (checkers.md 3).
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "semantics/ir.hpp"

namespace robochart::csp_emit {

/// Hands out names that nothing else in scope has.
class NameManager {
public:
    void reserve(const std::string& name) { taken_.insert(name); }
    [[nodiscard]] bool taken(const std::string& name) const { return taken_.count(name) != 0; }
    /// `wanted` itself or `wanted_2`, `wanted_3`...; the result is taken from now on.
    [[nodiscard]] std::string unique(const std::string& wanted);

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
/// Keywords of CSPM, its predefined names and those of our library: no element at the top of the script may carry one.
[[nodiscard]] bool is_reserved(const std::string& name);
/// Those of them that mean something to what is written inside the modules of components.
[[nodiscard]] bool is_reserved_inside(const std::string& name);
/// The reserved names, so that a NameManager can avoid them.
void reserve_all(NameManager&);

}  // namespace robochart::csp_emit
