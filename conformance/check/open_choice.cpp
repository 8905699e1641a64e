// SPDX-License-Identifier: Apache-2.0
// Breadth-first search over the normalised specification: a node represents the states after a trace.
#include "conformance/check/open_choice.hpp"

#include <deque>
#include <map>

#include "checker/refine/verdict/normal_form.hpp"

namespace robochart::conformance {

namespace {

/// A write without its represented arguments.
using Rest = std::vector<std::string>;

Rest rest_of(process::Event event, const Alphabet& alphabet, const std::vector<std::vector<bool>>& represented) {
    const std::uint32_t output = alphabet.cycle_role(event).index;
    Rest rest{alphabet.output_constructor(output)};
    const std::vector<std::string> arguments = alphabet.written_arguments(event);
    for (std::size_t i = 0; i < arguments.size(); ++i)
        rest.push_back(represented[output].at(i) ? std::string() : arguments[i]);
    return rest;
}

std::optional<OpenChoice> find_choice_among(const process::EventSet& possible, const Alphabet& alphabet,
                                            const std::vector<std::vector<bool>>& represented) {
    std::map<Rest, process::Event> writes;
    for (const process::Event event : possible) {
        if (alphabet.cycle_role(event).kind != CycleRole::Kind::write) continue;
        const auto [first, fresh] = writes.emplace(rest_of(event, alphabet, represented), event);
        if (!fresh) return OpenChoice{alphabet.describe_event(first->second), alphabet.describe_event(event)};
    }
    return std::nullopt;
}

}  // namespace

std::optional<OpenChoice> open_choice(lts::TransitionSystem& normal_form, const Alphabet& alphabet,
                                      const std::vector<std::vector<bool>>& represented, const refine::Limits& limits) {
    refine::Budget budget(limits);
    refine::NormalForm nodes(normal_form, budget);
    std::deque<refine::NormalForm::Node> waiting{nodes.initial()};
    std::vector<bool> seen(nodes.size(), false);
    seen[waiting.front()] = true;
    while (!waiting.empty()) {
        const refine::NormalForm::Node node = waiting.front();
        waiting.pop_front();
        const process::EventSet possible = nodes.initials(node);
        if (auto found = find_choice_among(possible, alphabet, represented)) return found;
        for (const process::Event event : possible) {
            const auto next = nodes.node_after(node, event);
            if (!next) continue;
            if (*next >= seen.size()) seen.resize(nodes.size(), false);
            if (seen[*next]) continue;
            seen[*next] = true;
            waiting.push_back(*next);
            budget.states(nodes.size());
        }
    }
    return std::nullopt;
}

}  // namespace robochart::conformance
