// How the operational semantics has a compression done: it explores the operand, something else makes it smaller.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <vector>

#include "checker/process/term.hpp"

namespace robochart::process {

/// An explicit machine; state 0 is the initial one.
struct Machine {
    struct Edge {
        Event event;
        std::uint32_t target;
    };
    std::vector<std::vector<Edge>> edges;
    std::vector<TermId> meaning;  ///< of each state, a term that it stands for
};

/// Thrown by Compressor::explore: the operand has too many states to be held. It stays as it is.
class TooManyStates : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Makes machines smaller for the operational semantics.
class Compressor {
public:
    virtual ~Compressor() = default;
    /// The operand explored by a faster engine than its terms, or a machine with fewer states that the compression
    /// makes the same of; none if there is none for it. Throws TooManyStates. `poll` may throw to stop.
    virtual std::optional<Machine> explore(TermId /*operand*/, Compression /*kind*/,
                                           const std::function<void()>& /*poll*/) {
        return std::nullopt;
    }
    /// A machine equal to the given one in every model that the compression claims to keep. `poll` may throw to stop.
    virtual Machine compress(const Machine& explored, Compression kind, const std::function<void()>& poll) = 0;
};

}  // namespace robochart::process
