// Random small models, and smaller ones where a test fails.
#pragma once

#include <functional>
#include <optional>
#include <random>
#include <string>

#include "tests/checker/markov/models/description.hpp"

namespace robochart::markov {

struct RandomSizes {
    std::size_t states = 5;
    std::size_t choices = 3;
    std::size_t branches = 3;
    bool negative_rewards = false;
};

[[nodiscard]] Description random_description(std::mt19937_64& numbers, Kind kind, const RandomSizes& sizes = {});

/// Why a description is wrong; nothing where it is not.
using Fault = std::function<std::optional<std::string>(const Description&)>;

/// A smaller description with a fault, and the fault, as text; of one that has a fault.
[[nodiscard]] std::string smallest(Description description, const Fault& fault);

}  // namespace robochart::markov
