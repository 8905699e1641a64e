// SPDX-License-Identifier: Apache-2.0
// The frame that all checks share: a budget, a clock, and limits reported as an inconclusive verdict.
#pragma once

#include <functional>

#include "checker/refine/search/search.hpp"
#include "checker/refine/verdict/check.hpp"
#include "checker/refine/verdict/normal_form.hpp"
#include "checker/refine/verdict/replay.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// Runs the check; a reached limit or a lack of memory gives inconclusive. Other exceptions are passed on. Long work
/// inside the systems counts against the limits too.
[[nodiscard]] Verdict decide(const std::vector<lts::TransitionSystem*>& systems, const Limits& limits,
                             const std::function<void(Budget&, Verdict&)>& question);

/// The result of an earlier search if it is known; otherwise the result of this one, which is then stored.
[[nodiscard]] std::optional<Violation> found(Earlier earlier, Verdict& verdict,
                                             const std::function<std::optional<Violation>()>& search);

/// Adds up the statistics of a search, also if it ends by an exception.
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

/// The shortest run of a trace's first events, which must exist.
[[nodiscard]] Run run_of_prefix(lts::TransitionSystem& system, const std::vector<process::Event>& trace,
                                std::size_t length, Budget& budget);
/// The run to a finding, with the forbidden event as its last step if there is one.
[[nodiscard]] Violation violation_of(Search& search, lts::TransitionSystem& system, const Finding& finding);
/// After a complete search that noted taus: the first divergence.
[[nodiscard]] std::optional<Violation> first_divergence(Search& search);

}  // namespace robochart::refine
