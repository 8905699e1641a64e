// SPDX-License-Identifier: Apache-2.0
// Checks that generated code conforms, which most tests of `conform` expect.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "conformance/check/conform.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance::test {

/// Checks that the code of a component conforms, and returns the result. A failure shows the beginning of the reason
/// and all findings.
inline Result expect_conforming(Model& model, const ir::ComponentRef& component, const Options& options = {}) {
    diagnostics::Diagnostics found;
    Result result = conform(model.system, model.instantiation, component, options, model.sources, found);
    std::string report = result.reason.substr(0, 2000);
    for (const auto& finding : found.sorted_findings())
        report += fmt::format("\n{} {}", finding.rule->code, finding.message());
    EXPECT_EQ(result.outcome, Outcome::conforms) << report;
    return result;
}

}  // namespace robochart::conformance::test
