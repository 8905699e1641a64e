// SPDX-License-Identifier: Apache-2.0
// Passes the cycles of robots of several kinds to one observer for each kind. An observer numbers the robots of its
// kind from 0.
#pragma once

#include <memory>
#include <vector>

#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

class KindTraces final : public Trace {
public:
    /// `parts` contains an observer, or null, for each kind of the scenario. `whole` observes all robots, with their
    /// numbers in the scenario, and may be null.
    KindTraces(const Scenario&, std::vector<std::unique_ptr<Trace>> parts, std::unique_ptr<Trace> whole = nullptr);
    void observe_cycle(std::size_t robot, std::uint64_t step, const rc_signal* inputs, const rc_actions& outputs,
                       rc_drive_result result) override;
    /// Returns the objection of an observer to the last cycle.
    [[nodiscard]] const Objection* current_objection() const override;
    [[nodiscard]] bool is_conclusive() const override;

private:
    std::vector<std::size_t> first_;  ///< index of the first robot of each kind
    std::vector<std::unique_ptr<Trace>> parts_;
    std::unique_ptr<Trace> whole_;
    const Trace* last_ = nullptr;
};

/// Makes the observers of a trial. Each of `makers` makes the observer for one kind; `whole`, if it is not empty, makes
/// the observer of all robots. The scenario must outlive the result.
[[nodiscard]] Guard::Maker for_each_kind(const Scenario&, std::vector<Guard::Maker> makers, Guard::Maker whole = {});

}  // namespace robochart::simulation
