// SPDX-License-Identifier: Apache-2.0
// Converts settings to the limits of one check, whose progress is reported under the name of its subject.
#include "driver/settings/search_context.hpp"

#include <memory>

namespace robochart::driver {

refine::Limits limits_of_check(const SearchContext& search, const std::string& subject) {
    refine::Limits result;
    diagnostics::Budget& budget = search.services.budget();
    static_cast<diagnostics::Limits&>(result) = budget.limits();
    result.interrupted = [&budget] { return budget.is_interrupted(); };
    result.undisturbed = [&services = search.services] {
        return std::make_shared<std::unique_lock<std::recursive_mutex>>(services.edit());
    };
    const Turn& turn = search.turn;
    if (turn.ends && (!result.deadline || *turn.ends < *result.deadline)) result.deadline = turn.ends;
    result.by_levels = search.services.level_searches();
    const LimitSettings& own = search.settings.limits;
    result.max_states = own.max_states;
    result.threads = own.threads;
    result.reduction = own.reduction;
    if (own.progress) result.progress = search.services.progress(subject);
    if (turn.on_progress)
        result.progress = [shown = result.progress, also = turn.on_progress](const refine::Progress& progress) {
            if (shown) shown(progress);
            also(progress);
        };
    return result;
}

}  // namespace robochart::driver
