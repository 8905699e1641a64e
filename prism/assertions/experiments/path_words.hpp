// SPDX-License-Identifier: Apache-2.0
// Describes random paths with the names of the model.
#pragma once

#include "prism/assertions/experiments/encoding.hpp"
#include "prism/assertions/experiments/experiment.hpp"
#include "prism/sampling/random_path.hpp"

namespace robochart::probability {

/// Describes each step by its events, or by its machine if it has no events, and by the changes of variables.
[[nodiscard]] Path in_words(const prism::RandomPath& path, const Unexplored& model);

}  // namespace robochart::probability
