// SPDX-License-Identifier: Apache-2.0
// Answers questions about compiled processes by decision diagrams. Nothing here is faster than a search of states in
// general: it decides networks of many parts whose rules join few parts.
#pragma once

#include <cstdint>
#include <vector>

#include "checker/refine/verdict/symbolic_stage.hpp"
#include "checker/symbolic/diagrams.hpp"

namespace robochart::symbolic {

/// The bounds of the stage, and settings for tests.
struct StageOptions {
    std::chrono::duration<double> delay{3};  ///< CPU time of the search of states before the stage
    std::chrono::duration<double> share{3};  ///< CPU time of the stage
    Space space = {};                        ///< at most an eighth of the memory of the run
    std::vector<std::uint32_t> order = {};   ///< for tests: slots from the lowest level up; empty: a good order
};

class DiagramStage final : public refine::SymbolicStage {
public:
    explicit DiagramStage(StageOptions options = {}) : options_(std::move(options)) {}
    [[nodiscard]] std::chrono::duration<double> delay() const override { return options_.delay; }
    [[nodiscard]] std::optional<refine::Findings> decide(lts::TransitionSystem& system,
                                                         const refine::SymbolicQuestion& question,
                                                         refine::Budget& budget) override;

private:
    const StageOptions options_;
};

}  // namespace robochart::symbolic
