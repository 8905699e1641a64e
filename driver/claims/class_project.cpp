// SPDX-License-Identifier: Apache-2.0
#include "driver/claims/class_project.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "driver/model/project_claims.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::driver {
namespace {

bool observes_values(const ir::Property& property) {
    return property.kind == ir::PropertyKind::refines || property.kind == ir::PropertyKind::equals ||
           property.kind == ir::PropertyKind::conforms || property.subject.kind == ir::ComponentKind::process;
}

/// Returns the system without the claims that observe values.
ir::System without_observers(ir::System system) {
    system.csp_blocks.clear();
    std::erase_if(system.properties, observes_values);
    return system;
}

/// True if the component is one of the machines or may contain one.
bool concerns(const csp_emit::Obligation& obligation, const std::set<std::string>& machines) {
    constexpr std::string_view machine = "state machine ";
    if (!obligation.component.starts_with(machine)) return !machines.empty();
    return machines.contains(obligation.component.substr(machine.size()));
}

}  // namespace

bool has_observers(const Project& project) {
    const ir::System& system = project.system;
    return !system.csp_blocks.empty() || !project.claims->checked.claims.empty() ||
           std::ranges::any_of(system.properties, [](const auto& property) { return observes_values(property); });
}

bool chooses_ranges(const Project& project) {
    return std::ranges::any_of(project.asked.ranges, [](const auto& range) { return range.first != "clock"; });
}

bool keeps_carriers(const Project& project, const Settings& settings) {
    const bool instantiated = std::ranges::any_of(project.system.csp_blocks, ir::is_instantiations);
    // a simulation declares registers with the types of the events of its component
    return !project.system.simulations.empty() || settings.claims.concrete || chooses_ranges(project) || instantiated ||
           !settings.swarm.file.empty();
}

ClassProject class_project(const Project& project, const Settings& settings) {
    if (keeps_carriers(project, settings)) return {};
    ir::Classification found = ir::classify_data(without_observers(project.system), project.instantiation);
    ClassProject result;
    result.kept = std::move(found.kept);
    if (!found.model) return result;
    ir::ClassModel& replaced = *found.model;
    const bool unlimited =
        !replaced.small_carriers && std::ranges::any_of(replaced.data, &ir::ReplacedData::all_values);
    if (!unlimited && has_observers(project)) {
        for (ir::ReplacedData& data : replaced.data)
            result.kept.push_back({std::move(data.places), {ir::KeepReason::observed, {}}});
        return result;
    }
    result.project = with_data(project, std::move(replaced.system), std::move(replaced.instantiation));
    result.data = std::move(replaced.data);
    result.small_carriers = replaced.small_carriers;
    result.project->outputs_replaced = std::move(replaced.outputs_replaced);
    result.project->related = std::move(replaced.related);
    return result;
}

/// True if `others` contains all places of `data`.
bool are_all_in(const std::vector<ir::ReplacedData>& data, const std::vector<ir::ReplacedData>& others) {
    std::set<std::string> places;
    for (const ir::ReplacedData& other : others) places.insert(other.places.begin(), other.places.end());
    return std::ranges::all_of(data, [&](const ir::ReplacedData& one) {
        return std::ranges::all_of(one.places, [&](const std::string& place) { return places.contains(place); });
    });
}

FreeProject free_project(const Project& project, const Settings& settings, const ClassProject& classes) {
    if (keeps_carriers(project, settings) || !ir::robosim_components(project.system).empty()) return {};
    auto replaced = ir::free_model(without_observers(project.system), project.instantiation);
    if (!replaced) return {};
    const bool unlimited = std::ranges::any_of(replaced->data, &ir::ReplacedData::all_values);
    const bool large = unlimited && !replaced->small_carriers && !are_all_in(replaced->data, classes.data);
    return {with_data(project, std::move(replaced->system), std::move(replaced->instantiation)),
            replaced->free_conditions, large};
}

bool carries_over(const csp_emit::Obligation& obligation, Answer found) {
    using ir::PropertyKind;
    constexpr std::array kinds{PropertyKind::deadlock_free, PropertyKind::divergence_free,
                               PropertyKind::timelock_free, PropertyKind::terminates,
                               PropertyKind::reachable,     PropertyKind::clock_initialised};
    if (std::ranges::find(kinds, obligation.kind) == kinds.end()) return false;
    if (obligation.firing || obligation.recurrence || obligation.premise || obligation.assertions.empty()) return false;
    // if a negated assertion fails, the behaviour of the model is within that of the specification
    const bool negated = found == Answer::fails;
    return std::ranges::all_of(obligation.assertions,
                               [&](const cspm::DeclPtr& assertion) { return assertion->assertion.negated == negated; });
}

bool is_open_in_classes(const Project& classes, const csp_emit::Obligation& obligation, Answer found) {
    if (obligation.kind != ir::PropertyKind::deterministic) return false;
    std::set<std::string> machines;
    for (const ir::RelatedVariables& variables : classes.related) machines.insert(variables.machine);
    return concerns(obligation, machines) || (found == Answer::holds && concerns(obligation, classes.outputs_replaced));
}

bool observes_values(const ir::System& system, const csp_emit::Obligation& obligation) {
    if (obligation.property == ir::no_id) return obligation.component.empty();
    return observes_values(system.properties.at(obligation.property));
}

bool is_decided_in_carriers(const ClassProject& classes, const ir::System& system,
                            const csp_emit::Obligation& obligation) {
    if (!classes.project) return false;
    return observes_values(system, obligation) ||
           (classes.small_carriers && is_open_in_classes(*classes.project, obligation, Answer::holds));
}

}  // namespace robochart::driver
