// What sees the cycles of robots of several kinds: for each kind something that numbers its robots from 0 on.
#pragma once

#include <memory>
#include <vector>

#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

class KindTraces final : public Trace {
public:
    /// `parts`: of each kind of the scenario; null: nothing sees it. `whole`: sees all, with the scenario's numbers;
    /// may be null.
    KindTraces(const Scenario&, std::vector<std::unique_ptr<Trace>> parts, std::unique_ptr<Trace> whole = nullptr);
    void cycle(std::size_t robot, std::uint64_t step, const rc_signal* inputs, const rc_actions& outputs,
               rc_drive_result result) override;
    /// Of the robot whose cycle was the last.
    [[nodiscard]] const Objection* objection() const override;
    [[nodiscard]] bool decided() const override;

private:
    std::vector<std::size_t> first_;  ///< robot of each kind
    std::vector<std::unique_ptr<Trace>> parts_;
    std::unique_ptr<Trace> whole_;
    const Trace* last_ = nullptr;
};

/// Makes KindTraces of a trial: a part by each of `makers`, and the whole by `whole`, if it makes any. The scenario
/// outlives what is returned.
[[nodiscard]] Guard::Maker for_each_kind(const Scenario&, std::vector<Guard::Maker> makers, Guard::Maker whole = {});

}  // namespace robochart::simulation
