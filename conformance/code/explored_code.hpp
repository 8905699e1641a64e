// SPDX-License-Identifier: Apache-2.0
// The states of compiled code that a search has reached, and the results of their cycles. The reports after a search
// use them. The search may try all inputs (code_system.hpp), or only the inputs that the code reads (cycle_graph.hpp).
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
    /// not empty: the cycle passed probabilistic junctions, and these are the results of their branches
    std::vector<std::uint32_t> ways;
};

/// A cycle on the path to an image: one reading of each register, and the result.
struct PassedCycle {
    std::vector<std::uint32_t> readings;
    const CycleResult* result = nullptr;
};

/// A register and its reading.
using Raised = std::pair<std::size_t, std::uint32_t>;

class ExploredCode {
public:
    ExploredCode() = default;
    virtual ~ExploredCode() = default;
    ExploredCode(const ExploredCode&) = delete;
    ExploredCode& operator=(const ExploredCode&) = delete;

    [[nodiscard]] virtual std::uint32_t cycle_length() const = 0;
    [[nodiscard]] virtual std::uint32_t reset_image() const = 0;
    /// The maximal number of outputs in a cycle.
    [[nodiscard]] virtual std::uint32_t most_writes() const = 0;
    [[nodiscard]] virtual std::vector<unsigned char> image_bytes(std::uint32_t image) const = 0;
    [[nodiscard]] virtual std::string print_image(std::uint32_t image) const = 0;
    /// The images in which a cycle has begun, in the order of their first cycle.
    [[nodiscard]] virtual const std::vector<std::uint32_t>& started_images() const = 0;
    /// A shortest path to one of these images.
    [[nodiscard]] virtual std::vector<PassedCycle> path_to_image(std::uint32_t image) const = 0;

    /// The following are about an image in which a cycle has begun. Images with equal numbers have equal cycles.
    [[nodiscard]] virtual std::uint32_t cycles_of(std::uint32_t image) const = 0;
    /// For each register: whether it has no effect in this image, for all readings of the other registers.
    [[nodiscard]] virtual std::vector<bool> without_effect(std::uint32_t image) const = 0;
    /// The images to which a cycle may lead, in ascending order.
    [[nodiscard]] virtual std::vector<std::uint32_t> next_images(std::uint32_t image) const = 0;
    /// The outputs of a cycle in which all other registers are empty; none if probabilistic junctions decide.
    [[nodiscard]] virtual std::vector<process::Event> writes(std::uint32_t image,
                                                             const std::vector<Raised>& raised) const = 0;
};

}  // namespace robochart::conformance
