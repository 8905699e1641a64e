// SPDX-License-Identifier: Apache-2.0
// The data of a model that the phases of a run share (pipeline.hpp).
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "base/durations/time_unit.hpp"
#include "csp_emit/emit.hpp"
#include "frontend/syntax/ast.hpp"
#include "semantics/data/class_model.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::driver {

/// The claims of claims files (project_claims.hpp).
struct ProjectClaims;
/// Returns an object without claims.
[[nodiscard]] std::shared_ptr<ProjectClaims> make_project_claims();

/// All data about one model.
struct Project {
    explicit Project(
        std::shared_ptr<diagnostics::SourceManager> shared = std::make_shared<diagnostics::SourceManager>())
        : texts(std::move(shared)), sources(*texts) {}

    std::string name;    ///< name of the first input without folder and extension; used in names of written files
    std::string label;   ///< printed before results: "NAME: " if parts share names of components, otherwise ""
    std::string folder;  ///< folder for the files of its components: "NAME/" if `label` is not empty
    std::shared_ptr<diagnostics::SourceManager> texts;
    diagnostics::SourceManager& sources;  ///< shared by all parts of a run
    diagnostics::Diagnostics diagnostics;
    std::unique_ptr<frontend::Model> model;
    std::shared_ptr<ProjectClaims> claims = make_project_claims();  ///< the claims of its claims files; never null
    durations::Unit unit;                                           ///< the time unit, if its claims files declare one
    diagnostics::Span unit_place;                                   ///< the place of this declaration
    ir::System system;
    ir::InstantiationOptions asked;  ///< options for its instantiation
    ir::Instantiation instantiation;
    std::set<std::string> outputs_replaced;     ///< as in semantics/data/class_model.hpp
    std::vector<ir::RelatedVariables> related;  ///< as in semantics/data/class_model.hpp
    std::set<std::string> shared_names;         ///< names of several components of one kind, in different packages
    double seconds = 0;                         ///< time for reading, resolving and lowering
    std::map<csp_emit::Time, csp_emit::Emission> scripts;  ///< scripts made so far (emit_csp)
};

/// Returns a project for the same texts with another system and instantiation, and without a model.
[[nodiscard]] std::unique_ptr<Project> with_data(const Project&, ir::System, ir::Instantiation);

/// A part of a run: files that belong together (pipeline.hpp, load_parts).
struct Part {
    std::unique_ptr<Project> project;
    bool again = false;  ///< true if an earlier part contains the same components
};

/// A claim of an assertion file.
struct ClaimName {
    std::string name;
    diagnostics::Span span;
};
/// Returns the claims of a model's assertion files, in the order of the files.
[[nodiscard]] std::vector<ClaimName> claims_of(const frontend::Model&);

}  // namespace robochart::driver
