// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/solve/optimum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "prism/markov/solve/arithmetic.hpp"
#include "prism/markov/solve/guess.hpp"
#include "prism/markov/solve/perturbation.hpp"
#include "prism/markov/solve/policy_iteration.hpp"

namespace robochart::markov {
namespace {

System<double> in_doubles(const System<Interval>& system, std::vector<double>& numbers) {
    for (const Interval& number : system.numbers) numbers.push_back(number.middle());
    System<double> result{system.first_choice, system.first_entry, system.unknown, system.number, {}, {}, numbers};
    for (const Interval& constant : system.constant) result.constant.push_back(constant.middle());
    for (const Interval& outside : system.outside) result.outside.push_back(outside.middle());
    return result;
}

class Enclosing {
public:
    Enclosing(const System<Interval>& system, const Optimum& goal, double most)
        : system_(system),
          goal_(goal),
          most_(most),
          iteration_(system, goal.direction),
          deterministic_(system.choices() == system.size()) {}

    SystemSolution<Interval> solve(std::string& shortfall) {
        if (!try_to_enclose())
            shortfall = fmt::format(
                "{} sweeps over a strongly connected component of {} states reached the relative width {:.1e}", sweeps_,
                system_.size(), width_);
        if (values_.empty()) values_.assign(system_.size(), Interval(0, most_));
        if (policy_.empty()) policy_ = iteration_.policy();
        return {std::move(values_), std::move(policy_)};
    }

private:
    static constexpr std::uint64_t first_visits = 64'000'000;  // visits of entries by sweeps
    static constexpr std::uint64_t first_sweeps = 64;
    static constexpr std::uint64_t last_visits = first_visits << 9U;  // used if sweeps make no progress
    static constexpr std::uint64_t visits_for_an_operation = 64;
    static constexpr std::uint64_t rounds_of_policies = 8;
    static constexpr std::uint64_t most_entries = 50'000'000;
    static constexpr std::size_t few_unknowns = 1'000;
    static constexpr std::uint64_t few_rational_operations = 5'000'000;  // most operations are computed modulo a prime
    static constexpr double sharp = 1e-13;

    /// Alternates elimination and sweeps, each time with eight times as much work. It is not known in advance which of
    /// them is faster, but the alternation takes little longer than the faster one alone.
    bool try_to_enclose() {
        if (!deterministic_ && sweep_up_to(first_sweeps))
            return true;  // eliminating a policy costs more than eliminating a chain
        for (std::uint64_t visits = first_visits;; visits *= 8) {
            if (eliminate_within(visits / visits_for_an_operation)) return true;
            if (visits == first_visits && bound_with_rationals()) return true;
            const std::uint64_t sweeps = sweeps_ + 1 + visits / (system_.unknown.size() + system_.choices());
            if (!stands_still_ && sweep_up_to(std::min(sweeps, goal_.precision.most_sweeps))) return true;
            if (sweeps_ >= goal_.precision.most_sweeps || (stands_still_ && visits >= last_visits)) return false;
        }
    }

    bool eliminate_within(std::uint64_t operations) {
        if (operations < system_.unknown.size()) return false;
        const EliminationLimit limit{deterministic_ ? operations : operations / rounds_of_policies, most_entries,
                                     goal_.precision.budget};
        return deterministic_ ? eliminate_rows(limit) : eliminate_policies(limit);
    }

    bool eliminate_rows(const EliminationLimit& limit) {
        Policy rows(system_.size());
        for (std::uint32_t unknown = 0; unknown < rows.size(); ++unknown) rows[unknown] = unknown;
        auto solved = eliminate(system_, rows, {system_.constant}, limit);
        if (!solved) return false;
        for (Interval& value : solved->front()) value.high = std::min(value.high, most_);
        return keep_if_narrower(std::move(solved->front()));
    }

    bool eliminate_policies(const EliminationLimit& limit) {
        std::vector<double> numbers;
        System<double> system = in_doubles(system_, numbers);
        const auto improves = [this](double value, double offered) {
            return is_better(offered, value, goal_.direction) && std::abs(offered - value) > 1e-14 * std::abs(value);
        };
        // After some sweeps, the best choices according to the guesses are nearly optimal. For a minimum, these choices
        // might never leave the component.
        const bool guessed = sweeps_ > 0 && goal_.direction == Direction::maximum;
        auto found = iterate_policies<double>(
            system, guessed ? iteration_.policy() : leaving_policy(system_), limit, improves,
            [](std::uint32_t) { return true; }, most_rounds);
        if (!found) return false;
        leaving_ = found->policy;
        if (!guess(system, *found, limit)) return false;
        const bool reached = prove_guesses();
        if (reached) policy_ = std::move(found->policy);
        return reached;
    }

    bool bound_with_rationals() {
        if (deterministic_ || system_.size() > few_unknowns) return false;
        auto found = rational_bounds(system_, leaving_ ? *leaving_ : leaving_policy(system_), goal_.direction, most_,
                                     {few_rational_operations, most_entries, goal_.precision.budget});
        const bool reached = found && keep_if_narrower(std::move(found->values));
        if (reached) policy_ = std::move(found->policy);
        return reached;
    }

    /// Computes the values of the policy for both bounds of the constants. Computes weights over all choices that are
    /// equally good.
    bool guess(System<double>& system, const SystemSolution<double>& found, const EliminationLimit& limit) {
        std::vector<double> low(system.size());
        std::vector<double> high(system.size());
        for (std::uint32_t unknown = 0; unknown < system.size(); ++unknown) {
            low[unknown] = system_.constant[found.policy[unknown]].low();
            high[unknown] = system_.constant[found.policy[unknown]].high;
        }
        auto bounds = eliminate(system, found.policy, {std::move(low), std::move(high)}, limit);
        if (!bounds) return false;
        std::vector<bool> tie(system.choices());
        for (std::uint32_t unknown = 0; unknown < system.size(); ++unknown)
            for (std::uint32_t choice = system.first_choice[unknown]; choice < system.first_choice[unknown + 1];
                 ++choice)
                tie[choice] = std::abs(value_of_choice(system, unknown, choice, found.values) -
                                       found.values[unknown]) <= 1e-9 * std::abs(found.values[unknown]);
        for (std::uint32_t unknown = 0; unknown < system.size(); ++unknown)
            for (std::uint32_t choice = system.first_choice[unknown]; choice < system.first_choice[unknown + 1];
                 ++choice)
                system.constant[choice] = found.values[unknown];
        const auto weights = iterate_policies<double>(
            system, found.policy, limit, [](double value, double offered) { return offered > value * (1 + 1e-6); },
            [&](std::uint32_t choice) { return tie[choice]; }, most_rounds);
        if (!weights) return false;
        for (std::uint32_t unknown = 0; unknown < system.size(); ++unknown)
            iteration_.guesses()[unknown] = {(*bounds)[0][unknown], (*bounds)[1][unknown], weights->values[unknown]};
        return true;
    }

    /// Runs sweeps. Tries a proof at growing intervals, and when the sweeps make no progress.
    bool sweep_up_to(std::uint64_t most) {
        std::uint64_t next_proof = sweeps_ + 8;
        std::uint64_t failures = 0;
        while (sweeps_ < most) {
            if (goal_.precision.budget != nullptr) goal_.precision.budget->check();
            const double change = iteration_.sweep();
            ++sweeps_;
            const bool still = change == 0;
            if (!still && (sweeps_ < next_proof || change > goal_.precision.relative)) continue;
            if (prove_guesses()) {
                improve_bounds();
                return true;
            }
            stands_still_ = still && failures > 8;  // further sweeps do not change the values
            if (stands_still_) return false;
            if (++failures % 4 == 0) iteration_.set_tie(tie_ = std::max(tie_ / 100, 1e-13));
            next_proof = sweeps_ + 1 + sweeps_ / 8;
        }
        return false;
    }

    /// Continues with half as many sweeps again, which improves the bounds.
    void improve_bounds() {
        for (std::uint64_t more = sweeps_ / 2 + 4; more > 0 && width_ > sharp; --more) {
            if (goal_.precision.budget != nullptr) goal_.precision.budget->check();
            iteration_.sweep();
            ++sweeps_;
        }
        prove_guesses();
    }

    bool prove_guesses() {
        auto values = prove(system_, goal_.direction, iteration_.guesses(), most_);
        return values && keep_if_narrower(std::move(*values));
    }

    /// Stores the values if they are narrower than before. Returns whether they are narrow enough.
    bool keep_if_narrower(std::vector<Interval> values) {
        const double width = relative_width(values);
        if (width < width_ || values_.empty()) {
            width_ = width;
            values_ = std::move(values);
        }
        return width_ <= goal_.precision.relative;
    }

    const System<Interval>& system_;
    const Optimum& goal_;
    const double most_;
    GuessIteration iteration_;
    const bool deterministic_;
    std::vector<Interval> values_;
    Policy policy_;
    std::optional<Policy> leaving_;  // the best policy found so far that leaves the component
    double width_ = infinity;
    double tie_ = 1e-6;
    std::uint64_t sweeps_ = 0;
    bool stands_still_ = false;
    static constexpr std::uint64_t most_rounds = 100;
};

}  // namespace

SystemSolution<Rational> optimum(const System<Rational>& system, const Optimum& goal) {
    const auto improves = [&](const Rational& value, const Rational& offered) {
        return is_better(offered, value, goal.direction);
    };
    const EliminationLimit limit{.budget = goal.precision.budget};
    auto found = iterate_policies<Rational>(
        system, leaving_policy(system), limit, improves, [](std::uint32_t) { return true; },
        std::numeric_limits<std::uint64_t>::max());
    return std::move(found.value());
}

SystemSolution<Interval> optimum(const System<Interval>& system, const Optimum& goal, double most,
                                 std::string& shortfall) {
    return Enclosing(system, goal, most).solve(shortfall);
}

}  // namespace robochart::markov
