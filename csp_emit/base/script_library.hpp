// What a script of a project starts with, as a tree.
#pragma once

#include <vector>

#include "csp_emit/base/project.hpp"

namespace robochart::csp_emit {

/// The library of the project's time, and of the toolkits the functions that the model calls.
[[nodiscard]] std::vector<cspm::DeclPtr> library(const Project&);

}  // namespace robochart::csp_emit
