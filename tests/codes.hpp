// SPDX-License-Identifier: Apache-2.0
// Lists the codes of findings for tests.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::tests {

/// Returns the codes of all findings, ordered by place, without advice (RC-W): models of tests are small and seldom use
/// all their declarations.
inline std::vector<std::string> codes_but_advice(const diagnostics::Diagnostics& findings) {
    std::vector<std::string> result;
    for (const auto& finding : findings.sorted_findings())
        if (!finding.rule->code.starts_with("RC-W")) result.emplace_back(finding.rule->code);
    return result;
}

}  // namespace robochart::tests
