// SPDX-License-Identifier: Apache-2.0
// Provides the states of compiled code that a search has reached, and the results of their cycles. Reports use them
// after the search. The search may have tried all inputs (code_system.hpp), or only the inputs that the code reads
// (cycle_graph.hpp).
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "checker/process/term.hpp"
#include "cpp_emit/runtime/explore_abi.h"

namespace robochart::conformance {

/// The result of one call of `step`. Equal results are one object.
struct CycleResult {
    rc_result outcome = RC_QUIESCENT;
    std::vector<process::Event> writes;
    std::uint32_t next = 0;  ///< image
    /// If not empty: the cycle passed probabilistic junctions, and these are the results of the branches.
    std::vector<std::uint32_t> ways;
};

/// A cycle on the path to an image: one reading for each register, and the result.
struct PassedCycle {
    std::vector<std::uint32_t> readings;
    const CycleResult* result = nullptr;
};

/// The index of a register, and its reading.
using Raised = std::pair<std::size_t, std::uint32_t>;

class ExploredCode {
public:
    ExploredCode() = default;
    virtual ~ExploredCode() = default;
    ExploredCode(const ExploredCode&) = delete;
    ExploredCode& operator=(const ExploredCode&) = delete;

    [[nodiscard]] virtual std::uint32_t cycle_length() const = 0;
    [[nodiscard]] virtual std::uint32_t reset_image() const = 0;
    /// Returns the maximal number of outputs in a cycle.
    [[nodiscard]] virtual std::uint32_t most_writes() const = 0;
    [[nodiscard]] virtual std::vector<unsigned char> image_bytes(std::uint32_t image) const = 0;
    [[nodiscard]] virtual std::string print_image(std::uint32_t image) const = 0;
    /// Returns the images in which a cycle has begun, in the order of their first cycle.
    [[nodiscard]] virtual const std::vector<std::uint32_t>& started_images() const = 0;
    /// Returns a shortest path to one of these images.
    [[nodiscard]] virtual std::vector<PassedCycle> path_to_image(std::uint32_t image) const = 0;

    /// Returns the number of the cycles of an image. Images with equal numbers have equal cycles. The arguments of this
    /// function and the following ones are images in which a cycle has begun.
    [[nodiscard]] virtual std::uint32_t cycles_of(std::uint32_t image) const = 0;
    /// Returns, for each register, whether it has no effect in this image for any contents of the other registers.
    [[nodiscard]] virtual std::vector<bool> without_effect(std::uint32_t image) const = 0;
    /// Returns the images to which a cycle may lead, in ascending order.
    [[nodiscard]] virtual std::vector<std::uint32_t> next_images(std::uint32_t image) const = 0;
    /// Returns the outputs of a cycle in which all other registers are empty; none if probabilistic junctions decide.
    [[nodiscard]] virtual std::vector<process::Event> writes(std::uint32_t image,
                                                             const std::vector<Raised>& raised) const = 0;
};

}  // namespace robochart::conformance
