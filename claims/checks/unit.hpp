// SPDX-License-Identifier: Apache-2.0
// Finds the time unit that claims files declare (docs/claims.md, "One unit").
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "claims/syntax/syntax.hpp"

namespace robochart::claims {

/// A declared unit, such as `unit 0.1 s`.
struct DeclaredUnit {
    std::int64_t nanoseconds = 0;
    Span span;
};

/// Returns the unit of these files; no value if no file declares one. Reports wrong declarations, and declarations that
/// differ from the first.
[[nodiscard]] std::optional<DeclaredUnit> find_unit(const std::vector<std::shared_ptr<const ClaimFile>>& files,
                                                    const diagnostics::SourceManager& sources,
                                                    diagnostics::Diagnostics& diagnostics);

/// Reports at both places that the two declarations differ.
void report_difference(const DeclaredUnit& one, const DeclaredUnit& other, const diagnostics::SourceManager& sources,
                       diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::claims
