// SPDX-License-Identifier: Apache-2.0
// The claims files of a project (docs/claims.md).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "claims/checks/unit.hpp"
#include "claims/syntax/syntax.hpp"
#include "driver/model/project.hpp"
#include "driver/settings/settings.hpp"
#include "semantics/instantiate/instantiate.hpp"

namespace robochart::driver {

/// Returns the inputs that are not claims files. If all inputs are claims files, returns the models in the folder of
/// these files, or in its parent folder.
[[nodiscard]] std::vector<std::string> model_inputs(const std::vector<std::string>& inputs);

/// Reads the claims files of the inputs into the project, whose model has been read. The function reads a claims file
/// if the file is an input or below an input folder. It also reads a claims file in the folder of an input file, if the
/// claims are about the model of this input file. If the settings ignore claims, the function uses only the time unit
/// in the claims files, and does not report errors in them.
void read_claim_files(Project& project, const LoadSettings& settings);

/// Sets the project's time unit from its claims files. If claims are ignored, this function reports errors in the
/// declarations of time units. Otherwise these errors are reported with the claims.
void find_unit(Project& project);

/// Returns the time unit that is declared in the claims files in or below the folders of these files. Reports errors in
/// these declarations, but no other errors in the files.
[[nodiscard]] std::optional<claims::DeclaredUnit> unit_beside(const std::vector<std::string>& paths,
                                                              diagnostics::SourceManager& sources,
                                                              diagnostics::Diagnostics& diagnostics);

/// Reads and resolves the claims files of a project whose settings ignore claims. Claims about control cycles are
/// decided with the code.
void read_ignored_claims(Project& project, const LoadSettings& settings);

/// Assigns each claims file of the whole project to the part about which it makes claims. Reports an error if a file
/// may be about several parts.
void divide_claim_files(const std::vector<std::shared_ptr<const claims::ClaimFile>>& files,
                        const std::vector<Part>& parts);

/// Returns the claims of the assertion files and of the claims files.
[[nodiscard]] std::vector<ClaimName> all_claims_of(const Project& project);

/// Resolves the claims in the project's system. Compares the values of conditions with the finite instantiation. For
/// claims that set constants, `carriers` contains the carriers of this instantiation.
void check_claim_files(Project& project, ir::Carriers carriers);
/// Resolves the claims in the model, without an instantiation.
void check_claim_files(Project& project, const ir::System& system);

}  // namespace robochart::driver
