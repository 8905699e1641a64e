// Reads a swarm.
#pragma once

#include "csp_emit/swarm/swarm.hpp"

namespace robochart::csp_emit {

/// What is meant instead of what the text says.
struct SwarmSize {
    std::uint32_t robots = 0;       ///< 0: as it says
    std::optional<SwarmGrid> grid;  ///< none: as it says
};

/// Errors of syntax and what does not fit by itself become diagnostics; whether the component has what is named is
/// looked at where the swarm is composed.
[[nodiscard]] Swarm read_swarm(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&,
                               const SwarmSize& size = {});

}  // namespace robochart::csp_emit
