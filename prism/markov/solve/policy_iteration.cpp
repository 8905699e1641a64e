// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/solve/policy_iteration.hpp"

#include <algorithm>

#include "prism/markov/solve/arithmetic.hpp"
#include "prism/markov/solve/lifting.hpp"

namespace robochart::markov {
namespace {

template <class Value>
std::vector<Value> constants(const System<Value>& system, const Policy& policy) {
    std::vector<Value> side;
    side.reserve(policy.size());
    for (const std::uint32_t choice : policy) side.push_back(system.constant[choice]);
    return side;
}

template <class Value>
std::optional<std::vector<Value>> policy_values(const System<Value>& system, const Policy& policy,
                                                const EliminationLimit& limit) {
    auto solved = eliminate(system, policy, {constants(system, policy)}, limit);
    if (!solved) return std::nullopt;
    return std::move(solved->front());
}

/// Returns the exact values of the policy. With few unknowns, fractions stay short and an elimination is faster than
/// lifting.
std::optional<std::vector<Rational>> policy_values(const System<Rational>& system, const Policy& policy,
                                                   const EliminationLimit& limit) {
    constexpr std::uint64_t few_operations = 1'000;
    const EliminationLimit few{std::min(limit.operations, few_operations), limit.entries, limit.budget};
    if (auto solved = eliminate(system, policy, {constants(system, policy)}, few)) return std::move(solved->front());
    return lift_solution(system, policy, limit);
}

}  // namespace

template <class Value>
std::optional<SystemSolution<Value>> iterate_policies(const System<Value>& system, Policy policy,
                                                      const EliminationLimit& limit,
                                                      const std::function<bool(const Value&, const Value&)>& improves,
                                                      const std::function<bool(std::uint32_t)>& admitted,
                                                      std::uint64_t most_rounds) {
    for (std::uint64_t round = 1;; ++round) {
        auto solved = policy_values(system, policy, limit);
        if (!solved) return std::nullopt;
        std::vector<Value>& values = *solved;
        bool changed = false;
        for (std::uint32_t unknown = 0; unknown < system.size(); ++unknown) {
            Value best = values[unknown];
            for (std::uint32_t choice = system.first_choice[unknown]; choice < system.first_choice[unknown + 1];
                 ++choice) {
                if (choice == policy[unknown] || !admitted(choice)) continue;
                Value offered = value_of_choice(system, unknown, choice, values);
                if (!improves(best, offered)) continue;
                best = std::move(offered);
                policy[unknown] = choice;
                changed = true;
            }
        }
        if (!changed || round == most_rounds) return SystemSolution<Value>{std::move(values), std::move(policy)};
    }
}

template std::optional<SystemSolution<double>> iterate_policies(
    const System<double>&, Policy, const EliminationLimit&, const std::function<bool(const double&, const double&)>&,
    const std::function<bool(std::uint32_t)>&, std::uint64_t);
template std::optional<SystemSolution<Rational>> iterate_policies(
    const System<Rational>&, Policy, const EliminationLimit&,
    const std::function<bool(const Rational&, const Rational&)>&, const std::function<bool(std::uint32_t)>&,
    std::uint64_t);

}  // namespace robochart::markov
