// The frame that all checks share: a budget, a clock, and limits reported as an inconclusive verdict.
#pragma once

#include <functional>

#include "checker/refine/search/search.hpp"
#include "checker/refine/verdict/check.hpp"
#include "checker/refine/verdict/normal_form.hpp"
#include "checker/refine/verdict/replay.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// Runs the question; a limit reached or memory that is not there gives inconclusive. Other exceptions pass.
/// Long work inside the systems counts against the limits too.
[[nodiscard]] Verdict decide(const std::vector<lts::TransitionSystem*>& systems, const Limits& limits,
                             const std::function<void(Budget&, Verdict&)>& question);

/// What an earlier search has found where that is known, else what this one finds, which is then noted.
[[nodiscard]] std::optional<Violation> found(Earlier earlier, Verdict& verdict,
                                             const std::function<std::optional<Violation>()>& search);

/// Adds up what a search has seen, also when it is left by an exception.
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

/// The shortest run of a trace's first events, which is known to exist.
[[nodiscard]] Run run_of_prefix(lts::TransitionSystem& system, const std::vector<process::Event>& trace,
                                std::size_t length, Budget& budget);
/// The run to a finding, with the forbidden event as its last step if there is one.
[[nodiscard]] Violation violation_of(Search& search, lts::TransitionSystem& system, const Finding& finding);
/// After an exhausted search that kept taus: the first divergence.
[[nodiscard]] std::optional<Violation> first_divergence(Search& search);

}  // namespace robochart::refine
