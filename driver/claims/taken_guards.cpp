// SPDX-License-Identifier: Apache-2.0
#include "driver/claims/taken_guards.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/diagnostics/text.hpp"
#include "csp_emit/claimed_components.hpp"
#include "semantics/ir/element_at.hpp"
#include "semantics/ir/untimed_guards.hpp"

namespace robochart::driver {
namespace {

const char* const remedy_of_guards = "a `timed assertion` decides these conditions";

bool is_within(diagnostics::Span inner, diagnostics::Span outer) {
    return inner.is_known() && inner.source == outer.source && outer.begin <= inner.begin && inner.end <= outer.end;
}

std::string guard_text(const diagnostics::SourceManager& sources, diagnostics::Span span) {
    if (!span.is_known()) return "its clocks";
    return fmt::format(
        "`{}`", diagnostics::on_one_line(sources.source_text(span.source).substr(span.begin, span.end - span.begin)));
}

Ground ground_of(const Project& project, const ir::Transition& transition) {
    const std::vector<ir::ExprPtr> left_open = ir::untimed_guard(transition.guard).left_open;
    std::vector<std::string> parts;
    for (const ir::ExprPtr& part : left_open) {
        std::string text = guard_text(project.sources, part->span);
        if (std::ranges::find(parts, text) == parts.end()) parts.push_back(std::move(text));
    }
    Ground ground;
    ground.kind = GroundKind::guard;
    ground.text = fmt::format("the condition of `{}` was taken for true as far as it reads clocks: {}", transition.name,
                              fmt::join(parts, ", "));
    ground.element = project.label + ir::element_at(project.system, transition.origin.span);
    const diagnostics::Span first = left_open.empty() ? diagnostics::Span{} : left_open.front()->span;
    set_place(project.sources, is_within(first, transition.origin.span) ? first : transition.origin.span, ground);
    ground.remedy = remedy_of_guards;
    return ground;
}

}  // namespace

TakenGuards::TakenGuards(const Project& project, const csp_emit::Emission& emission, csp_emit::Time time)
    : emission_(emission) {
    if (time == csp_emit::Time::timed) return;
    for (const ir::Machine& machine : project.system.machines)
        for (const ir::Transition& transition : machine.transitions) {
            transitions_.insert(transition.origin.element);
            if (!transition.guard_timed) continue;
            const diagnostics::Span span = transition.origin.span;
            guards_[{span.source, span.begin}] = {ground_of(project, transition), transition.origin.element,
                                                  transition.trigger.has_value()};
        }
    const auto note = [&](const std::string& component, const ir::Origin& origin) {
        const Key key{origin.span.source, origin.span.begin};
        if (guards_.contains(key)) inside_[component].insert(key);
    };
    for (const auto& [name, event] : emission.provenance.events) note(event.component, event.origin);
    for (const auto& [name, definition] : emission.provenance.definitions)
        for (const auto& offer : definition.offers) note(definition.component, offer->origin);
}

/// Adds the condition of the transition that the event names. If a step may belong to several transitions, the event
/// names none, and the conditions of all possible transitions are added.
void TakenGuards::add_of_event(const runs::Event& event, Basis& basis) const {
    const bool transition = event.kind == runs::Kind::transition;
    if (!transition && event.kind != runs::Kind::input) return;
    const bool known = transitions_.contains(event.element);
    const auto found = inside_.find(event.component);
    if (found == inside_.end()) return;
    for (const Key& key : found->second) {
        const Guard& guard = guards_.at(key);
        if (known ? guard.element == event.element : guard.trigger != transition) add(basis, guard.ground);
    }
}

void TakenGuards::add_of_run(const runs::Run& run, Basis& basis) const {
    for (const runs::Step& step : run.steps) {
        add_of_event(step.event, basis);
        for (const runs::Event& event : step.with) add_of_event(event, basis);
    }
}

void TakenGuards::add_of(const std::vector<cspm::ExprPtr>& expressions, Basis& basis) const {
    const std::set<std::string> paths = csp_emit::components_in(emission_, expressions);
    std::set<Key> keys;
    for (const auto& [component, transitions] : inside_)
        for (const std::string& path : paths)
            if (component == path || component.starts_with(path + "::"))
                keys.insert(transitions.begin(), transitions.end());
    for (const Key& key : keys) add(basis, guards_.at(key).ground);
}

void TakenGuards::add_of_assertion(const cspm::Decl& decl, bool holds, Basis& basis) const {
    if (!has_guards()) return;
    const cspm::Assertion& assertion = decl.assertion;
    const bool traces = assertion.kind == cspm::AssertionKind::refinement && assertion.model == cspm::Model::traces;
    if (traces && holds != assertion.negated)
        add_of({assertion.specification}, basis);
    else
        add_of({assertion.specification, assertion.implementation}, basis);
}

}  // namespace robochart::driver
