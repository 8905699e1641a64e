// SPDX-License-Identifier: Apache-2.0
// Answers questions about compiled processes by decision diagrams: deadlock, divergence, and refinement in each model.
// In general this is not faster than an explicit search. It is faster for networks of many components if each rule
// involves few components.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "checker/machine/supercombinator.hpp"
#include "checker/refine/verdict/symbolic_stage.hpp"
#include "checker/symbolic/diagrams.hpp"

namespace robochart::symbolic {

/// The limits of the stage, and settings for tests.
struct StageOptions {
    std::chrono::duration<double> delay{3};  ///< CPU time that the explicit search uses before the stage starts
    std::chrono::duration<double> share{3};  ///< CPU time that the stage may use
    /// After a violation is found: the part of the remaining time that may be used to find its shortest run.
    double part_for_rings = 0.5;
    Space space = {};  ///< uses at most an eighth of the memory of the run
    /// For tests: slots from the lowest level up; if empty, a good order is computed.
    std::vector<std::uint32_t> order = {};
};

class DiagramStage final : public refine::SymbolicStage {
public:
    explicit DiagramStage(StageOptions options = {}) : options_(std::move(options)) {}
    [[nodiscard]] std::chrono::duration<double> delay() const override { return options_.delay; }
    [[nodiscard]] std::optional<refine::Findings> decide(lts::TransitionSystem& system,
                                                         const refine::SymbolicQuestion& question,
                                                         refine::Budget& budget) override;

private:
    struct GivenUp {
        std::shared_ptr<const machine::Supercombinator> process;
        refine::SymbolicQuestion question;
        friend bool operator==(const GivenUp&, const GivenUp&) = default;
    };
    [[nodiscard]] std::optional<refine::Findings> explore(const lts::TransitionSystem& system,
                                                          const machine::Supercombinator& combined,
                                                          const refine::SymbolicQuestion& question,
                                                          refine::Budget& budget) const;

    const StageOptions options_;
    std::optional<GivenUp> given_up_;  // the last attempt without an answer; another search does not repeat it
};

}  // namespace robochart::symbolic
