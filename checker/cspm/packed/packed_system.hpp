// SPDX-License-Identifier: Apache-2.0
// A process that is not compiled, as a transition system of packed states. All rows have the same width. A row
// contains the bytes of a term and then zeros. Equal rows are equal terms, independently of earlier
// evaluations.
#pragma once

#include <deque>
#include <memory>

#include "checker/cspm/packed/packed_processes.hpp"
#include "checker/lts/transition_system.hpp"

namespace robochart::cspm {

/// Thrown by a PackedSystem if a state does not fit into a row. The caller must widen the rows and restart the
/// search.
struct RowsTooNarrow {};

/// One side of an assertion. Both sides share the PackedProcesses.
class PackedSystem final : public lts::TransitionSystem {
public:
    PackedSystem(std::shared_ptr<PackedProcesses> processes, std::size_t side, Span span);

    [[nodiscard]] std::size_t width() const override { return width_; }
    void initial(std::span<lts::Word> state) override;
    void successors(lts::StateView state, lts::SuccessorSink& sink) override;
    [[nodiscard]] std::vector<std::vector<lts::Word>> choice_operands(lts::StateView state) override;
    [[nodiscard]] const process::EventTable& events() const override { return processes_->events(); }
    void set_budget(diagnostics::Pollable& budget) override { processes_->set_budget(budget); }
    [[nodiscard]] std::string describe(lts::StateView state) const override;

    /// Widens the rows so that the last rejected state fits. Throws NotPacked if that state is too large.
    void widen_rows();

private:
    void fill_row(std::span<const std::uint8_t> bytes, std::span<lts::Word> row);

    std::shared_ptr<PackedProcesses> processes_;
    std::size_t side_;
    Span span_;
    std::size_t width_ = 2;
    std::size_t needed_ = 0;
    /// The buffers of one call of `successors`. A sink may call `successors` again, so each nested call needs its own.
    struct Workspace {
        PackedSteps steps;
        std::vector<lts::Word> row;
    };
    std::deque<Workspace> workspaces_;
    std::size_t calls_ = 0;  // number of active calls
};

}  // namespace robochart::cspm
