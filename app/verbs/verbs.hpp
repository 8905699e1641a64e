// SPDX-License-Identifier: Apache-2.0
// One function for each verb; each uses only the public headers of the components and returns the exit code.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/claims/turns.hpp"
#include "app/command/options.hpp"
#include "app/command/pipeline.hpp"
#include "app/report/report.hpp"
#include "prism/emit/emission.hpp"

namespace robochart::app {

/// Runs the verb of the options.
Exit run_verb(const Options&);

Exit run_model(const Options&);  ///< verify, check, emit, conform
Exit run_cspm(const Options&);
Exit export_process(const Options&);  ///< cspm --export
Exit run_prism(const Options&);
Exit run_rules(const Options&);  ///< SLEEC rules
Exit run_explain(const Options&);
Exit run_validate(const Options&);
Exit run_draw(const Options&);
Exit run_format(const Options&);
Exit run_init(const Options&);
Exit run_simulate(const Options&);  ///< in the built-in world
Exit run_tune(const Options&);
Exit run_step(const Options&);  ///< reads commands from standard input
Exit run_lsp();                 ///< serves an editor on stdin and stdout until it exits

/// Decides the model's assertions in the selected semantics.
void check_assertions(Project&, const Options&, Report&);
/// The region of a span with its end; no value if it is unknown.
[[nodiscard]] std::optional<runs::Place> region_of(const Project&, diagnostics::Span);
/// The probabilistic claims of a model, decided on the Markov models that the options select.
class ProbabilityClaims {
public:
    /// Lists the claims in the report. Refers to its arguments.
    ProbabilityClaims(Project&, const Options&, Report&);
    ~ProbabilityClaims();
    ProbabilityClaims(const ProbabilityClaims&) = delete;
    ProbabilityClaims& operator=(const ProbabilityClaims&) = delete;

    void add_to(std::vector<WaitingClaim>& claims);
    /// Frees what claims share.
    void give_back();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
    Report& report_;
};

/// Sets the place of a claim.
void set_place(const Project&, diagnostics::Span, AssertionReport&);
/// The ranges of RoboTool's encoding; no value, with a finding, if they cannot be read.
[[nodiscard]] std::optional<prism_emit::Preferences> read_preferences(Project&, const Options&);
/// Writes csp-gen/… below the output folder.
[[nodiscard]] bool write_csp(Project&, const Options&, Report&);
/// Writes cpp/COMPONENT/… below the output folder.
[[nodiscard]] bool write_cpp(Project&, const Options&, Report&);
/// Writes prism/MODULE.prism below the output folder.
[[nodiscard]] bool write_prism(Project&, const Options&, Report&);
void check_conformance(Project&, const Options&, Report&);
/// Writes monitor/COMPONENT/… below the output folder.
[[nodiscard]] bool write_monitors(Project&, const Options&, Report&);
/// Writes tests/COMPONENT/… below the output folder.
[[nodiscard]] bool write_tests(Project&, const Options&, Report&);
/// conform --traces: checks logs of runs against the models.
Exit conform_traces(const std::vector<Part>&, const Options&);
/// conform RULES.sleec --traces: checks logs of runs against rules.
Exit conform_rules(const Options&);
/// emit monitor RULES.sleec: writes monitor/RULES/… below the output folder; returns false if a file is wrong.
[[nodiscard]] bool write_rule_monitors(const Options&, Report&);

}  // namespace robochart::app
