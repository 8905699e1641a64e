// SPDX-License-Identifier: Apache-2.0
// Runs an example of a rule's page. Its blocks become files, and its command (if there is one) runs in this process.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "base/rule_pages/rule_pages.hpp"

namespace robochart::testing {

/// The result of an example.
struct Judgement {
    std::multiset<std::string> findings;  ///< "FILE:LINE CODE", or ":0 CODE" without a place
    std::multiset<std::string> expected;  ///< from `// expect: CODE …` (`-- expect:` in CSPM), in the same form
    std::set<const diagnostics::Rule*> rules;
    std::string report;  ///< the findings in readable form
    [[nodiscard]] std::set<std::string> codes() const;
};

/// Writes the blocks into a separate folder and loads it as a project. A console block such as `$ robochart-verify emit
/// cpp MODEL` selects another verb. A CSPM block is parsed as a script.
[[nodiscard]] Judgement judge(const std::vector<diagnostics::Block>& example);

/// Judges existing files in the same way.
[[nodiscard]] Judgement judge_file(const std::string& path);

}  // namespace robochart::testing
