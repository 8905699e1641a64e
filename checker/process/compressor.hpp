// SPDX-License-Identifier: Apache-2.0
// The interface by which the operational semantics compresses operands: the semantics explores the operand, and an
// implementation of the interface reduces it.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/process/term.hpp"

namespace robochart::process {

/// An explicit machine; state 0 is the initial one.
struct Machine {
    struct Edge {
        Event event;
        std::uint32_t target;
    };
    std::vector<std::vector<Edge>> edges;
    std::vector<TermId> meaning;  ///< by state: a term that it represents
};

/// Thrown by Compressor::explore if the operand has too many states to be stored. It is then not compressed.
class TooManyStates : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Reduces machines for the operational semantics.
class Compressor {
public:
    virtual ~Compressor() = default;
    /// Explores the operand with an engine that is faster than the firing rules on its terms. The result may be a
    /// machine with fewer states if the compression gives the same result for it. No value if there is no such engine
    /// for the operand. Throws TooManyStates. Polls the budget.
    virtual std::optional<Machine> explore(TermId /*operand*/, Compression /*kind*/,
                                           diagnostics::Pollable& /*budget*/) {
        return std::nullopt;
    }
    /// A machine that is equal to `explored` in every model that the compression preserves. Polls the budget.
    virtual Machine compress(const Machine& explored, Compression kind, diagnostics::Pollable& budget) = 0;
};

}  // namespace robochart::process
