// One function for each verb, using only the public headers of the components. Each returns the exit code.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/claims/turns.hpp"
#include "app/command/options.hpp"
#include "app/command/pipeline.hpp"
#include "app/report/report.hpp"
#include "prism_emit/emission.hpp"

namespace robochart::app {

/// Whichever verb the options name.
Exit run_verb(const Options&);

Exit run_model(const Options&);  ///< verify, check, emit, conform
Exit run_cspm(const Options&);
Exit export_process(const Options&);  ///< cspm --export
Exit run_prism(const Options&);
Exit run_rules(const Options&);  ///< of SLEEC
Exit run_explain(const Options&);
Exit run_validate(const Options&);
Exit run_draw(const Options&);
Exit run_format(const Options&);
Exit run_init(const Options&);
Exit run_simulate(const Options&);  ///< in the embedded world
Exit run_tune(const Options&);
Exit run_step(const Options&);  ///< reads its commands from standard input
Exit run_lsp();                 ///< serves an editor on stdin and stdout until it leaves

/// Decides the model's assertions in the times asked for.
void check_assertions(Project&, const Options&, Report&);
/// A span with its end; nothing where it is unknown.
[[nodiscard]] std::optional<runs::Place> region_of(const Project&, diagnostics::Span);
/// The probabilistic claims of a model, on the Markov models that the options ask for.
class ProbabilityClaims {
public:
    /// Lists them in the report. Refers to all that it is given.
    ProbabilityClaims(Project&, const Options&, Report&);
    ~ProbabilityClaims();
    ProbabilityClaims(const ProbabilityClaims&) = delete;
    ProbabilityClaims& operator=(const ProbabilityClaims&) = delete;

    void add_to(std::vector<WaitingClaim>& claims);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
    Report& report_;
};

/// Sets the place of what is claimed there.
void set_place(const Project&, diagnostics::Span, AssertionReport&);
/// The ranges of RoboTool's encoding; nothing, with a finding, where they cannot be read.
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
/// conform --traces: logs of runs against the models.
Exit conform_traces(const std::vector<Part>&, const Options&);
/// conform RULES.sleec --traces: logs of runs against rules.
Exit conform_rules(const Options&);
/// emit monitor RULES.sleec: writes monitor/RULES/… below the output folder; false where a file is wrong.
[[nodiscard]] bool write_rule_monitors(const Options&, Report&);

}  // namespace robochart::app
