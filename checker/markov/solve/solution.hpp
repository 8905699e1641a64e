// What is asked of the numeric and the exact operators, and what they answer.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "checker/markov/model/model.hpp"
#include "checker/markov/solve/enclosure.hpp"
#include "diagnostics/budget.hpp"

namespace robochart::markov {

/// Over the schedulers of an mdp; a dtmc has one.
enum class Direction { minimum, maximum };

struct Precision {
    double relative = 1e-6;                 ///< the relative width that enclosures should have at most
    std::uint64_t most_sweeps = 1'000'000;  ///< over a strongly connected component
    diagnostics::Budget* budget = nullptr;  ///< polled; may be null
    bool strategy = false;                  ///< ask for Solution::strategy
};

/// The value of every state.
struct Solution {
    std::vector<Enclosure> values;  ///< right in any case
    std::vector<std::uint32_t>
        strategy;           ///< of each state an optimal choice, as an index into the model's; empty unless asked for
    std::string shortfall;  ///< why some enclosure is wider than asked for; empty where none is
};

/// The question has no answer here: the message says why.
class Unsupported : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace robochart::markov
