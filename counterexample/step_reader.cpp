// SPDX-License-Identifier: Apache-2.0
// Reads the machines and the events of steps from the definitions of their components.
#include "counterexample/step_reader.hpp"

#include <algorithm>
#include <tuple>

namespace robochart::runs {

using process::TermId;

namespace {

constexpr std::size_t most_unfoldings = 20;

/// Adds a variable that a memory stores. The value in the machine is at least as recent as that in the memory, so the
/// memory's value is used only if the machine will still read it.
void add_remembered(const csp_emit::DefinitionMeaning& owner, Variable variable, Machine& machine) {
    const auto& read = owner.remembered;
    const auto known = std::ranges::find_if(machine.variables,
                                            [&](const Variable& candidate) { return candidate.name == variable.name; });
    if (known == machine.variables.end() && std::ranges::find(read, variable.name) != read.end())
        machine.variables.push_back(std::move(variable));
}

}  // namespace

std::string element_in(const std::string& component, const std::string& element) {
    return component + " " + element;
}

bool same_event(const Event& one, const Event& other) {
    return one.kind == other.kind && one.component == other.component && one.text == other.text &&
           one.element == other.element;
}

bool is_among(const std::vector<Event>& events, const Event& event) {
    return std::ranges::any_of(events, [&](const Event& candidate) { return same_event(candidate, event); });
}

const std::vector<Call>& StepReader::calls_of(TermId term) {
    const auto [found, added] = calls_.try_emplace(term);
    if (!added) return found->second;
    process::TermStore& terms = context_.session.terms();
    for (std::size_t i = 0; i < most_unfoldings; ++i) {
        found->second = meanings_.calls_in(process::describe(terms, term));
        const TermId next = found->second.empty() ? terms.unfold_calls(term, 1) : term;
        if (next == term) break;
        term = next;
    }
    return found->second;
}

std::vector<Machine> StepReader::machines_of(const std::vector<std::vector<Call>>& components) const {
    std::vector<Machine> result;
    std::vector<const Call*> owners;
    std::vector<const Call*> memories;
    for (const std::vector<Call>& component : components)
        for (const Call& call : component) {
            (call.definition->memory ? memories : owners).push_back(&call);
            if (!call.definition->memory) result.push_back(meanings_.machine_of(call));
        }
    for (const Call* memory : memories)
        for (std::size_t i = 0; i < owners.size(); ++i)
            if (owners[i]->definition->component == memory->definition->component) {
                for (Variable& variable : meanings_.variables_of(*memory))
                    add_remembered(*owners[i]->definition, std::move(variable), result[i]);
                break;
            }
    return result;
}

Happening StepReader::happening_of(const std::vector<ComponentStep>& steps, const std::string& whole) const {
    struct Candidate {
        Event event;
        bool known, machine;
    };
    std::vector<Candidate> candidates;
    for (const ComponentStep& move : steps) {
        const bool machine = !move.before.empty() && !move.before.front().definition->memory;
        const bool known = meanings_.knows_event(move.name);
        candidates.push_back(
            {machine ? meanings_.event_of(move.name, move.before.front(), move.after) : meanings_.event_of(move.name),
             known, machine});
    }
    const auto rank = [](const Candidate& candidate) {
        const bool acts = candidate.event.kind != Kind::input && candidate.event.kind != Kind::external_write &&
                          candidate.event.kind != Kind::read && candidate.event.kind != Kind::empty_read;
        return std::tuple(!candidate.known, !candidate.machine, !acts);
    };
    std::ranges::stable_sort(candidates,
                             [&](const Candidate& one, const Candidate& other) { return rank(one) < rank(other); });
    const auto tock =
        std::ranges::find_if(candidates, [](const Candidate& candidate) { return candidate.event.kind == Kind::tock; });
    if (tock != candidates.end()) return {tock->event, {}};
    if (candidates.empty() || (!candidates.front().known && meanings_.knows_event(whole)))
        return {meanings_.event_of(whole), {}};
    std::vector<Event> with;
    for (std::size_t i = 1; i < candidates.size(); ++i) {
        const Candidate& candidate = candidates[i];
        const bool other =
            candidate.known && candidate.machine && candidate.event.component != candidates.front().event.component;
        if (other && !is_among(with, candidate.event)) with.push_back(candidate.event);
    }
    return {candidates.front().event, with};
}

ComponentStep StepReader::component_step(const process::Move& move) {
    return {name_of(move.step.event, move.step.revealed), calls_of(move.part),
            meanings_.calls_in(process::describe(context_.session.terms(), move.step.target))};
}

std::set<std::string> StepReader::elements_of(const ComponentStep& step) const {
    std::set<std::string> result;
    for (const Call& before : step.before) {
        if (before.definition->memory) continue;
        for (const std::string& element : meanings_.elements_of(step.name, before, step.after))
            result.insert(element_in(before.definition->component, element));
    }
    return result;
}

std::vector<ComponentStep> StepReader::taken_apart(TermId whole, const process::Transition& step) {
    std::vector<ComponentStep> steps;
    for (const process::Move& move : context_.session.split_transition(whole, step))
        steps.push_back(component_step(move));
    return steps;
}

Happening StepReader::happening_of(TermId whole, const process::Transition& step) {
    return happening_of(taken_apart(whole, step), name_of(step.event, step.revealed));
}

}  // namespace robochart::runs
