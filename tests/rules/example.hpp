// Running an example of a rule's page: its blocks become files, its command (if it shows one) is run in this process.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/command/rule_pages.hpp"
#include "diagnostics/diagnostic.hpp"

namespace robochart::testing {

/// What an example gave.
struct Judgement {
    std::multiset<std::string> findings;  ///< "FILE:LINE CODE"; without place ":0 CODE"
    std::multiset<std::string> expected;  ///< the same, from `// expect: CODE …` (`-- expect:` in CSPM)
    std::set<const diagnostics::Rule*> rules;
    std::string report;  ///< the findings as people see them
    [[nodiscard]] std::set<std::string> codes() const;
};

/// Writes the blocks into a folder of its own and reads it as a project. A console block says what else is done:
/// `$ robochart-verify emit cpp MODEL`. A CSPM block is read as a script.
[[nodiscard]] Judgement judge(const std::vector<app::Block>& example);

/// The same for files that are already there.
[[nodiscard]] Judgement judge_file(const std::string& path);

}  // namespace robochart::testing
