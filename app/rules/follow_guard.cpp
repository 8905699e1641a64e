// SPDX-License-Identifier: Apache-2.0
// See follow_guard.hpp.
#include "app/rules/follow_guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace robochart::app {

/// Follows the robots of one trial.
class FollowGuard::Watch final : public simulation::Trace {
public:
    Watch(FollowGuard& all, std::uint32_t trial, std::unique_ptr<simulation::Trace> other)
        : all_(all), trial_(trial), other_(std::move(other)) {}
    ~Watch() override {
        all_.robots_ += robots_.size();
        const std::lock_guard lock(all_.mutex_);
        for (const auto& robot : robots_) robot->end();
    }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    void observe_cycle(std::size_t robot, std::uint64_t step, const rc_signal* inputs, const rc_actions& outputs,
                       rc_drive_result result) override {
        if (other_ != nullptr) other_->observe_cycle(robot, step, inputs, outputs, result);
        while (robots_.size() <= robot) robots_.push_back(all_.duties_->make_follower(robots_.size()));
        for (const BrokenDuty& broken : robots_[robot]->observe_cycle(inputs, outputs, result)) note(broken, robot);
    }

    [[nodiscard]] const simulation::Objection* current_objection() const override {
        if (!objection_.cause.empty()) return &objection_;
        return other_ == nullptr ? nullptr : other_->current_objection();
    }
    [[nodiscard]] bool is_conclusive() const override {
        return (other_ == nullptr || other_->is_conclusive()) &&
               std::ranges::all_of(robots_, [](const auto& robot) { return robot->is_conclusive(); });
    }
    [[nodiscard]] double kept_share(std::size_t measure) const override {
        const std::optional<double> share = all_.duties_->kept_share(measure, broken_);
        return share ? *share : Trace::kept_share(measure);
    }

private:
    void note(const BrokenDuty& broken, std::size_t robot) {
        ++broken_[broken.number];
        if (objection_.cause.empty()) {
            objection_.cause = broken.cause;
            objection_.place = broken.place;
        }
        const std::lock_guard lock(all_.mutex_);
        all_.duties_->note_broken(trial_, robot, broken);
    }

    FollowGuard& all_;
    std::uint32_t trial_;
    std::unique_ptr<simulation::Trace> other_;
    std::vector<std::unique_ptr<Follower>> robots_;
    std::map<std::size_t, std::size_t> broken_;  ///< by duty: the number of robots that broke it
    simulation::Objection objection_;
};

simulation::Guard::Maker FollowGuard::make_observer(Maker other) {
    return [this, other = std::move(other)](std::uint32_t trial) {
        return std::make_unique<Watch>(*this, trial, other ? other(trial) : nullptr);
    };
}

std::string carried_text(const cpp_emit::Port& port, std::size_t argument, rc_value value) {
    switch (port.arguments[argument]) {
        case cpp_emit::Carried::real:
            return fmt::format("{}", value.real);
        case cpp_emit::Carried::boolean:
            return value.whole != 0 ? "true" : "false";
        case cpp_emit::Carried::whole:
            return fmt::format("{}", value.whole);
        case cpp_emit::Carried::enumeration:
            break;
    }
    const auto& literals = port.literals[argument];
    const bool named = value.whole >= 0 && static_cast<std::size_t>(value.whole) < literals.size();
    return named ? literals[static_cast<std::size_t>(value.whole)] : fmt::format("{}", value.whole);
}

std::vector<std::string> carried_texts(const cpp_emit::Port& port, const rc_value* values) {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < port.arguments.size(); ++i) result.push_back(carried_text(port, i, values[i]));
    return result;
}

}  // namespace robochart::app
