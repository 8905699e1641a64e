// SPDX-License-Identifier: Apache-2.0
// A process that stays a term, searched as packed states: rows of one width, each the bytes of a term, filled up with
// zeros. Two states share a row only if they are the same term, whatever was evaluated before.
#pragma once

#include <deque>
#include <memory>

#include "checker/cspm/packed/packed_processes.hpp"
#include "checker/lts/transition_system.hpp"

namespace robochart::cspm {

/// Thrown by a PackedSystem where a state needs more words: it has to be widened and searched from the start.
struct RowsTooNarrow {};

/// One process of a question, which it shares with the other one.
class PackedSystem final : public lts::TransitionSystem {
public:
    PackedSystem(std::shared_ptr<PackedProcesses> processes, std::size_t side, Span span);

    [[nodiscard]] std::size_t width() const override { return width_; }
    void initial(std::span<lts::Word> state) override;
    void successors(lts::StateView state, lts::SuccessorSink& sink) override;
    [[nodiscard]] const process::EventTable& events() const override { return processes_->events(); }
    void watch(const std::function<void()>& poll) override { processes_->watch(poll); }
    [[nodiscard]] std::string describe(lts::StateView state) const override;

    /// Makes rows as wide as the last state needed, if that was too long. Throws NotPacked where that is very long.
    void widen();

private:
    void fill(std::span<const std::uint8_t> bytes, std::span<lts::Word> row);

    std::shared_ptr<PackedProcesses> processes_;
    std::size_t side_;
    Span span_;
    std::size_t width_ = 2;
    std::size_t needed_ = 0;
    /// What one call of `successors` works with: a sink may ask for successors too.
    struct Workspace {
        PackedSteps steps;
        std::vector<lts::Word> row;
    };
    std::deque<Workspace> workspaces_;
    std::size_t calls_ = 0;  // under way
};

}  // namespace robochart::cspm
