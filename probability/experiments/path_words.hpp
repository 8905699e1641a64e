// Random paths in the words of the model.
#pragma once

#include "checker/prism/sampling/random_path.hpp"
#include "probability/experiments/encoding.hpp"
#include "probability/experiments/experiment.hpp"

namespace robochart::probability {

/// Each step with the events or the machine that it is of, and what it changes for a reader of the model.
[[nodiscard]] Path in_words(const prism::RandomPath& path, const Unexplored& model);

}  // namespace robochart::probability
