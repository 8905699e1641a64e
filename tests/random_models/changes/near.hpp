// SPDX-License-Identifier: Apache-2.0
// Makes models that are almost well-formed: an element is missing, duplicated or misplaced, a name is replaced, or a
// rule is violated. They test that components after the front end accept the models that the front end accepts, or
// reject them.
#pragma once

#include "tests/random_models/models/project.hpp"
#include "tests/random_models/models/random.hpp"

namespace robochart::random_models {

/// Returns the project with one to three such changes. The front end rejects most results, but not all.
[[nodiscard]] Project mutate_project(const Project& project, Random& random);

}  // namespace robochart::random_models
