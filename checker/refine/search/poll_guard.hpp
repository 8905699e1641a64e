// Long work inside systems counts against a check's budget.
#pragma once

#include <vector>

#include "checker/lts/transition_system.hpp"
#include "checker/refine/search/budget.hpp"

namespace robochart::refine {

/// The systems poll the budget while this lives; both outlive it.
class Watch {
public:
    Watch(std::vector<lts::TransitionSystem*> systems, Budget& budget) : systems_(std::move(systems)) {
        for (lts::TransitionSystem* system : systems_) system->watch([&budget] { budget.charge(); });
    }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;
    ~Watch() {
        for (lts::TransitionSystem* system : systems_) system->watch({});
    }

private:
    std::vector<lts::TransitionSystem*> systems_;
};

}  // namespace robochart::refine
