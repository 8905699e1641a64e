// SPDX-License-Identifier: Apache-2.0
// Lets systems poll the budget of a check during long work.
#pragma once

#include <vector>

#include "checker/lts/transition_system.hpp"
#include "checker/refine/search/budget.hpp"

namespace robochart::refine {

/// Makes the systems poll the budget during the lifetime of this object. The systems and the budget must outlive it.
/// Null pointers are ignored.
class PollGuard {
public:
    PollGuard(std::vector<lts::TransitionSystem*> systems, Budget& budget) : systems_(std::move(systems)) {
        std::erase(systems_, nullptr);
        for (lts::TransitionSystem* system : systems_) system->set_budget(budget);
    }
    PollGuard(const PollGuard&) = delete;
    PollGuard& operator=(const PollGuard&) = delete;
    ~PollGuard() {
        for (lts::TransitionSystem* system : systems_) system->set_budget(diagnostics::unlimited);
    }

private:
    std::vector<lts::TransitionSystem*> systems_;
};

}  // namespace robochart::refine
