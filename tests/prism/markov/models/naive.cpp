// SPDX-License-Identifier: Apache-2.0
#include "tests/prism/markov/models/naive.hpp"

#include <algorithm>

namespace robochart::markov::naive {
namespace {

/// Solves A x = b for a regular A, by Gaussian elimination with row exchange.
std::vector<Rational> solved(Matrix a, std::vector<Rational> b) {
    const std::size_t size = b.size();
    for (std::size_t column = 0; column < size; ++column) {
        std::size_t pivot = column;
        while (a.at(pivot).at(column) == 0) ++pivot;
        std::swap(a[pivot], a[column]);
        std::swap(b[pivot], b[column]);
        for (std::size_t row = 0; row < size; ++row) {
            if (row == column || a[row][column] == 0) continue;
            const Rational share = a[row][column] / a[column][column];
            for (std::size_t at = column; at < size; ++at) a[row][at] -= share * a[column][at];
            b[row] -= share * b[column];
        }
    }
    for (std::size_t row = 0; row < size; ++row) b[row] /= a[row][row];
    return b;
}

/// Solves x = earned + P x for the unknown states. The other values are given.
std::vector<Rational> expectations(const Matrix& matrix, const std::vector<Rational>& earned, const StateSet& unknown,
                                   std::vector<Rational> values) {
    std::vector<State> states;
    for (State state = 0; state < matrix.size(); ++state)
        if (unknown[state]) states.push_back(state);
    Matrix a(states.size(), std::vector<Rational>(states.size(), 0));
    std::vector<Rational> b(states.size());
    for (std::size_t row = 0; row < states.size(); ++row) {
        b[row] = earned[states[row]];
        for (State to = 0; to < matrix.size(); ++to)
            if (!unknown[to]) b[row] += matrix[states[row]][to] * values[to];
        for (std::size_t column = 0; column < states.size(); ++column)
            a[row][column] = (row == column ? 1 : 0) - matrix[states[row]][states[column]];
    }
    const std::vector<Rational> found = solved(std::move(a), std::move(b));
    for (std::size_t row = 0; row < states.size(); ++row) values[states[row]] = found[row];
    return values;
}

Rational state_reward(const Description& description, State state) {
    return description.rewards.empty() ? Rational(0) : description.rewards[state];
}

std::vector<Rational> earned(const Description& description, const Scheduler& scheduler) {
    std::vector<Rational> result;
    for (State state = 0; state < description.states.size(); ++state)
        result.push_back(state_reward(description, state) + description.states[state][scheduler[state]].reward);
    return result;
}

Values all_finite(const std::vector<Rational>& values) {
    return {values.begin(), values.end()};
}

std::vector<Rational> reached_with(const Matrix& matrix, const StateSet& left, const StateSet& right) {
    Matrix on_the_way = matrix;
    for (State state = 0; state < matrix.size(); ++state)
        if (right[state] || !left[state]) std::ranges::fill(on_the_way[state], 0);
    const auto reaches = reachability(on_the_way);
    StateSet unknown(matrix.size());
    std::vector<Rational> values(matrix.size(), 0);
    for (State state = 0; state < matrix.size(); ++state) {
        bool possible = false;
        for (State to = 0; to < matrix.size(); ++to) possible = possible || (reaches[state][to] && right[to]);
        unknown[state] = possible && !right[state];
        if (right[state]) values[state] = 1;
    }
    return expectations(matrix, std::vector<Rational>(matrix.size(), 0), unknown, std::move(values));
}

StateSet all_states(const Description& description) {
    return StateSet(description.states.size(), true);
}

bool is_greater(const std::optional<Rational>& left, const std::optional<Rational>& right) {
    return right && (!left || *left > *right);
}

Rational expectation(const Choice& choice, const std::function<Rational(State)>& value) {
    Rational sum = 0;
    Rational weights = 0;
    for (const Branch& branch : choice.branches) {
        sum += branch.weight * value(branch.target);
        weights += branch.weight;
    }
    return sum / weights;
}

Rational best_choice(const Description& description, State state, Direction direction,
                     const std::function<Rational(const Choice&)>& worth) {
    std::vector<Rational> values;
    for (const Choice& choice : description.states[state]) values.push_back(worth(choice));
    return direction == Direction::maximum ? *std::ranges::max_element(values) : *std::ranges::min_element(values);
}

}  // namespace

std::size_t schedulers(const Description& description) {
    std::size_t count = 1;
    for (const auto& choices : description.states) count *= choices.size();
    return count;
}

Values best(const Description& description, Direction direction,
            const std::function<Values(const Scheduler&)>& values) {
    Values result;
    for (std::size_t number = 0; number < schedulers(description); ++number) {
        Scheduler scheduler;
        std::size_t rest = number;
        for (const auto& choices : description.states) {
            scheduler.push_back(rest % choices.size());
            rest /= choices.size();
        }
        const Values found = values(scheduler);
        if (number == 0) result = found;
        for (State state = 0; state < found.size(); ++state)
            if (direction == Direction::maximum ? is_greater(found[state], result[state])
                                                : is_greater(result[state], found[state]))
                result[state] = found[state];
    }
    return result;
}

Matrix matrix(const Description& description, const Scheduler& scheduler) {
    const std::size_t size = description.states.size();
    Matrix result(size, std::vector<Rational>(size, 0));
    for (State state = 0; state < size; ++state) {
        const Choice& choice = description.states[state][scheduler[state]];
        for (State to = 0; to < size; ++to)
            result[state][to] = expectation(choice, [&](State target) { return Rational(target == to ? 1 : 0); });
    }
    return result;
}

std::vector<std::vector<bool>> reachability(const Matrix& matrix) {
    const std::size_t size = matrix.size();
    std::vector<std::vector<bool>> reaches(size, std::vector<bool>(size, false));
    for (std::size_t from = 0; from < size; ++from)
        for (std::size_t to = 0; to < size; ++to) reaches[from][to] = from == to || matrix[from][to] != 0;
    for (std::size_t by = 0; by < size; ++by)
        for (std::size_t from = 0; from < size; ++from)
            for (std::size_t to = 0; to < size; ++to)
                if (reaches[from][by] && reaches[by][to]) reaches[from][to] = true;
    return reaches;
}

Values until(const Description& description, const Scheduler& scheduler) {
    return all_finite(reached_with(matrix(description, scheduler), description.left, description.right));
}

Values until(const Description& description, Direction direction) {
    return best(description, direction, [&](const Scheduler& scheduler) { return until(description, scheduler); });
}

Values reachability_reward(const Description& description, const Scheduler& scheduler) {
    const Matrix chain = matrix(description, scheduler);
    const std::vector<Rational> reached = reached_with(chain, all_states(description), description.right);
    StateSet unknown(chain.size());
    for (State state = 0; state < chain.size(); ++state)
        unknown[state] = reached[state] == 1 && !description.right[state];
    Values values = all_finite(
        expectations(chain, earned(description, scheduler), unknown, std::vector<Rational>(chain.size(), 0)));
    for (State state = 0; state < chain.size(); ++state)
        if (reached[state] != 1) values[state].reset();
    return values;
}

Values reachability_reward(const Description& description, Direction direction) {
    return best(description, direction,
                [&](const Scheduler& scheduler) { return reachability_reward(description, scheduler); });
}

Values total_reward(const Description& description, const Scheduler& scheduler) {
    const Matrix chain = matrix(description, scheduler);
    const std::vector<Rational> rewards = earned(description, scheduler);
    const auto reaches = reachability(chain);
    const std::size_t size = chain.size();
    StateSet recurrent(size, true);
    for (State state = 0; state < size; ++state)
        for (State to = 0; to < size; ++to)
            if (reaches[state][to] && !reaches[to][state]) recurrent[state] = false;
    StateSet transient = recurrent;
    transient.flip();
    Values values = all_finite(expectations(chain, rewards, transient, std::vector<Rational>(size, 0)));
    for (State state = 0; state < size; ++state)
        for (State to = 0; to < size; ++to)
            if (reaches[state][to] && recurrent[to] && rewards[to] != 0) values[state].reset();
    return values;
}

Values total_reward(const Description& description, Direction direction) {
    return best(description, direction,
                [&](const Scheduler& scheduler) { return total_reward(description, scheduler); });
}

Rational bounded_until(const Description& description, State state, std::uint64_t from, std::uint64_t to,
                       Direction direction) {
    if (from == 0 && description.right[state]) return 1;
    if (to == 0 || !description.left[state]) return 0;
    return best_choice(description, state, direction, [&](const Choice& choice) {
        return expectation(choice, [&](State next) {
            return bounded_until(description, next, from == 0 ? 0 : from - 1, to - 1, direction);
        });
    });
}

Rational cumulative_reward(const Description& description, State state, std::uint64_t steps, Direction direction) {
    if (steps == 0) return 0;
    const Rational later = best_choice(description, state, direction, [&](const Choice& choice) {
        return choice.reward + expectation(choice, [&](State next) {
                   return cumulative_reward(description, next, steps - 1, direction);
               });
    });
    return state_reward(description, state) + later;
}

Rational instantaneous_reward(const Description& description, State state, std::uint64_t steps, Direction direction) {
    if (steps == 0) return state_reward(description, state);
    return best_choice(description, state, direction, [&](const Choice& choice) {
        return expectation(choice,
                           [&](State next) { return instantaneous_reward(description, next, steps - 1, direction); });
    });
}

Values long_run_reward(const Description& description) {
    const Scheduler only(description.states.size(), 0);
    const Matrix chain = matrix(description, only);
    const std::vector<Rational> rewards = earned(description, only);
    const auto reaches = reachability(chain);
    const std::size_t size = chain.size();
    std::vector<Rational> averages(size, 0);
    StateSet transient(size, false);
    for (State state = 0; state < size; ++state) {
        std::vector<State> component;
        for (State to = 0; to < size; ++to) {
            if (reaches[state][to] && !reaches[to][state]) transient[state] = true;
            if (reaches[state][to]) component.push_back(to);
        }
        if (transient[state]) continue;
        // The stationary distribution solves the transpose of the equations with P. One of them is replaced by the sum
        // 1.
        Matrix a(component.size(), std::vector<Rational>(component.size()));
        std::vector<Rational> b(component.size(), 0);
        for (std::size_t row = 1; row < component.size(); ++row) {
            for (std::size_t column = 0; column < component.size(); ++column)
                a[row][column] = chain[component[column]][component[row]];
            a[row][row] -= 1;
        }
        a[0].assign(component.size(), 1);
        b[0] = 1;
        const std::vector<Rational> stationary = solved(std::move(a), std::move(b));
        for (std::size_t at = 0; at < component.size(); ++at)
            averages[state] += stationary[at] * rewards[component[at]];
    }
    return all_finite(expectations(chain, std::vector<Rational>(size, 0), transient, averages));
}

}  // namespace robochart::markov::naive
