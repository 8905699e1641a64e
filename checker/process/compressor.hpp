// SPDX-License-Identifier: Apache-2.0
// The interface between the operational semantics and compressions. The semantics explores an operand. An
// implementation of this interface reduces the result.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/process/term.hpp"

namespace robochart::process {

/// An explicit transition system; state 0 is the initial state.
struct Machine {
    struct Edge {
        Event event;
        std::uint32_t target;
    };
    std::vector<std::vector<Edge>> edges;
    std::vector<TermId> meaning;  ///< by state: a term that the state represents
};

/// Thrown by Compressor::explore if the operand has too many states. The semantics then does not compress it.
class TooManyStates : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Reduces machines for the operational semantics.
class Compressor {
public:
    virtual ~Compressor() = default;
    /// Explores the operand with an engine that is faster than the firing rules. The result may already have fewer
    /// states than the operand, if the compression gives the same result for both. Returns no value if no faster engine
    /// can explore the operand. Throws TooManyStates. Polls the budget.
    virtual std::optional<Machine> explore(TermId /*operand*/, Compression /*kind*/,
                                           diagnostics::Pollable& /*budget*/) {
        return std::nullopt;
    }
    /// Returns a machine that is equal to `explored` in every model that the compression preserves. Polls the budget.
    virtual Machine compress(const Machine& explored, Compression kind, diagnostics::Pollable& budget) = 0;
};

}  // namespace robochart::process
