// SPDX-License-Identifier: Apache-2.0
// Reads the text of a swarm.
#pragma once

#include "csp_emit/swarm/swarm.hpp"

namespace robochart::csp_emit {

/// Values that override the sizes in the text.
struct SwarmSize {
    std::uint32_t robots = 0;       ///< 0: the number in the text
    std::optional<SwarmGrid> grid;  ///< no value: the grid in the text
};

/// Reads a swarm and reports errors of syntax and of consistency. Names of the component are checked when the swarm is
/// composed.
[[nodiscard]] Swarm read_swarm(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&,
                               const SwarmSize& size = {});

}  // namespace robochart::csp_emit
