// SPDX-License-Identifier: Apache-2.0
// Compresses processes by bisimulation.
#pragma once

#include "checker/lts/bisimulation.hpp"
#include "checker/process/compressor.hpp"

namespace robochart::process {

/// Returns the equivalence that a compression preserves.
[[nodiscard]] lts::Equivalence equivalence_of(Compression kind);

/// Compresses with sbisim, explicate and lazyenumerate by strong bisimilarity. Compresses with normal, dbisim, wbisim,
/// diamond, tau_loop_factor and model_compress by divergence-respecting branching bisimilarity. This equivalence is
/// finer than those that FDR uses for these names. So the result may be larger than FDR's, but every model that FDR
/// preserves is preserved.
class BisimulationCompressor final : public Compressor {
public:
    Machine compress(const Machine& explored, Compression kind, diagnostics::Pollable& budget) override;
};

}  // namespace robochart::process
