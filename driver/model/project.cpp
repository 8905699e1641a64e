// SPDX-License-Identifier: Apache-2.0
#include "driver/model/project.hpp"

#include "driver/model/project_claims.hpp"

namespace robochart::driver {

std::shared_ptr<ProjectClaims> make_project_claims() {
    return std::make_shared<ProjectClaims>();
}

std::vector<ClaimName> claims_of(const frontend::Model& model) {
    std::vector<ClaimName> claims;
    for (const auto& file : model.files) {
        std::map<std::size_t, ClaimName> in_file;  // by position
        for (const frontend::Assertion& assertion : file->assertions)
            in_file.emplace(assertion.span.begin, ClaimName{assertion.name, assertion.span});
        for (const frontend::ProbabilisticAssertion& assertion : file->probabilistic_assertions)
            in_file.emplace(assertion.span.begin, ClaimName{assertion.name, assertion.span});
        for (const frontend::KeptPart& part : file->kept)
            if (part.claims) in_file.emplace(part.span.begin, ClaimName{part.name, part.span});
        for (const auto& [place, claim] : in_file) claims.push_back(claim);
    }
    return claims;
}

std::unique_ptr<Project> with_data(const Project& project, ir::System system, ir::Instantiation instantiation) {
    auto result = std::make_unique<Project>(project.texts);
    result->name = project.name;
    result->label = project.label;
    result->folder = project.folder;
    result->shared_names = project.shared_names;
    result->unit = project.unit;
    result->unit_place = project.unit_place;
    result->diagnostics.set_budget(project.diagnostics.budget());
    result->system = std::move(system);
    result->instantiation = std::move(instantiation);
    return result;
}

}  // namespace robochart::driver
