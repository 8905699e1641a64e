// SPDX-License-Identifier: Apache-2.0
// See sizes.hpp. A process that cannot be evaluated has no size; this is reported.
#include "app/report/sizes.hpp"

#include <fmt/format.h>

#include "app/command/limits.hpp"
#include "app/command/run.hpp"
#include "app/report/state_space.hpp"
#include "checker/process/operational_semantics.hpp"
#include "counterexample/evaluation_failure.hpp"

namespace robochart::app {
namespace {

/// A component by itself may have more states, because its environment restricts it.
constexpr std::uint64_t most_states = 1'000'000;

SizeReport::Size size_of(cspm::Session& session, const cspm::ExprPtr& process, const Options& options) {
    refine::Limits bounds = limits_of_check(options);
    bounds.max_states = std::min<std::uint64_t>(bounds.max_states, most_states);
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
                   csp_emit::Time time, const Options& options, Report& report) {
    for (const csp_emit::ComponentProcesses& component : emission.components) try {
            SizeReport size{project.label + component.path, time == csp_emit::Time::timed ? "timed" : "untimed",
                            size_of(session, component.process, options),
                            size_of(session, component.compressed, options)};
            const auto edit = options.run->lock_for_edit();
            report.sizes.push_back(std::move(size));
        } catch (const cspm::EvaluationError& error) {
            const auto edit = options.run->lock_for_edit();
            report.remarks.push_back(fmt::format("the size of {}{} is not known: {}", project.label, component.path,
                                                 runs::placed_failure(error, project.system, project.sources)));
        }
}

}  // namespace robochart::app
