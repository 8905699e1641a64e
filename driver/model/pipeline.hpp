// SPDX-License-Identifier: Apache-2.0
// The phases of a run over a model, each computed once and on demand (docs/architecture.md has the table).
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

/// Reads the inputs, lowers them and makes them finite, as one project. Stops after the first phase with errors.
/// `diagnostics` contains the errors. Names in the settings that the model does not have are errors too.
[[nodiscard]] std::unique_ptr<Project> load_project(const Settings&, diagnostics::Budget&);

/// Completes the settings from the swarm's file: constants, ranges, and the timed semantics if there is a grid. Errors
/// of that file are reported when the swarm is composed. Throws UsageError if settings about a swarm are given without
/// one, or are invalid.
void add_swarm(Settings&);

/// Divides the inputs into parts. Files that do not belong together are resolved and made finite separately
/// (frontend/project/units.hpp), each part as if it were alone. There is one part if all files belong together. A part
/// with errors is not lowered or made finite; its diagnostics contain them. Names in the settings must exist in some
/// part. The words of --assertion are replaced by the names of the claims that they select (claim_selection.hpp).
[[nodiscard]] std::vector<Part> load_parts(Settings&, diagnostics::Budget&);
/// Like load_parts, but only reads and resolves the parts, without instantiations. Errors are in the diagnostics.
[[nodiscard]] std::vector<Part> read_parts(const LoadSettings&, diagnostics::Budget&);

/// The project with RoboTool's carriers, which exported scripts use; null if the project already has these carriers.
[[nodiscard]] std::unique_ptr<Project> with_carriers_of_robotool(const Project&);

/// The name of a core property for --assertion: "P::S: deadlock-free".
[[nodiscard]] std::string core_name(const csp_emit::Obligation&);

/// True if the settings select the claim of the model with this name. If they select nothing, all claims are selected.
[[nodiscard]] bool is_selected(const ClaimSettings&, const std::string& claim);

/// True if the core properties of a part are checked: they were requested, or assertions are checked and the model has
/// none. False if an earlier part has the same components.
[[nodiscard]] bool core_wanted(const Part&, const Settings&);

/// Whether claims are decided in this semantics.
[[nodiscard]] bool includes_time(Times, csp_emit::Time);

/// The timed or untimed semantics as a type-checked script; diagnostics are added to the project's. The script is made
/// on the first request with the settings of that request, and stored in the project. Throws std::logic_error if the
/// script is wrong although it contains no text of the user.
[[nodiscard]] const csp_emit::Emission& emit_csp(Project&, const ClaimSettings&, const SwarmSettings&, csp_emit::Time);

/// The components for which C++ is generated. Without a name: the modules; if the model has no modules, the
/// controllers; if it has no controllers either, the machines. With a name: the components with this name, of any kind.
/// `robosim`: likewise those of RoboSim, after those of RoboChart. A prefix of the name, `robochart:` or `robosim:`,
/// selects one of the two.
[[nodiscard]] std::vector<ir::ComponentRef> code_components(const ir::System&, const std::string& name,
                                                            bool robosim = false);

/// The name of a component that selects it: qualified, and with the prefix `robochart:` or `robosim:` if components of
/// both have this name.
[[nodiscard]] std::string component_name(const ir::System&, const ir::ComponentRef&);

/// A component's name in file names and generated code: letters, digits and underscores. It contains the package if
/// components of other packages have the same name.
[[nodiscard]] std::string file_name(const Project&, const ir::ComponentRef&);

/// Loads a text that is not a model: a file, or standard input if the path is "-". No value if it cannot be read;
/// `error` contains the reason.
[[nodiscard]] std::optional<diagnostics::SourceId> load_input(diagnostics::SourceManager&, const std::string& path,
                                                              std::string& error);

/// "; it has patrol.scenario": the files of a folder that the user may have meant, if the user names a folder where a
/// file is required. "" if there are none.
[[nodiscard]] std::string files_inside(const std::string& folder, std::string_view ending);

/// True if there are no errors and, if warnings are denied, no warnings.
[[nodiscard]] bool is_acceptable(const Project&, const LoadSettings&);

}  // namespace robochart::driver
