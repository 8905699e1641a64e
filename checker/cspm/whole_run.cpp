// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/whole_run.hpp"

#include <algorithm>

namespace robochart::cspm {
namespace {

/// Finds the next omitted value: an underscore between `(` or `,` on the left and `,` or `)` on the right.
std::size_t next_place(std::string_view description, std::size_t from) {
    for (std::size_t at = description.find('_', from); at != std::string_view::npos;
         at = description.find('_', at + 1)) {
        if (at == 0 || at + 1 >= description.size()) continue;
        const char before = description[at - 1];
        const char after = description[at + 1];
        if ((before == '(' || before == ',') && (after == ')' || after == ',')) return at;
    }
    return std::string_view::npos;
}

/// A state of the run, and the index of its predecessor in the layer before it.
struct Reached {
    process::Transition step;
    std::size_t from;
};

}  // namespace

bool leaves_values_out(std::string_view description) {
    return next_place(description, 0) != std::string_view::npos;
}

// Compares only the texts between omitted values. They must occur in the same order, the first one at the beginning and
// the last one at the end.
bool matches_description(std::string_view with_places, std::string_view with_values) {
    std::size_t begin = 0;
    std::size_t at = 0;
    for (std::size_t place = next_place(with_places, 0); place != std::string_view::npos;
         place = next_place(with_places, begin)) {
        const std::string_view part = with_places.substr(begin, place - begin);
        const std::size_t found = begin == 0 ? 0 : with_values.find(part, at);
        if (found == std::string_view::npos || (begin == 0 && !with_values.starts_with(part))) return false;
        at = found + part.size();
        begin = place + 1;
    }
    const std::string_view last = with_places.substr(begin);
    if (begin == 0) return with_values == last;
    return with_values.size() >= at + last.size() && with_values.ends_with(last);
}

std::optional<WholeRun> whole_run(process::OperationalSemantics& semantics, const process::EventTable& events,
                                  process::TermId initial, const std::string& description,
                                  const std::vector<refine::Step>& run, const process::EventTable& events_of_run) {
    constexpr std::size_t most_at_once = 200;
    const process::TermStore& terms = semantics.terms();
    if (!matches_description(description, process::describe(terms, initial))) return std::nullopt;
    std::vector<std::vector<Reached>> layers{{{{process::tau, process::tau, initial}, 0}}};
    for (const refine::Step& step : run) {
        std::vector<Reached> next;
        for (std::size_t from = 0; from < layers.back().size() && next.size() < most_at_once; ++from)
            for (const process::Transition& transition : semantics.successors(layers.back()[from].step.target)) {
                const bool known = std::ranges::any_of(
                    next, [&](const Reached& other) { return other.step.target == transition.target; });
                if (!known && events.name(transition.event) == events_of_run.name(step.event) &&
                    events.name(transition.revealed) == events_of_run.name(step.revealed) &&
                    matches_description(step.state, process::describe(terms, transition.target)))
                    next.push_back({transition, from});
            }
        if (next.empty()) return std::nullopt;
        layers.push_back(std::move(next));
    }
    WholeRun result{initial, {}};
    std::size_t at = 0;
    for (std::size_t layer = layers.size(); layer-- > 1;) {
        result.steps.push_back(layers[layer][at].step);
        at = layers[layer][at].from;
    }
    std::ranges::reverse(result.steps);
    return result;
}

void translate(process::Behaviour& behaviour, const std::function<process::Event(process::Event)>& other) {
    const auto all = [&](std::vector<process::Event>& events) {
        for (process::Event& event : events)
            if (event != process::no_event) event = other(event);
    };
    all(behaviour.trace);
    all(behaviour.revealed);
    all(behaviour.offered);
    std::ranges::sort(behaviour.offered);
    for (process::Behaviour& part : behaviour.parts) translate(part, other);
}

}  // namespace robochart::cspm
