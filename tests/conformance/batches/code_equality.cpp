// SPDX-License-Identifier: Apache-2.0
#include "tests/conformance/batches/code_equality.hpp"

#include <algorithm>

#include "checker/lts/bisimulation.hpp"
#include "conformance/code/code_graph.hpp"

namespace robochart::conformance {

namespace {

void append_graph(lts::Graph& whole, const lts::Graph& part) {
    const auto first = static_cast<lts::StateIndex>(whole.size());
    for (lts::StateIndex state = 0; state < part.size(); ++state) {
        for (const lts::Edge& edge : part.edges(state)) whole.add_edge({edge.event, first + edge.target});
        whole.finish_state();
    }
}

/// Joins both graphs to one in which both are reachable. The first state of `one` gets the number 1. The first state of
/// `other` gets 1 + the number of states of `one`.
bool are_bisimilar(const lts::Graph& one, const lts::Graph& other) {
    const auto second = static_cast<lts::StateIndex>(1 + one.size());
    lts::Graph both;
    both.add_edge({process::tau, 1});
    both.add_edge({process::tau, second});
    both.finish_state();
    append_graph(both, one);
    append_graph(both, other);
    const lts::Quotient quotient = lts::minimise(both, lts::Equivalence::strong);
    return quotient.state_of[1] == quotient.state_of[second];
}

/// Checks whether `implementation` refines `specification`. Returns a counterexample, or no value if it does.
std::optional<refine::Counterexample> find_distinguishing_run(const lts::Graph& implementation,
                                                              const lts::Graph& specification, const Alphabet& alphabet,
                                                              const refine::Limits& limits) {
    lts::GraphSystem from(specification, alphabet.events());
    lts::GraphSystem to(implementation, alphabet.events());
    return refine::refines(from, to, refine::Model::failures_divergences, limits).counterexample;
}

/// Describes the raised inputs, the writes and the ends of cycles along the run.
void describe_distinguishing_run(CodeEquality& result, const refine::Counterexample& found, const Alphabet& alphabet,
                                 std::uint32_t cycle_length) {
    std::size_t tocks = 0;
    for (const refine::Step& step : found.steps) {
        const CycleRole role = alphabet.cycle_role(step.event);
        tocks += role.kind == CycleRole::Kind::tock ? 1U : 0U;
        if (step.event == process::tau || (role.kind == CycleRole::Kind::read && role.reading == 0)) continue;
        result.difference += (result.difference.empty() ? "" : ", ") + alphabet.describe_event(step.event);
    }
    if (found.kind == refine::ViolationKind::divergence) result.difference += ", without end";
    for (const process::Event event : found.offered) result.difference += "; then " + alphabet.describe_event(event);
    result.cycles = 1 + tocks / std::max(1U, cycle_length);
}

}  // namespace

CodeEquality compare_code(const rc_interface& one, const rc_interface& other, const Alphabet& alphabet,
                          std::uint32_t cycle_length, const refine::Limits& limits) {
    CodeSystem one_system(one, alphabet, cycle_length);
    CodeSystem other_system(other, alphabet, cycle_length);
    const lts::Graph first = explore_code(one_system, limits);
    const lts::Graph second = explore_code(other_system, limits);
    CodeEquality result;
    result.states = first.size() + second.size();
    result.same = are_bisimilar(first, second);
    if (result.same) return result;
    auto found = find_distinguishing_run(second, first, alphabet, limits);
    if (!found) found = find_distinguishing_run(first, second, alphabet, limits);
    if (found) describe_distinguishing_run(result, *found, alphabet, cycle_length);
    return result;
}

}  // namespace robochart::conformance
