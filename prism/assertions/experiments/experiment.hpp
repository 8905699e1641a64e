// SPDX-License-Identifier: Apache-2.0
// Decides a probabilistic assertion for every combination of the values that it gives to constants.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "prism/assertions/experiments/encoding.hpp"
#include "prism/assertions/properties/question.hpp"
#include "prism/session/result.hpp"

namespace robochart::probability {

/// A random path, described with the names of the model.
struct Path {
    struct Step {
        std::string by;       ///< the events of the step; without an event, the machine that moves
        std::string changes;  ///< "M::c::s at A, M::c::s::x = 1"; "" if only internal variables change
    };
    std::string begin;  ///< the initial state
    std::vector<Step> steps;
    bool deadlock = false;  ///< no step is possible at the end of the path
};

/// The answer for one combination of values of the constants.
struct Row {
    std::vector<std::pair<std::string, std::string>> constants;  ///< names as written, and values
    /// One result, or two for a question over all schedulers: the least and the greatest value. Empty if there is an
    /// error.
    std::vector<prism::Result> results;
    std::optional<Path> path = {};  ///< the requested path, if any
    std::string error;              ///< the reason why the question cannot be evaluated; "" if there is no error
    std::uint64_t states = 0, transitions = 0;
    double seconds = 0;
};

/// Options for deciding questions.
struct Deciding {
    double relative = 1e-6;  ///< width of intervals relative to their values
    bool exact = false;      ///< exact fractions
    std::uint64_t seed = 0;  ///< the seed of random paths, if they answer the question
    unsigned threads = 0;    ///< the number of threads for random paths; 0: one per core
};

/// Decides the question and passes each row to `found` as soon as the row is known. If a model has too many states, its
/// row contains the error. Throws NotExpressed if an element has no counterpart, Wrong if values are wrong, and
/// LimitReached if the budget is exhausted.
void decide_question(Encoding&, const Question&, const Deciding&, diagnostics::Budget&,
                     const std::function<void(Row)>& found);

}  // namespace robochart::probability
