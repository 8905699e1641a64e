// SPDX-License-Identifier: Apache-2.0
// See sizes.hpp. If a process cannot be evaluated, the error is reported in place of the size.
#include "driver/claims/sizes.hpp"

#include <fmt/format.h>

#include "checker/process/operational_semantics.hpp"
#include "counterexample/evaluation_failure.hpp"
#include "driver/claims/state_space.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::driver {
namespace {

/// The limit is necessary because a component may have more states than the whole model, in which its environment
/// restricts it.
constexpr std::uint64_t most_component_states = 1'000'000;

SizeReport::Size size_of(cspm::Session& session, const cspm::ExprPtr& process, const SearchContext& search) {
    refine::Limits bounds = limits_of_check(search);
    bounds.max_states = std::min<std::uint64_t>(bounds.max_states, most_component_states);
    std::size_t known = 0;
    try {
        const lts::Graph graph = explore_graph(*session.system(process, bounds), bounds, known);
        return {graph.size(), graph.edge_count(), true};
    } catch (const process::Interrupted&) {
        return {known, 0, false};
    }
}

}  // namespace

void measure_sizes(const Project& project, cspm::Session& session, const csp_emit::Emission& emission,
                   csp_emit::Time time, const SearchContext& search, ClaimResults& results) {
    for (const csp_emit::ComponentProcesses& component : emission.components) try {
            SizeReport size{project.label + component.path, time == csp_emit::Time::timed ? "timed" : "untimed",
                            size_of(session, component.process, search),
                            size_of(session, component.compressed, search)};
            const auto edit = search.services.edit();
            results.sizes.push_back(std::move(size));
        } catch (const cspm::EvaluationError& error) {
            const auto edit = search.services.edit();
            results.remarks.push_back(fmt::format("the size of {}{} is not known: {}", project.label, component.path,
                                                  runs::placed_failure(error, project.system, project.sources)));
        }
}

}  // namespace robochart::driver
