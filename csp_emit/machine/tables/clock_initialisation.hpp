// SPDX-License-Identifier: Apache-2.0
// Determines whether a clock is initialised (RoboTool does not check this). A clock starts with its machine, so a guard
// that reads the clock before any reset reads a time that the model has not set. An additional parameter of the machine
// records whether the clock has been reset, and an event marks each earlier read.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "csp_emit/machine/tables/activation_records.hpp"

namespace robochart::csp_emit {

/// Owns the additional parameter and the numbers of the guards that read the clock. Has no effect if no clock is
/// watched.
class ClockWatch {
public:
    ClockWatch(const MachineContext&, const ActivationRecords&, ParameterTable&, Provenance&);

    /// Returns the parameter that records whether the clock has been reset.
    [[nodiscard]] const std::optional<CellId>& reset_cell() const { return cell_; }
    /// Records a reset of the watched clock.
    void note_reset(const Frame&, ir::ClockId, Values&) const;
    /// Returns `not set__ & unset__.n -> STOP` if the transition's guard reads the watched clock, or null otherwise. A
    /// settled machine reads the guards of all transitions that could fire (semantics 3.4).
    [[nodiscard]] cspm::ExprPtr read_unset(std::uint32_t frame, ir::TransitionId);
    /// Adds `reset__` as a choice to the process after the clock has been reset.
    [[nodiscard]] cspm::ExprPtr with_reset(const cspm::ExprPtr& process) const;

    void declare(std::vector<cspm::DeclPtr>& decls) const;
    /// Returns the number of guards that read the clock.
    [[nodiscard]] std::size_t read_count() const { return reads_.size(); }

private:
    const MachineContext& context_;
    const ActivationRecords& frames_;
    const ParameterTable& cells_;
    Provenance& provenance_;
    std::optional<CellId> cell_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> reads_;  ///< by frame and transition
};

}  // namespace robochart::csp_emit
