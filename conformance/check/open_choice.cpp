// SPDX-License-Identifier: Apache-2.0
// Searches the normalised specification breadth-first. A node represents the states after a trace. Nodes are numbered
// in the order of their discovery.
#include "conformance/check/open_choice.hpp"

#include <fmt/format.h>

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
    nodes.initial();
    for (refine::NormalForm::Node node = 0; node < nodes.size(); ++node) {
        const process::EventSet possible = nodes.initials(node);
        if (auto found = find_choice_among(possible, alphabet, represented)) return found;
        for (const process::Event event : possible) static_cast<void>(nodes.node_after(node, event));
        budget.states(nodes.size());
    }
    return std::nullopt;
}

std::string reason_of(const OpenChoice& choice) {
    return fmt::format(
        "no difference for the few values explored, but they do not represent all values: after one trace the model "
        "may "
        "make either of {} and {}",
        choice.one, choice.other);
}

}  // namespace robochart::conformance
