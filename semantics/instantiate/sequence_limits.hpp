// SPDX-License-Identifier: Apache-2.0
// Finds expressions that need longer sequences than the finite instantiation contains.
#pragma once

#include <vector>

#include "base/diagnostics/source.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// An expression of a model that needs more elements than any sequence has.
struct SequenceLimit {
    enum class Kind {
        window,  ///< positions, some or all of which are beyond the end of every sequence
        length,  ///< a comparison of a length that has the same result for all sequences
    };
    Kind kind = Kind::window;
    diagnostics::Span span;
    std::int64_t first = 0;   ///< window: the least position
    std::int64_t needed = 0;  ///< length at which the comparison can change its result, or that contains the whole
                              ///< window
};

/// Returns the limits in the order of the model. Only literals are considered, because computed numbers are unknown.
[[nodiscard]] std::vector<SequenceLimit> sequence_limits(const System&, const Instantiation&);

}  // namespace robochart::ir
