// SPDX-License-Identifier: Apache-2.0
#include "simulation/trial/kind_traces.hpp"

#include <algorithm>

namespace robochart::simulation {

KindTraces::KindTraces(const Scenario& scenario, std::vector<std::unique_ptr<Trace>> parts,
                       std::unique_ptr<Trace> whole)
    : parts_(std::move(parts)), whole_(std::move(whole)) {
    for (std::size_t kind = 0; kind < parts_.size(); ++kind) first_.push_back(scenario.first_robot(kind));
}

void KindTraces::observe_cycle(std::size_t robot, std::uint64_t step, const rc_signal* inputs,
                               const rc_actions& outputs, rc_drive_result result) {
    if (whole_ != nullptr) whole_->observe_cycle(robot, step, inputs, outputs, result);
    const auto behind = std::ranges::upper_bound(first_, robot);
    const auto kind = static_cast<std::size_t>(behind - first_.begin()) - 1;
    last_ = parts_[kind].get();
    if (parts_[kind] != nullptr) parts_[kind]->observe_cycle(robot - first_[kind], step, inputs, outputs, result);
}

const Objection* KindTraces::current_objection() const {
    const Objection* const found = last_ == nullptr ? nullptr : last_->current_objection();
    return found == nullptr && whole_ != nullptr ? whole_->current_objection() : found;
}

bool KindTraces::is_conclusive() const {
    return (whole_ == nullptr || whole_->is_conclusive()) &&
           std::ranges::all_of(
               parts_, [](const std::unique_ptr<Trace>& part) { return part == nullptr || part->is_conclusive(); });
}

Guard::Maker for_each_kind(const Scenario& scenario, std::vector<Guard::Maker> makers, Guard::Maker whole) {
    return [&scenario, makers = std::move(makers), whole = std::move(whole)](std::uint32_t trial) {
        std::vector<std::unique_ptr<Trace>> parts;
        for (const Guard::Maker& make : makers) parts.push_back(make(trial));
        return std::make_unique<KindTraces>(scenario, std::move(parts), whole ? whole(trial) : nullptr);
    };
}

}  // namespace robochart::simulation
