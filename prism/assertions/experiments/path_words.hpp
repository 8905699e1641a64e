// SPDX-License-Identifier: Apache-2.0
// Random paths in terms of the model.
#pragma once

#include "prism/assertions/experiments/encoding.hpp"
#include "prism/assertions/experiments/experiment.hpp"
#include "prism/sampling/random_path.hpp"

namespace robochart::probability {

/// Describes each step by its events or its machine, and by its changes in terms of the model.
[[nodiscard]] Path in_words(const prism::RandomPath& path, const Unexplored& model);

}  // namespace robochart::probability
