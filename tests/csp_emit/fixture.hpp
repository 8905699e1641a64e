// RoboChart text to an emitted script, and verdicts of assertions against hand-written CSPM.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "csp_emit/emit.hpp"
#include "diagnostics/diagnostic.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit::testing {

struct Model {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    ir::System system;
    ir::Instantiation instantiation;

    [[nodiscard]] std::string messages() const;
    [[nodiscard]] std::vector<std::string> codes() const;  ///< of all findings but advice (RC-W)
    [[nodiscard]] Emission emit(Time time, bool core = false);
    /// With every variable of the machines in a memory process of its own.
    [[nodiscard]] Emission emit_with_memories(Time time, bool core = false);
};

/// One .rct text and, if not empty, one .assertions text.
[[nodiscard]] std::unique_ptr<Model> model(const std::string& rct, const std::string& assertions = "");
/// Several files by their paths.
[[nodiscard]] std::unique_ptr<Model> model_of(const std::vector<std::pair<std::string, std::string>>& files);
/// One .rct file on its own.
[[nodiscard]] std::unique_ptr<Model> model_file(const std::string& path);
/// A file or folder.
[[nodiscard]] std::unique_ptr<Model> project(const std::string& path);

/// Reads CSPM text behind the model's script and decides every assertion in it: "holds", "fails" or the reason why not.
[[nodiscard]] std::vector<std::string> verdicts(Model&, Time, const std::string& cspm);
/// The steps of the counterexample to `specification [T= process`: names of events (of the hidden ones too) and of
/// states.
struct ReportedStep {
    std::string event, state;
};
[[nodiscard]] std::vector<ReportedStep> reported_steps(Model&, Time, const std::string& process,
                                                       const std::string& specification);
/// Decides every assertion of a script.
[[nodiscard]] std::vector<std::string> decide(const cspm::Script&);
/// The verdict on each obligation of the model in this time: "holds", "fails", "no check: why" or another outcome.
[[nodiscard]] std::vector<std::string> claims(Model&, Time);
/// `holds` for both refinements in the failures-divergences model; else what went wrong, with the counterexample's
/// trace.
[[nodiscard]] std::string equal(Model&, Time, const std::string& process, const std::string& specification,
                                const std::string& definitions);

}  // namespace robochart::csp_emit::testing
