// SPDX-License-Identifier: Apache-2.0
// See unit.hpp.
#include "claims/checks/unit.hpp"

#include "base/durations/time_unit.hpp"
#include "claims/checks/duration.hpp"
#include "claims/checks/rules.hpp"

namespace robochart::claims {
namespace {

std::optional<DeclaredUnit> declared_unit(const Duration& unit, diagnostics::Diagnostics& diagnostics) {
    const bool time = unit.unit != TimeUnit::none && unit.unit != TimeUnit::units;
    const auto length = time && !unit.negative ? nanoseconds_of(unit) : std::nullopt;
    if (length && *length > 0) return DeclaredUnit{*length, unit.span};
    diagnostics.report(rules::wrong_duration, unit.span,
                       {"the length of a time unit is a time above 0, such as `unit 0.1 s`"});
    return std::nullopt;
}

}  // namespace

std::optional<DeclaredUnit> find_unit(const std::vector<std::shared_ptr<const ClaimFile>>& files,
                                      const diagnostics::SourceManager& sources,
                                      diagnostics::Diagnostics& diagnostics) {
    std::optional<DeclaredUnit> result;
    for (const auto& file : files)
        for (const Duration& declared : file->units) {
            const std::optional<DeclaredUnit> unit = declared_unit(declared, diagnostics);
            if (unit && result && unit->nanoseconds != result->nanoseconds)
                report_difference(*result, *unit, sources, diagnostics);
            else if (unit && !result)
                result = unit;
        }
    return result;
}

void report_difference(const DeclaredUnit& one, const DeclaredUnit& other, const diagnostics::SourceManager& sources,
                       diagnostics::Diagnostics& diagnostics) {
    const auto report = [&](const DeclaredUnit& here, const DeclaredUnit& there) {
        diagnostics.report(rules::units_differ, here.span,
                           {durations::duration_text(here.nanoseconds), durations::duration_text(there.nanoseconds),
                            sources.path_and_line(there.span)});
    };
    report(other, one);
    report(one, other);
}

}  // namespace robochart::claims
