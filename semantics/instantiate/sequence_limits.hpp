// Where a model looks at longer sequences than the finite instantiation has.
#pragma once

#include <vector>

#include "diagnostics/source.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// An expression of a model that asks for more elements than any sequence has.
struct SequenceLimit {
    enum class Kind {
        window,  ///< places of which some or all are behind the end of every sequence
        length,  ///< a comparison of a length that has one answer for all sequences
    };
    Kind kind = Kind::window;
    diagnostics::Span span;
    std::int64_t first = 0;   ///< window: the least place
    std::int64_t needed = 0;  ///< sequences of this length have either answer, or all of the window
};

/// In the order of the model. Literals alone are looked at: what is computed is not known here.
[[nodiscard]] std::vector<SequenceLimit> sequence_limits(const System&, const Instantiation&);

}  // namespace robochart::ir
