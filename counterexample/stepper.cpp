// SPDX-License-Identifier: Apache-2.0
// Computes offers and absences from the operational semantics.
#include "counterexample/stepper.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "counterexample/interpreter.hpp"
#include "counterexample/structure.hpp"
#include "counterexample/timeline.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::runs {

std::int64_t Stepper::elapsed_time() const {
    return std::ranges::count_if(way_,
                                 [](const Taken& taken) { return taken.offer.happening.event.kind == Kind::tock; });
}

std::vector<Offer> Stepper::offers_at(process::TermId state) const {
    std::vector<Offer> found;
    for (const process::Transition& step : reader_.context().session.transitions(state))
        found.push_back({step, reader_.happening_of(state, step), reader_.name_of(step.event, step.revealed),
                         step.event == process::tau});
    std::stable_partition(found.begin(), found.end(),
                          [](const Offer& offer) { return offer.happening.event.kind != Kind::tock; });
    return found;
}

const std::vector<Offer>& Stepper::current_offers() {
    if (!offers_) offers_ = offers_at(here_);
    return *offers_;
}

void Stepper::take_offer(std::size_t offer) {
    way_.push_back({here_, current_offers().at(offer)});
    move_to(way_.back().offer.step.target);
}

void Stepper::back_to(std::size_t steps) {
    if (steps >= way_.size()) return;
    move_to(way_[steps].before);
    way_.resize(steps);
}

void Stepper::move_to(process::TermId state) {
    here_ = state;
    offers_.reset();
    structure_.reset();
}

std::size_t Stepper::take_forced_steps(std::size_t most) {
    std::set<process::TermId> met{here_};
    std::size_t taken = 0;
    while (taken < most && current_offers().size() == 1 && current_offers().front().hidden) {
        take_offer(0);
        ++taken;
        if (!met.insert(here_).second) break;
    }
    return taken;
}

std::vector<Machine> Stepper::current_machines() {
    const std::vector<Standing> standing = current_components();
    return standing.empty() ? reader_.machines_at(here_) : machines_of(standing);
}

std::vector<Machine> Stepper::machines_of(const std::vector<Standing>& standing) const {
    std::vector<std::vector<Call>> calls;
    calls.reserve(standing.size());
    for (const Standing& component : standing) calls.push_back(component.calls);
    return reader_.machines_of(calls);
}

std::vector<Standing> Stepper::current_components() {
    std::vector<Standing> result;
    const std::optional<process::Behaviour>& whole = current_structure();
    if (!whole) return result;
    for (const auto& leaf : timeline_of(*whole, 0).initial) {
        if (!leaf) continue;
        Standing one{*leaf, reader_.calls_of(*leaf), {}};
        std::vector<Machine> machines = reader_.machines_of({one.calls});
        if (!machines.empty()) one.machine = std::move(machines.front());
        result.push_back(std::move(one));
    }
    // Values that are stored in separate processes are known only from all components together.
    for (const Machine& machine : machines_of(result))
        for (Standing& component : result)
            if (component.machine.component == machine.component) component.machine = machine;
    return result;
}

std::set<std::string> Stepper::offered_elements() {
    std::set<std::string> result;
    for (const Offer& offer : current_offers())
        for (const ComponentStep& step : reader_.taken_apart(here_, offer.step))
            result.merge(reader_.elements_of(step));
    return result;
}

/// Returns the elements that the component could perform without the others.
std::set<std::string> Stepper::ready_elements(const Standing& standing) {
    std::set<std::string> result;
    process::TermStore& terms = reader_.context().session.terms();
    for (const process::Transition& step : reader_.context().session.transitions(standing.term))
        result.merge(reader_.elements_of({reader_.name_of(step.event, step.revealed), standing.calls,
                                          reader_.meanings().calls_in(process::describe(terms, step.target))}));
    return result;
}

std::string Stepper::absence_reason(const ir::Transition& transition, const Standing& standing, bool ready) const {
    if (ready) return "the machine is ready for it, but its surroundings do not take part or something comes first";
    if (!standing.machine.text.starts_with("in ")) return "the machine is not at rest: " + standing.machine.text;
    if (!transition.guard) return "something else comes first";
    const diagnostics::Span span = transition.guard->span;
    std::string text;
    if (span.is_known())
        text = reader_.context().sources.source_text(span.source).substr(span.begin, span.end - span.begin);
    std::vector<std::string> values;
    for (const Variable& variable : standing.machine.variables)
        if (variable.value && variable.kind != VariableKind::countdown && text.find(variable.name) != std::string::npos)
            values.push_back(variable.name + " = " + *variable.value);
    return fmt::format("its condition{} does not hold{}", text.empty() ? "" : " `" + text + "`",
                       values.empty() ? "" : fmt::format(" ({})", fmt::join(values, ", ")));
}

/// Returns the events that the components of a process offer but the process itself does not. It is used for processes
/// that are not components of a model.
std::vector<Absence> Stepper::blocked_by_process() {
    std::vector<Absence> result;
    const std::optional<process::Behaviour>& whole = current_structure();
    if (!whole) return result;
    for (const Blocked& blocked : blocked_events(*whole, most_blocked))
        result.push_back(
            {blocked.component, reader_.name_of(blocked.event, process::no_event), blocked.reason, std::nullopt});
    return result;
}

std::vector<Absence> Stepper::explain_absences() {
    std::vector<Absence> result;
    if (reader_.context().system.machines.empty()) return blocked_by_process();
    const std::set<std::string> offered = offered_elements();
    for (const Standing& standing : current_components()) {
        const std::vector<std::string>& active = standing.machine.active;
        std::optional<std::set<std::string>> ready;
        for (const ir::Machine& machine : reader_.context().system.machines) {
            for (const ir::Transition& transition : machine.transitions) {
                const std::string& source = machine.nodes[transition.source.index].origin.element;
                if (std::ranges::find(active, source) == active.end()) continue;
                const std::string element = element_in(standing.machine.component, transition.origin.element);
                if (offered.contains(element)) continue;
                if (!ready) ready = ready_elements(standing);
                result.push_back({standing.machine.component, ir::text_of(machine, transition),
                                  absence_reason(transition, standing, ready->contains(element)),
                                  reader_.meanings().place_of(transition.origin.span)});
            }
        }
    }
    return result;
}

const std::optional<process::Behaviour>& Stepper::current_structure() {
    if (!structure_) {
        refine::Counterexample nothing;
        nothing.terms = {here_};
        structure_.emplace(reader_.context().session.behaviour(nothing));
    }
    return *structure_;
}

Run Stepper::run(csp_emit::Time time) const {
    refine::Counterexample way;
    way.kind = refine::ViolationKind::no_trace;
    process::TermStore& terms = reader_.context().session.terms();
    way.initial = process::describe(terms, initial_);
    way.terms = {initial_};
    for (const Taken& taken : way_) {
        const process::Transition& step = taken.offer.step;
        way.steps.push_back({step.event, step.revealed, process::describe(terms, step.target)});
        way.terms.push_back(step.target);
    }
    csp_emit::Obligation none;
    none.time = time;
    Run result = interpret_counterexample(reader_.context(), none, way);
    result.end.why.clear();
    return result;
}

}  // namespace robochart::runs
