// SPDX-License-Identifier: Apache-2.0
// Converts options to the limits of one check, with progress reports for its subject.
#include "app/command/limits.hpp"

#include "app/command/progress.hpp"
#include "app/command/run.hpp"

namespace robochart::app {

refine::Limits limits_of_check(const Options& o, const std::string& subject) {
    refine::Limits result;
    result.by_levels = o.by_levels;
    if (o.run != nullptr) {
        diagnostics::Budget& budget = o.run->budget();
        static_cast<diagnostics::Limits&>(result) = budget.limits();
        result.interrupted = [&budget] { return budget.is_interrupted(); };
        result.undisturbed = [run = o.run] {
            return std::make_shared<std::unique_lock<std::recursive_mutex>>(run->lock_for_edit());
        };
        if (o.turn_ends && (!result.deadline || *o.turn_ends < *result.deadline)) result.deadline = o.turn_ends;
        if (refine::LevelStrategy* const kept = o.run->search_strategy(o)) result.by_levels = kept;
    }
    result.max_states = o.max_states;
    result.progress = progress_of(o, subject);
    if (o.on_progress)
        result.progress = [shown = result.progress, also = o.on_progress](const refine::Progress& progress) {
            if (shown) shown(progress);
            also(progress);
        };
    result.threads = o.threads;
    result.reduction = o.reduction;
    return result;
}

}  // namespace robochart::app
