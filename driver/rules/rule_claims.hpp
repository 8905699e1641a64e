// SPDX-License-Identifier: Apache-2.0
// Decides claims that a component conforms to a SLEEC rule (`sleec assertion`). The rule files are in the folder of the
// assertion file.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "claims/sleec/checks/checked.hpp"
#include "driver/model/pipeline.hpp"
#include "driver/results/results.hpp"
#include "driver/results/rule_verdict.hpp"
#include "driver/rules/model_rules.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::driver {

/// A rule file with its findings.
struct LoadedRules {
    std::string path;
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    std::optional<sleec::CheckedRules> rules;  ///< no value if the findings contain errors
};
/// Reads a rule file; "-" is standard input. If `unit` gives the length of a time unit, a second in a rule is a real
/// second. Otherwise, a second is a time unit.
void load_rules(const std::string& path, LoadedRules& loaded, durations::Unit unit = {});
/// Returns true if a limit above 0 of these rules is a number of seconds, because no time unit is declared.
[[nodiscard]] bool counts_seconds(const sleec::CheckedRules& rules);

/// Decides the claims of one model. Reads every file only once. Stores references to the constructor's arguments.
class RuleClaims {
public:
    RuleClaims(const Project& project, const csp_emit::Emission& emission, const SearchContext& search);
    ~RuleClaims();
    RuleClaims(const RuleClaims&) = delete;
    RuleClaims& operator=(const RuleClaims&) = delete;

    /// Answers a property of the kind `conforms`. The answer is an error if the rule does not fit the component, or if
    /// no file or several files contain the rule.
    void decide_property(const ir::Property& property, const SearchContext& search, AssertionReport& report);

private:
    struct Found {
        const LoadedRules* file = nullptr;
        std::size_t rule = 0;
    };
    const std::vector<std::unique_ptr<LoadedRules>>& rule_files_for(const std::string& assertions);
    Found find(const ir::Property& property);
    const csp_emit::ComponentProcesses* find_component(const ir::Property& property) const;
    TimeStops time_stops(const csp_emit::ComponentProcesses& component, const LoadedRules& file,
                         const SearchContext& search);

    const Project& project_;
    const csp_emit::Emission& emission_;
    SearchContext search_;
    std::map<std::string, std::vector<std::unique_ptr<LoadedRules>>> folders_;
    std::map<std::string, TimeStops> time_stops_;  ///< key: the path of the component
};

}  // namespace robochart::driver
