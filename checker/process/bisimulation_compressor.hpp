// SPDX-License-Identifier: Apache-2.0
// Compressions by bisimulation.
#pragma once

#include "checker/lts/bisimulation.hpp"
#include "checker/process/compressor.hpp"

namespace robochart::process {

/// The equivalence that a compression preserves.
[[nodiscard]] lts::Equivalence equivalence_of(Compression kind);

/// Compresses with sbisim, explicate and lazyenumerate by strong bisimilarity. Compresses with normal, dbisim, wbisim,
/// diamond, tau_loop_factor and model_compress by divergence-respecting branching bisimilarity. The latter is finer
/// than the result of FDR for these names, so it preserves every model that they preserve; the result may be larger.
class BisimulationCompressor final : public Compressor {
public:
    Machine compress(const Machine& explored, Compression kind, diagnostics::Pollable& budget) override;
};

}  // namespace robochart::process
