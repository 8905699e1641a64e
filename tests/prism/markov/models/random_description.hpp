// SPDX-License-Identifier: Apache-2.0
// Makes random small models, and shrinks models for which a test fails.
#pragma once

#include <functional>
#include <optional>
#include <random>
#include <string>

#include "tests/prism/markov/models/description.hpp"

namespace robochart::markov {

struct RandomSizes {
    std::size_t states = 5;
    std::size_t choices = 3;
    std::size_t branches = 3;
    bool negative_rewards = false;
};

[[nodiscard]] Description random_description(std::mt19937_64& numbers, Kind kind, const RandomSizes& sizes = {});

/// Returns the reason why a model fails the test, or nullopt if it passes.
using Fault = std::function<std::optional<std::string>(const Description&)>;

/// Shrinks a model that fails the test. Returns the smallest model found and its fault, as text.
[[nodiscard]] std::string smallest(Description description, const Fault& fault);

}  // namespace robochart::markov
