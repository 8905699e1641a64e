// SPDX-License-Identifier: Apache-2.0
// The data that all emitters of one run share.
#pragma once

#include <string>

#include "cpp_emit/faults/mutation.hpp"
#include "cpp_emit/plan/component.hpp"
#include "cpp_emit/plan/options.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

struct Generation {
    const ir::System& system;
    const ir::Instantiation& inst;
    const Options& options;
    const Component& component;
    Mutation& mutation;

    /// "S1 (aggregation.rct:83)"; only the element if its place is unknown. File names may contain any characters.
    [[nodiscard]] diagnostics::ForeignText place_text(std::string_view element, diagnostics::Span) const;
    /// "aggregation.rct:83"; "" if unknown.
    [[nodiscard]] diagnostics::ForeignText line_text(diagnostics::Span) const;
    /// "aggregation.rct"; "" if unknown.
    [[nodiscard]] diagnostics::ForeignText file_text(diagnostics::Span) const;
    /// The test for the bound on steps in a loop's condition; "" with Fault::loop_never_ends.
    [[nodiscard]] std::string bound_test() const;
    /// The same for the loop of a cycle, which is not inside another loop.
    [[nodiscard]] std::string round_test() const;
    [[nodiscard]] diagnostics::ForeignText place_text(const ir::Origin& origin) const {
        return place_text(origin.element, origin.span);
    }
};

}  // namespace robochart::cpp_emit
