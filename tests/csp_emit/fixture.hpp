// SPDX-License-Identifier: Apache-2.0
// Generates scripts from RoboChart text, and decides assertions that compare them with hand-written CSPM.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "csp_emit/emit.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit::testing {

struct Model {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    ir::System system;
    ir::Instantiation instantiation;

    [[nodiscard]] std::string messages() const;
    [[nodiscard]] std::vector<std::string> codes() const;  ///< of all findings except advice (RC-W)
    [[nodiscard]] Emission emit(Time time, bool core = false);
    /// Stores every variable of the machines in its own memory process.
    [[nodiscard]] Emission emit_with_memories(Time time, bool core = false);
};

/// Loads one .rct text and, if not empty, one .assertions text.
[[nodiscard]] std::unique_ptr<Model> load_model(const std::string& rct, const std::string& assertions = "");
/// Loads several files by their paths.
[[nodiscard]] std::unique_ptr<Model> model_of(const std::vector<std::pair<std::string, std::string>>& files);
/// Loads one .rct file alone.
[[nodiscard]] std::unique_ptr<Model> model_file(const std::string& path);
/// Loads a file or folder.
[[nodiscard]] std::unique_ptr<Model> project(const std::string& path);

/// Appends CSPM text to the model's script and decides every assertion in it. Returns "holds", "fails" or the reason
/// why it is undecided.
[[nodiscard]] std::vector<std::string> decide_with(Model&, Time, const std::string& cspm);
/// A step of the counterexample to `specification [T= process`: the names of its event (even if hidden) and of its
/// states.
struct ReportedStep {
    std::string event, state;
};
[[nodiscard]] std::vector<ReportedStep> reported_steps(Model&, Time, const std::string& process,
                                                       const std::string& specification);
/// Decides every assertion of a script.
[[nodiscard]] std::vector<std::string> decide_script(const cspm::Script&);
/// Returns the verdict on each obligation of the model in this time: "holds", "fails", "no check: why" or another
/// outcome.
[[nodiscard]] std::vector<std::string> decide_obligations(Model&, Time);
/// Returns `holds` if both refinements hold in the failures-divergences model. Otherwise returns the failure with its
/// trace.
[[nodiscard]] std::string check_equivalence(Model&, Time, const std::string& process, const std::string& specification,
                                            const std::string& definitions);

}  // namespace robochart::csp_emit::testing
