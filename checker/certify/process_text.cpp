// SPDX-License-Identifier: Apache-2.0
// Writes processes for certificates. A component that is off is written as a further state without transitions.
#include "checker/certify/process_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "checker/machine/content.hpp"
#include "checker/machine/supercombinator_system.hpp"

namespace robochart::certify {
namespace {

using lts::Event;
using process::EventSet;

/// Tau and tick have these numbers in every certificate. The other events are numbered in the order of the list.
constexpr std::uint32_t tau_number = 0, tick_number = 1, first_number = 2;

class Writer {
public:
    Writer(const lts::EventTable& events, EventSet used, diagnostics::Pollable& budget) : budget_(budget) {
        std::ranges::sort(used);
        used.erase(std::unique(used.begin(), used.end()), used.end());
        text_ = "robochart-verify process 1\n";
        std::string names;
        for (const Event event : used) {
            if (event == process::tau || event == process::tick) continue;
            numbers_.emplace(event, first_number + static_cast<std::uint32_t>(numbers_.size()));
            names += one_line(events.name(event)) + "\n";
        }
        text_ += fmt::format("events {}\n{}", numbers_.size(), names);
    }

    void begin_components(std::size_t count) { text_ += fmt::format("components {}\n", count); }
    void begin_component(std::size_t states, std::size_t initial, const std::string& name) {
        text_ += fmt::format("component {} {} {}\n", states, initial, one_line(name));
    }
    /// Adds the transitions of one state, in ascending order and without duplicates.
    void add_row(std::vector<std::pair<Event, std::uint32_t>> row) {
        budget_.poll();
        for (auto& [event, target] : row) event = number_of(event);
        std::ranges::sort(row);
        row.erase(std::unique(row.begin(), row.end()), row.end());
        for (const auto& [event, target] : row)
            fmt::format_to(std::back_inserter(text_), "{}{} {}", &event == &row.front().first ? "" : " ", event,
                           target);
        text_ += '\n';
    }
    void begin_region(std::size_t participants, std::size_t rules) {
        text_ += fmt::format("region {} {}\n", participants, rules);
    }
    void add_slot(std::size_t slot) { text_ += fmt::format("slot {}\n", slot); }
    void add_rule(Event event, std::uint32_t level, const std::vector<std::pair<std::uint32_t, Event>>& requirements,
                  const std::vector<machine::Assignment>& assignments) {
        budget_.poll();
        const auto out = std::back_inserter(text_);
        fmt::format_to(out, "rule {} {} {}", number_of(event), level == machine::no_level ? "-" : std::to_string(level),
                       requirements.size());
        for (const auto& [participant, required] : requirements)
            fmt::format_to(out, " {} {}", participant, number_of(required));
        for (const machine::Assignment& assignment : assignments)
            fmt::format_to(out, " {} {}", assignment.slot, assignment.value);
        text_ += '\n';
    }
    [[nodiscard]] std::string finish() {
        text_ += "end\n";
        return std::move(text_);
    }

private:
    [[nodiscard]] std::uint32_t number_of(Event event) const {
        if (event == process::tau) return tau_number;
        return event == process::tick ? tick_number : numbers_.at(event);
    }

    diagnostics::Pollable& budget_;
    std::map<Event, std::uint32_t> numbers_;
    std::string text_;
};

void write_region(const machine::Supercombinator& process, std::size_t index, Writer& writer) {
    const machine::Region& region = process.regions[index];
    writer.begin_region(region.participants.size(), region.rules.size());
    for (const machine::Participant& participant : region.participants) {
        if (participant.is_region)
            write_region(process, participant.index, writer);
        else
            writer.add_slot(participant.index);
    }
    const auto requirement = [&](const machine::Requirement& one) {
        return std::pair{one.participant, region.alphabets[one.participant][one.event]};
    };
    for (const machine::Rule& rule : region.rules) {
        std::vector<std::pair<std::uint32_t, Event>> requirements{requirement(rule.lead)};
        for (std::uint32_t i = rule.first_requirement; i < rule.end_requirement; ++i)
            requirements.push_back(requirement(region.requirements[i]));
        // For speed: the certifier starts with the transitions of the first requirement and finds those of regions more
        // slowly, so regions come first.
        std::stable_partition(requirements.begin(), requirements.end(),
                              [&](const auto& one) { return region.participants[one.first].is_region; });
        const auto first = region.assignments.begin();
        writer.add_rule(rule.event, rule.level, requirements,
                        {first + rule.first_assignment, first + rule.end_assignment});
    }
}

void write_component(const machine::Component& component, machine::Local initial, const std::string& name,
                     Writer& writer) {
    writer.begin_component(component.size() + 1, initial, name);
    for (machine::Local state = 0; state <= component.size(); ++state) {
        std::vector<std::pair<Event, std::uint32_t>> row;
        for (const machine::Component::Edge& edge : component.edges(state))
            row.emplace_back(component.alphabet()[edge.event], edge.target);
        writer.add_row(std::move(row));
    }
}

/// Returns the text of the component's initial state if it is short. Otherwise returns the number of the slot.
std::string component_name(const machine::Component& component, std::size_t slot, const process::TermStore& terms) {
    constexpr std::size_t longest = 100;
    const std::string name = component.size() == 0 ? "" : process::describe(terms, component.term_of(0));
    return name.empty() || name.size() > longest ? fmt::format("component {}", slot) : name;
}

std::string compiled_text(const machine::SupercombinatorSystem& system, const process::TermStore& terms,
                          diagnostics::Pollable& budget) {
    const machine::Supercombinator& process = system.combined();
    EventSet used;
    machine::add_events(process, used);
    Writer writer(system.events(), std::move(used), budget);
    writer.begin_components(process.components.size());
    for (std::size_t slot = 0; slot < process.components.size(); ++slot) {
        const machine::Component& component = *process.components[slot];
        write_component(component, process.initial[slot], component_name(component, slot, terms), writer);
    }
    write_region(process, process.regions.size() - 1, writer);
    return writer.finish();
}

}  // namespace

std::string one_line(const std::string& text) {
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
    std::string result;
    bool gap = false;  // true while spaces are dropped after a control character
    for (const char c : text) {
        if (is_control(c) && !gap) result += ' ';
        gap = is_control(c) || (gap && c == ' ');
        if (!gap) result += c;
    }
    return result;
}

std::string graph_text(const lts::Graph& graph, const lts::EventTable& events, diagnostics::Pollable& budget) {
    EventSet used;
    machine::add_events(graph, used);
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
    Writer writer(events, used, budget);
    writer.begin_components(1);
    writer.begin_component(graph.size(), 0, "the process");
    for (lts::StateIndex state = 0; state < graph.size(); ++state) {
        std::vector<std::pair<Event, std::uint32_t>> row;
        for (const lts::Edge& edge : graph.edges(state)) row.emplace_back(edge.event, edge.target);
        writer.add_row(std::move(row));
    }
    writer.begin_region(1, used.size());
    writer.add_slot(0);
    for (const Event event : used) writer.add_rule(event, machine::no_level, {{0, event}}, {});
    return writer.finish();
}

std::string event_list_text(const lts::EventTable& table, const std::vector<lts::Event>& events) {
    std::string text = fmt::format("robochart-verify events 1\nevents {}\n", events.size());
    for (const Event event : events) text += one_line(table.name(event)) + "\n";
    return text + "end\n";
}

std::optional<lts::Graph> explored_graph(lts::TransitionSystem& process, diagnostics::Pollable& budget) {
    struct TooManyStates {};
    std::optional<lts::Graph> result;
    process.set_budget(budget);
    try {
        result = lts::explore(process, [&](std::size_t states) {
                     budget.poll();
                     if (states > most_explicit_states) throw TooManyStates{};
                 }).graph;
    } catch (const TooManyStates&) {
    }
    process.set_budget(diagnostics::unlimited);
    return result;
}

std::optional<std::string> process_text(lts::TransitionSystem& process, const process::TermStore& terms,
                                        diagnostics::Pollable& budget) {
    if (const auto* const compiled = dynamic_cast<const machine::SupercombinatorSystem*>(&process))
        return compiled_text(*compiled, terms, budget);
    const std::optional<lts::Graph> graph = explored_graph(process, budget);
    return graph ? std::optional(graph_text(*graph, process.events(), budget)) : std::nullopt;
}

}  // namespace robochart::certify
