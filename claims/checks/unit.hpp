// SPDX-License-Identifier: Apache-2.0
// The time unit that claims files declare (docs/claims.md, "One unit").
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "claims/syntax/syntax.hpp"

namespace robochart::claims {

/// `unit 0.1 s`.
struct DeclaredUnit {
    std::int64_t nanoseconds = 0;
    Span span;
};

/// The unit of these files; no value if none declares it. Wrong declarations, and those that differ from the first, are
/// reported.
[[nodiscard]] std::optional<DeclaredUnit> find_unit(const std::vector<std::shared_ptr<const ClaimFile>>& files,
                                                    const diagnostics::SourceManager& sources,
                                                    diagnostics::Diagnostics& diagnostics);

/// Reports, at each of the two places, that they declare different units.
void report_difference(const DeclaredUnit& one, const DeclaredUnit& other, const diagnostics::SourceManager& sources,
                       diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::claims
