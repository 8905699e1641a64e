// SPDX-License-Identifier: Apache-2.0
// Decides whether components of a model obey SLEEC rules, for `rules FILE MODEL` and `sleec assertion`.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "checker/cspm/session.hpp"
#include "claims/sleec/conformance/endless.hpp"
#include "claims/sleec/conformance/watch.hpp"
#include "claims/sleec/model/linking.hpp"
#include "counterexample/run.hpp"
#include "driver/model/pipeline.hpp"
#include "driver/results/rule_verdict.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::driver {

/// A rule file with its texts.
struct RulesOf {
    const sleec::CheckedRules& rules;
    const diagnostics::SourceManager& sources;
};

/// A verdict and, if the rule is broken, a run of the model that breaks it.
struct JudgedRule {
    RuleVerdict verdict;
    std::optional<runs::Run> run;  ///< no value if no run of the model was found
};

/// Whether time can stop in a component although its platform accepts every output and call at once. After time has
/// stopped, no demand of a rule expires. Therefore the report mentions that time can stop.
struct TimeStops {
    bool stops = false;
    std::string unknown;  ///< why it is not known; "" if it is known
    bool error = false;   ///< true if the component cannot be evaluated, so the answer is unknown
};

/// Decides the rules of a file for one component, in the timed semantics. Stores references to the constructor's
/// arguments.
class ModelRules {
public:
    ModelRules(RulesOf of, const Project& project, const csp_emit::Emission& emission,
               const csp_emit::ComponentProcesses& component, const SearchContext& search);
    ~ModelRules();
    ModelRules(const ModelRules&) = delete;
    ModelRules& operator=(const ModelRules&) = delete;

    [[nodiscard]] JudgedRule judge_rule(std::size_t rule) const;
    [[nodiscard]] TimeStops time_stops() const;

private:
    class Question;
    [[nodiscard]] const csp_emit::Emission& emission_for(std::size_t rule) const;
    [[nodiscard]] cspm::ExprPtr process_in(const csp_emit::Emission& emission) const;
    [[nodiscard]] std::unique_ptr<cspm::Session> make_session(cspm::Script script) const;
    void follow_rule(JudgedRule& judged) const;

    RulesOf of_;
    const Project& project_;
    const csp_emit::Emission& emission_;
    const csp_emit::ComponentProcesses& component_;
    SearchContext search_;
    sleec::ComponentLinking linking_;
    std::unique_ptr<csp_emit::Emission> showing_;  ///< shows the states of the rules; null if the rules name no states
};

}  // namespace robochart::driver
