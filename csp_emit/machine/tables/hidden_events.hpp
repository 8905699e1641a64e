// SPDX-License-Identifier: Apache-2.0
// Chooses the names of a machine's hidden events: its steps, and its transitions without a trigger.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "csp_emit/machine/tables/activation_records.hpp"

namespace robochart::csp_emit {

/// Owns the numbers of steps and the names of transitions, and records their meanings.
class HiddenEvents {
public:
    HiddenEvents(MachineContext& context, const ActivationRecords& frames, const ParameterTable& cells,
                 Provenance& provenance)
        : context_(context), frames_(frames), cells_(cells), provenance_(provenance) {}

    /// Returns the event `step__.n`. Equal keys get the same n.
    [[nodiscard]] cspm::ExprPtr step_event(const std::string& key, const EventMeaning&);
    /// Returns `internal__.TID_t` for a transition without trigger.
    [[nodiscard]] cspm::ExprPtr transition_event(std::uint32_t frame, ir::TransitionId);

    /// Declares the datatype of the transitions and the channels of the hidden events.
    void declare_channels(std::vector<cspm::DeclPtr>& decls) const;
    /// Returns the channels of hidden events that the machine uses.
    [[nodiscard]] std::vector<cspm::ExprPtr> declared_channels() const;

private:
    [[nodiscard]] std::shared_ptr<const Draw> make_draw(std::uint32_t frame, ir::TransitionId) const;

    MachineContext& context_;
    const ActivationRecords& frames_;
    const ParameterTable& cells_;
    Provenance& provenance_;
    std::map<std::string, std::size_t> steps_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> transitions_;  ///< by frame and transition
};

}  // namespace robochart::csp_emit
