// SPDX-License-Identifier: Apache-2.0
// Determines the claims of a project that can still be decided if other claims, or components that these claims do not
// use, have errors.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "driver/model/project.hpp"
#include "frontend/project/units.hpp"

namespace robochart::driver {

/// Divides the claims and blocks of a project in two: those that can be decided, and those that have errors or may
/// depend on errors.
struct BrokenClaims {
    /// The files of one side. If both sides contain a file, `texts` contains the text of this file without the items of
    /// the other side, by index in Model::files.
    struct Side {
        frontend::Unit unit;
        std::map<std::size_t, std::string> texts;
    };
    /// A definition that has errors, or that refers to such a definition.
    struct SetAside {
        std::string name;
        diagnostics::Span place;
        std::string cause;
    };
    Side sound;
    Side broken;                      ///< includes the models, which are then read again (Part::again)
    bool some = false;                ///< true if some claim can still be decided
    std::vector<SetAside> set_aside;  ///< definitions that the sound side does not contain
};
/// Returns no value if an error is neither in an assertion file nor in an operation, machine, controller or module, or
/// if all remaining claims could depend on a part that cannot be read. In these cases, no claim is decided.
[[nodiscard]] std::optional<BrokenClaims> broken_claims(const Project&);
/// Returns true if there are errors, and all of them are in assertion files.
[[nodiscard]] bool only_claims_broken(const Project&);

}  // namespace robochart::driver
