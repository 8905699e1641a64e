// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/operators/exact.hpp"

#include "prism/markov/operators/operators.hpp"

namespace robochart::markov {
namespace {

ExactSolution exact_solution(Result<Rational> result) {
    ExactSolution solution{{}, std::move(result.strategy)};
    solution.values.reserve(result.values.size());
    for (State state = 0; state < result.values.size(); ++state) {
        solution.values.emplace_back();
        if (result.infinite.empty() || !result.infinite[state])
            solution.values.back() = std::move(result.values[state]);
    }
    return solution;
}

Precision precision_within(diagnostics::Budget* budget, bool strategy = false) {
    return {.budget = budget, .strategy = strategy};
}

}  // namespace

ExactSolution exact_until(const Model& model, const StateSet& left, const StateSet& right, Direction direction,
                          diagnostics::Budget* budget) {
    return exact_solution(
        UnboundedOperators<Rational>::until(model, left, right, direction, precision_within(budget, true)));
}

ExactSolution exact_reachability_reward(const Model& model, const Rewards& rewards, const StateSet& target,
                                        Direction direction, diagnostics::Budget* budget) {
    return exact_solution(UnboundedOperators<Rational>::reachability_reward(model, rewards, target, direction,
                                                                            precision_within(budget, true)));
}

ExactSolution exact_total_reward(const Model& model, const Rewards& rewards, Direction direction,
                                 diagnostics::Budget* budget) {
    return exact_solution(
        UnboundedOperators<Rational>::total_reward(model, rewards, direction, precision_within(budget, true)));
}

ExactSolution exact_next(const Model& model, const StateSet& set, Direction direction, diagnostics::Budget* budget) {
    return exact_solution(BoundedOperators<Rational>::next(model, set, direction, precision_within(budget)));
}

ExactSolution exact_bounded_until(const Model& model, const StateSet& left, const StateSet& right, std::uint64_t from,
                                  std::optional<std::uint64_t> to, Direction direction, diagnostics::Budget* budget) {
    return exact_solution(
        BoundedOperators<Rational>::until(model, left, right, from, to, direction, precision_within(budget)));
}

ExactSolution exact_cumulative_reward(const Model& model, const Rewards& rewards, std::uint64_t steps,
                                      Direction direction, diagnostics::Budget* budget) {
    return exact_solution(
        BoundedOperators<Rational>::cumulative_reward(model, rewards, steps, direction, precision_within(budget)));
}

ExactSolution exact_instantaneous_reward(const Model& model, const Rewards& rewards, std::uint64_t steps,
                                         Direction direction, diagnostics::Budget* budget) {
    return exact_solution(
        BoundedOperators<Rational>::instantaneous_reward(model, rewards, steps, direction, precision_within(budget)));
}

ExactSolution exact_long_run_probability(const Model& model, const StateSet& set, diagnostics::Budget* budget) {
    return exact_solution(LongRunOperators<Rational>::probability(model, set, precision_within(budget)));
}

ExactSolution exact_long_run_reward(const Model& model, const Rewards& rewards, diagnostics::Budget* budget) {
    return exact_solution(LongRunOperators<Rational>::reward(model, rewards, precision_within(budget)));
}

}  // namespace robochart::markov
