// Counterexamples compared with the definitions: the run is one of the naive graph, what it violates is violated at its
// end, and where a shortest run is promised there is none shorter.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "checker/refine/verdict/verdict.hpp"
#include "tests/checker/processes/questions.hpp"

namespace robochart::refine {

/// What is wrong with a violation of the question, in words, if anything. `letter`: of an event, tau and tick too.
/// `exactly`: the searched system does a tau where the naive graph does one; else runs are compared by their traces.
[[nodiscard]] std::optional<std::string> wrong_by_definition(
    const Counterexample& counterexample, const Question& question, const Graphs& graphs, bool exactly,
    const std::function<naive::Letter(process::Event)>& letter);

}  // namespace robochart::refine
