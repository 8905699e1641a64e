// A probabilistic assertion decided: for every combination of the values that it gives to constants.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "checker/prism/result.hpp"
#include "diagnostics/budget.hpp"
#include "probability/experiments/encoding.hpp"
#include "probability/properties/question.hpp"

namespace robochart::probability {

/// A random path in the words of the model.
struct Path {
    struct Step {
        std::string by;       ///< the events, else the machine that moves
        std::string changes;  ///< "M::c::s at A, M::c::s::x = 1"; "" where only what serves the encoding changes
    };
    std::string begin;  ///< the first state
    std::vector<Step> steps;
    bool deadlock = false;  ///< nothing is possible at its end
};

/// The answer for one combination.
struct Row {
    std::vector<std::pair<std::string, std::string>> constants;  ///< names as written, with values
    /// One result; of a question over all schedulers the least value, then the greatest. None where there is an error.
    std::vector<prism::Result> results;
    std::optional<Path> path = {};  ///< where one was asked for
    std::string error;              ///< why it cannot be evaluated; "" if it can
    std::uint64_t states = 0, transitions = 0;
    double seconds = 0;
};

/// How questions are decided.
struct Deciding {
    double relative = 1e-6;  ///< the width of enclosures, relative to their value
    bool exact = false;      ///< fractions
    std::uint64_t seed = 0;  ///< of random paths, where the question is answered by some
    unsigned threads = 0;    ///< that follow them; 0: one a core
};

/// Decides the question; `found` is called with each row as soon as it is there. Throws NotExpressed where something
/// has no counterpart, Wrong where values are given wrongly. LimitReached passes where the budget is used up; a model
/// with too many states is a row that says so.
void decide(Encoding&, const Question&, const Deciding&, diagnostics::Budget&, const std::function<void(Row)>& found);

}  // namespace robochart::probability
