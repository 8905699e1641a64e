// Assertion files with errors: which claims of a project can be decided all the same.
#pragma once

#include <optional>

#include "app/command/pipeline.hpp"
#include "frontend/project/units.hpp"

namespace robochart::app {

/// The files of a project in two: what can be decided, and the models with the assertion files that have errors or may
/// depend on those (`again`). Nothing where an error is not in an assertion file, or where whatever is left could
/// depend on a part that cannot be read: then nothing is decided.
struct BrokenClaims {
    frontend::Unit sound, broken;
};
[[nodiscard]] std::optional<BrokenClaims> broken_claims(const Project&);

}  // namespace robochart::app
