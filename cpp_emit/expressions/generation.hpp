// SPDX-License-Identifier: Apache-2.0
// Declares the data that all emitters of one run share.
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

    /// Returns an element with its place, "S1 (aggregation.rct:83)", or only the element if its place is unknown. File
    /// names may contain any characters.
    [[nodiscard]] diagnostics::ForeignText place_text(std::string_view element, diagnostics::Span) const;
    /// Returns the file and line, "aggregation.rct:83"; "" if unknown.
    [[nodiscard]] diagnostics::ForeignText line_text(diagnostics::Span) const;
    /// Returns the file name, "aggregation.rct"; "" if unknown.
    [[nodiscard]] diagnostics::ForeignText file_text(diagnostics::Span) const;
    /// Returns the test in a loop's condition that bounds the number of steps; "" with Fault::loop_never_ends.
    [[nodiscard]] std::string bound_test() const;
    /// Returns this test for the loop of a cycle, which is not inside another loop.
    [[nodiscard]] std::string round_test() const;
    [[nodiscard]] diagnostics::ForeignText place_text(const ir::Origin& origin) const {
        return place_text(origin.element, origin.span);
    }
};

}  // namespace robochart::cpp_emit
