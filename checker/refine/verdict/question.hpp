// SPDX-License-Identifier: Apache-2.0
// Contains the common code of all checks: a budget, a clock, and limits that cause an inconclusive verdict.
#pragma once

#include <functional>

#include "checker/refine/search/search.hpp"
#include "checker/refine/verdict/check.hpp"
#include "checker/refine/verdict/normal_form.hpp"
#include "checker/refine/verdict/replay.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// Runs the check. If a limit is reached or memory is exhausted, the verdict is inconclusive. The function passes on
/// all other exceptions. The systems also poll the limits during long work.
[[nodiscard]] Verdict decide(const std::vector<lts::TransitionSystem*>& systems, const Limits& limits,
                             const std::function<void(Budget&, Verdict&)>& question);

/// Returns the violation that an earlier search has found, if there are findings of an earlier search. Otherwise runs
/// the search and stores its result.
[[nodiscard]] std::optional<Violation> reuse_or_search(Earlier earlier, Verdict& verdict,
                                                       const std::function<std::optional<Violation>()>& search);

/// Adds the statistics of a search to a verdict when the search ends, even by an exception.
class Tally {
public:
    Tally(const Search& search, Statistics& statistics, const NormalForm* specification = nullptr)
        : search_(search), statistics_(statistics), specification_(specification) {}
    Tally(const Tally&) = delete;
    Tally& operator=(const Tally&) = delete;
    ~Tally();

private:
    const Search& search_;
    Statistics& statistics_;
    const NormalForm* specification_;
};

/// Returns the shortest run with the first `length` events of a trace. This run must exist.
[[nodiscard]] Run run_of_prefix(lts::TransitionSystem& system, const std::vector<process::Event>& trace,
                                std::size_t length, Budget& budget);
/// Returns the violation with the run to a finding. If an event is forbidden, it is the last step of the run.
[[nodiscard]] Violation violation_of(Search& search, lts::TransitionSystem& system, const Finding& finding);
/// Returns the first divergence. Call it after a complete search that noted taus.
[[nodiscard]] std::optional<Violation> first_divergence(Search& search);

}  // namespace robochart::refine
