// SPDX-License-Identifier: Apache-2.0
// See stepped_component.hpp.
#include "app/step/stepped_component.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/command/run.hpp"

namespace robochart::app {
namespace {

const cspm::ExprPtr& process_of(const csp_emit::Emission& emission, const std::string& name) {
    const auto found = std::ranges::find_if(
        emission.components, [&](const csp_emit::ComponentProcesses& component) { return component.path == name; });
    if (found == emission.components.end()) throw UsageError(fmt::format("{} has no separate process", name));
    return found->process;
}

}  // namespace

SteppedComponent::SteppedComponent(driver::Project& project, const std::string& name, csp_emit::Time time,
                                   const Options& options)
    : emission_(emit_csp(project, options.claims, options.swarm, time)),
      session_(emission_.script, &options.run->budget()),
      context_{emission_.provenance, project.system, project.instantiation, project.sources, session_, project.unit},
      reader_(context_),
      stepper_(reader_, session_.process(process_of(emission_, name))) {}

}  // namespace robochart::app
