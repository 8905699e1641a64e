// Compressions by bisimulation.
#pragma once

#include "checker/lts/bisimulation.hpp"
#include "checker/process/compressor.hpp"

namespace robochart::process {

/// Up to which equivalence a compression keeps its operand.
[[nodiscard]] lts::Equivalence equivalence_of(Compression kind);

/// sbisim, explicate and lazyenumerate give the quotient by strong bisimilarity; normal, dbisim, wbisim, diamond,
/// tau_loop_factor and model_compress that by divergence-respecting branching bisimilarity. The latter is finer than
/// what FDR computes for these names and so keeps every model that they keep; it may be larger.
class BisimulationCompressor final : public Compressor {
public:
    Machine compress(const Machine& explored, Compression kind, const std::function<void()>& poll) override;
};

}  // namespace robochart::process
