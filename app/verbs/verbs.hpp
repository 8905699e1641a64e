// SPDX-License-Identifier: Apache-2.0
// Declares one function for each verb. It uses only the public headers of the components and returns the exit code.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/command/options.hpp"
#include "app/report/report.hpp"
#include "driver/claims/turns.hpp"
#include "driver/model/pipeline.hpp"

namespace robochart::app {

/// Runs the verb that the options name, and returns its exit code.
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

/// Throws UsageError if the folder for certificates is not empty.
void require_empty_certificates(const Options&);

/// Writes csp-gen/… below the output folder.
[[nodiscard]] bool write_csp(driver::Project&, const Options&, Report&);
/// Writes cpp/COMPONENT/… below the output folder.
[[nodiscard]] bool write_cpp(driver::Project&, const Options&, Report&);
/// Writes prism/MODULE.prism below the output folder.
[[nodiscard]] bool write_prism(driver::Project&, const Options&, Report&);
/// Returns the time units of a control cycle: the value of --cycle, otherwise the cycle of a RoboSim component,
/// otherwise 1.
[[nodiscard]] std::uint32_t control_cycle(const driver::Project&, const ir::ComponentRef&, const Options&);
void check_conformance(driver::Project&, const Options&, Report&);
/// Writes monitor/COMPONENT/… below the output folder.
[[nodiscard]] bool write_monitors(driver::Project&, const Options&, Report&);
/// Writes tests/COMPONENT/… below the output folder.
[[nodiscard]] bool write_tests(driver::Project&, const Options&, Report&);
/// Writes rst/COMPONENT_sim.rst and .rsa below the output folder.
[[nodiscard]] bool write_robosim(driver::Project&, const Options&, Report&);
/// Runs conform --traces, which checks logs of runs against the models.
Exit conform_traces(const std::vector<driver::Part>&, const Options&);
/// Runs conform RULES.sleec --traces, which checks logs of runs against rules.
Exit conform_rules(const Options&);
/// Runs conform MODEL.claims --traces, which checks logs of runs against claims.
Exit conform_claims(const Options&);
/// Runs emit monitor RULES.sleec, which writes monitor/RULES/… below the output folder. Returns false if a file is
/// wrong.
[[nodiscard]] bool write_rule_monitors(const Options&, Report&);
/// Runs emit monitor MODEL.claims, which writes monitor/CLAIM/… below the output folder. Returns false if a file is
/// wrong, or if a claim has no monitor.
[[nodiscard]] bool write_claim_monitors(const Options&, Report&);

}  // namespace robochart::app
