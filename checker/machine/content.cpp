// SPDX-License-Identifier: Apache-2.0
// Writes the content of a compiled process. Omits data that follow from the rest: leading edges, rules by event, and
// estimates of how often an event is possible.
#include "checker/machine/content.hpp"

namespace robochart::machine {

namespace {

constexpr std::uint32_t no_place = static_cast<std::uint32_t>(-1);

class ContentWriter {
public:
    ContentWriter(const EventPlaces& places, diagnostics::Hasher& hasher) : places_(places), hasher_(hasher) {}

    void component(const Component& component) {
        events(component.alphabet());
        std::vector<std::uint32_t> row;
        hasher_.add(component.size());
        for (Local state = 0; state < component.size(); ++state) {
            row.clear();
            for (const Component::Edge& edge : component.edges(state))
                row.insert(row.end(), {edge.event, places_.index_of(edge.revealed), edge.target});
            hasher_.add(row);
        }
    }

    void region(const Region& region) {
        std::vector<std::uint32_t> row;
        for (const Participant& participant : region.participants)
            row.insert(row.end(), {participant.is_region ? 1U : 0U, participant.index});
        hasher_.add(row);
        hasher_.add(region.alphabets.size());
        for (const EventSet& alphabet : region.alphabets) events(alphabet);
        events(region.alphabet);
        row.clear();
        for (const Rule& rule : region.rules)
            row.insert(row.end(), {places_.index_of(rule.event), places_.index_of(rule.revealed), rule.place,
                                   rule.level, rule.lead.participant, rule.lead.event, rule.first_requirement,
                                   rule.end_requirement, rule.first_assignment, rule.end_assignment});
        hasher_.add(row);
        row.clear();
        for (const Requirement& requirement : region.requirements)
            row.insert(row.end(), {requirement.participant, requirement.event});
        hasher_.add(row);
        row.clear();
        for (const Assignment& assignment : region.assignments)
            row.insert(row.end(), {assignment.slot, assignment.value});
        hasher_.add(row);
    }

private:
    void events(const EventSet& events) {
        std::vector<std::uint32_t> row;
        for (const Event event : events) row.push_back(places_.index_of(event));
        hasher_.add(row);
    }

    const EventPlaces& places_;
    diagnostics::Hasher& hasher_;
};

void add(const EventSet& some, EventSet& events) {
    events.insert(events.end(), some.begin(), some.end());
}

}  // namespace

EventPlaces::EventPlaces(EventSet named) : named_(std::move(named)) {
    places_.assign(named_.empty() ? 0 : named_.back() + std::size_t{1}, no_place);
    for (std::uint32_t place = 0; place < named_.size(); ++place) places_[named_[place]] = place;
}

void add_events(const Supercombinator& process, EventSet& events) {
    for (const ComponentPtr& component : process.components) {
        add(component->alphabet(), events);
        for (Local state = 0; state < component->size(); ++state)
            for (const Component::Edge& edge : component->edges(state)) events.push_back(edge.revealed);
    }
    for (const Region& region : process.regions) {
        add(region.alphabet, events);
        for (const EventSet& alphabet : region.alphabets) add(alphabet, events);
        for (const Rule& rule : region.rules) events.insert(events.end(), {rule.event, rule.revealed});
    }
}

void add_events(const lts::Graph& graph, EventSet& events) {
    for (lts::StateIndex state = 0; state < graph.size(); ++state)
        for (const lts::Edge& edge : graph.edges(state)) events.push_back(edge.event);
}

void add_content(const Supercombinator& process, const EventPlaces& places, diagnostics::Hasher& hasher) {
    ContentWriter writer(places, hasher);
    hasher.add(process.components.size());
    for (const ComponentPtr& component : process.components) writer.component(*component);
    hasher.add(process.regions.size());
    for (const Region& region : process.regions) writer.region(region);
    hasher.add(process.initial);
    hasher.add(process.fields.size());
    for (const Field& field : process.fields)
        for (const std::uint32_t value : {field.word, field.shift, field.mask}) hasher.add(std::uint64_t{value});
    hasher.add(std::uint64_t{process.words});
}

void add_content(const lts::Graph& graph, const EventPlaces& places, diagnostics::Hasher& hasher) {
    hasher.add(graph.size());
    std::vector<std::uint32_t> row;
    for (lts::StateIndex state = 0; state < graph.size(); ++state) {
        row.clear();
        for (const lts::Edge& edge : graph.edges(state))
            row.insert(row.end(), {places.index_of(edge.event), static_cast<std::uint32_t>(edge.target)});
        hasher.add(row);
    }
}

}  // namespace robochart::machine
