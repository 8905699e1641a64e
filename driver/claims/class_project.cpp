// SPDX-License-Identifier: Apache-2.0
#include "driver/claims/class_project.hpp"

#include <algorithm>

namespace robochart::driver {
namespace {

bool observes_values(const ir::Property& property) {
    return property.kind == ir::PropertyKind::refines || property.kind == ir::PropertyKind::equals ||
           property.kind == ir::PropertyKind::conforms;
}

}  // namespace

ClassProject class_project(const Project& project, const Settings& settings) {
    const bool observed = !project.system.csp_blocks.empty() || !settings.swarm.file.empty() ||
                          std::ranges::any_of(project.system.properties, observes_values);
    const bool ranges_chosen =
        std::ranges::any_of(project.asked.ranges, [](const auto& range) { return range.first != "clock"; });
    if (settings.claims.concrete || ranges_chosen || observed) return {};
    auto replaced = ir::class_model(project.system, project.instantiation);
    if (!replaced) return {};
    ClassProject result{with_data(project, std::move(replaced->system), std::move(replaced->instantiation)),
                        std::move(replaced->data), replaced->small_carriers};
    result.project->outputs_replaced = std::move(replaced->outputs_replaced);
    return result;
}

bool is_open_in_classes(const Project& classes, const csp_emit::Obligation& obligation) {
    constexpr std::string_view machine = "state machine ";
    if (obligation.kind != ir::PropertyKind::deterministic) return false;
    if (!obligation.component.starts_with(machine)) return !classes.outputs_replaced.empty();
    return classes.outputs_replaced.contains(obligation.component.substr(machine.size()));
}

bool is_decided_in_carriers(const ClassProject& classes, const csp_emit::Obligation& obligation) {
    return classes.project && classes.small_carriers && is_open_in_classes(*classes.project, obligation);
}

}  // namespace robochart::driver
