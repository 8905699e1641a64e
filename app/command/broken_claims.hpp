// Assertion files with errors: which claims of a project can be decided all the same.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "app/command/pipeline.hpp"
#include "frontend/project/units.hpp"

namespace robochart::app {

/// The claims and blocks of a project in two: what can be decided, and what has errors or may depend on what has.
struct BrokenClaims {
    /// Files of a unit, and for those that are in it in part their texts without the rest, by place in Model::files.
    struct Side {
        frontend::Unit unit;
        std::map<std::size_t, std::string> texts;
    };
    Side sound;
    Side broken;        ///< with the models too (`again`)
    bool some = false;  ///< a claim is left that can be decided
};
/// Nothing where an error is not in an assertion file, or where whatever is left could depend on a part that cannot be
/// read: then nothing is decided.
[[nodiscard]] std::optional<BrokenClaims> broken_claims(const Project&);
/// Whether there are errors, and all of them are in assertion files.
[[nodiscard]] bool only_claims_broken(const Project&);

}  // namespace robochart::app
