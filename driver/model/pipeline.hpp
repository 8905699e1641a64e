// SPDX-License-Identifier: Apache-2.0
// Runs the phases of a command over a model. Each phase is computed once and on demand (table in docs/architecture.md).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "csp_emit/emit.hpp"
#include "driver/model/project.hpp"
#include "driver/settings/settings.hpp"
#include "frontend/syntax/ast.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::driver {

/// Reads the inputs as one project, lowers it and makes it finite. Stops after the first phase with errors.
/// `diagnostics` contains the errors. It is also an error if the settings contain a name that the model does not have.
[[nodiscard]] std::unique_ptr<Project> load_project(const Settings&, diagnostics::Budget&);

/// Completes the settings from the swarm's file: constants, ranges, and the timed semantics if there is a grid. Errors
/// in the swarm's file are reported when the swarm is composed. Throws UsageError if settings about a swarm are
/// invalid, or if they are given without a swarm.
void add_swarm(Settings&);

/// Divides the inputs into parts. Each part consists of files that belong together (frontend/project/units.hpp), and is
/// resolved and made finite as if it were alone. If all files belong together, there is one part. A part with errors is
/// neither lowered nor made finite, and its diagnostics contain the errors. Names in the settings must exist in some
/// part. The words of --assertion are replaced by the names of the claims that they select (claim_selection.hpp).
[[nodiscard]] std::vector<Part> load_parts(Settings&, diagnostics::Budget&);
/// Reads and resolves the parts as load_parts does, but makes no instantiations. The diagnostics contain the errors.
[[nodiscard]] std::vector<Part> read_parts(const LoadSettings&, diagnostics::Budget&);

/// Returns the project with RoboTool's carriers, which exported scripts use. Returns null if the project already has
/// these carriers.
[[nodiscard]] std::unique_ptr<Project> with_carriers_of_robotool(const Project&);

/// Returns the name of a core property for --assertion: "P::S: deadlock-free".
[[nodiscard]] std::string core_name(const csp_emit::Obligation&);

/// Returns true if the settings select the claim of the model with this name. If they select nothing, all claims are
/// selected.
[[nodiscard]] bool is_selected(const ClaimSettings&, const std::string& claim);

/// Returns true if the core properties of a part are checked. Core properties are checked if the user requests them,
/// or if assertions are checked and the model has none. They are not checked if an earlier part has the same
/// components.
[[nodiscard]] bool core_wanted(const Part&, const Settings&);

/// Returns true if claims are decided in this semantics according to the settings.
[[nodiscard]] bool includes_time(Times, csp_emit::Time);

/// Returns the timed or untimed semantics as a type-checked script. Diagnostics are added to the project's diagnostics.
/// The first call makes the script with its settings and stores the script in the project. Throws std::logic_error if
/// the script is wrong although it contains no text of the user.
[[nodiscard]] const csp_emit::Emission& emit_csp(Project&, const ClaimSettings&, const SwarmSettings&, csp_emit::Time);

/// Returns the components for which C++ is generated. If the name is empty, these are the modules. Without modules,
/// they are the controllers; without modules and controllers, the machines. If the name is not empty, they are the
/// components of any kind with this name. If `robosim` is set, RoboSim components follow, selected in the same way. The
/// prefix `robochart:` or `robosim:` of a name selects one of the two notations.
[[nodiscard]] std::vector<ir::ComponentRef> code_components(const ir::System&, const std::string& name,
                                                            bool robosim = false);

/// Returns the name that selects a component. The name is qualified, and has the prefix `robochart:` or `robosim:` if
/// components of both notations have this name.
[[nodiscard]] std::string component_name(const ir::System&, const ir::ComponentRef&);

/// Returns a name of the component for file names and generated code. The name consists of letters, digits and
/// underscores, and contains the package if components of other packages have the same name.
[[nodiscard]] std::string file_name(const Project&, const ir::ComponentRef&);

/// Loads a text that is not a model: a file, or standard input if the path is "-". If the text cannot be read, returns
/// no value, and `error` contains the reason.
[[nodiscard]] std::optional<diagnostics::SourceId> load_input(diagnostics::SourceManager&, const std::string& path,
                                                              std::string& error);

/// Lists files of a folder for a message that a file is required instead of the folder, as in "; it has
/// patrol.scenario". Returns "" if the folder has no files with this ending.
[[nodiscard]] std::string files_inside(const std::string& folder, std::string_view ending);

/// Returns true if there are no errors and, if warnings are denied, no warnings.
[[nodiscard]] bool is_acceptable(const Project&, const LoadSettings&);

}  // namespace robochart::driver
