// SPDX-License-Identifier: Apache-2.0
// Evaluates the queries P, S, R, A and E. See evaluator.hpp.
#include <fmt/format.h>

#include <algorithm>

#include "prism/explore/question_numbers.hpp"
#include "prism/explore/rules.hpp"
#include "prism/markov/graph/qualitative.hpp"
#include "prism/markov/operators/bounded.hpp"
#include "prism/markov/operators/long_run.hpp"
#include "prism/markov/operators/unbounded.hpp"
#include "prism/session/evaluator.hpp"

namespace robochart::prism {
namespace {

markov::Direction opposite_direction(markov::Direction direction) {
    return direction == markov::Direction::minimum ? markov::Direction::maximum : markov::Direction::minimum;
}

markov::StateSet complement_set(markov::StateSet set) {
    set.flip();
    return set;
}

markov::StateSet intersect_sets(markov::StateSet a, const markov::StateSet& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] && b[i];
    return a;
}

}  // namespace

markov::Direction direction_of(const Query& query) {
    if (query.optimum == Optimum::minimum) return markov::Direction::minimum;
    if (query.optimum == Optimum::maximum) return markov::Direction::maximum;
    const bool lower = query.relation == Op::greater || query.relation == Op::greater_equal;
    return query.bound && lower ? markov::Direction::minimum : markov::Direction::maximum;
}

StateVector Evaluator::to_state_vector(const markov::Solution& solution) const {
    StateVector result;
    result.type = Type::real;
    result.numbers = solution.values;
    result.reason = solution.shortfall;
    return result;
}

StateVector Evaluator::to_state_vector(const markov::ExactSolution& solution) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    StateVector result;
    result.type = Type::real;
    for (const auto& value : solution.values)
        result.reals.push_back(value ? Real(*value) : Real(Enclosure{infinity, infinity}));
    return result;
}

StateVector Evaluator::to_state_vector(std::vector<Enclosure> numbers) const {
    StateVector result;
    result.type = Type::real;
    result.numbers = std::move(numbers);
    return result;
}

StateVector Evaluator::complement_values(StateVector values) const {
    for (Enclosure& number : values.numbers) number = markov::complement(number);
    for (Real& real : values.reals) real = Real(std::int64_t{1}) - real;
    return values;
}

StateVector Evaluator::evaluate_query(const Expr& expr) {
    const Query& query = *expr.query;
    const Direction direction = direction_of(query);
    if (!query.bound) return evaluate_question(expr, direction);
    const Real bound = bound_of(expr, code_);
    if (std::optional<StateVector> known = compare_qualitatively(expr, direction, bound, query.relation)) return *known;
    return compare_with_bound(expr, evaluate_question(expr, direction), bound, query.relation);
}

StateVector Evaluator::compare_with_bound(const Expr& expr, const StateVector& numbers, const Real& bound,
                                          Op relation) const {
    StateVector result;
    const Enclosure limit = bound.bounds();
    const bool lower = relation == Op::greater || relation == Op::greater_equal;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        // If the bound is far from the value, doubles decide without fractions.
        if (numbers.reals.empty() && (numbers.numbers[i].high < limit.low || numbers.numbers[i].low > limit.high)) {
            const bool above = numbers.numbers[i].low > limit.high;
            result.truths.push_back(above == lower ? Truth::yes : Truth::no);
            continue;
        }
        const Real value = numbers.number(i);
        result.truths.push_back(apply_relation(value, relation, bound));
        if (result.truths.back() == Truth::unknown && result.reason.empty())
            result.reason = fmt::format("{} is {}, and the bound is {}",
                                        expr.op == Op::reward ? "the expected reward" : "the probability", value.text(),
                                        bound.text());
    }
    return result;
}

/// Decides the bounds 0 and 1 of reachability on the graph.
std::optional<StateVector> Evaluator::compare_qualitatively(const Expr& expr, Direction direction, const Real& bound,
                                                            Op relation) {
    const Expr& body = *expr.parts[0];
    const bool zero = bound.compare(Real(std::int64_t{0})) == 0;
    const bool one = bound.compare(Real(std::int64_t{1})) == 0;
    if (expr.op != Op::probability || (!zero && !one) || body.steps) return std::nullopt;
    if (body.op != Op::until && body.op != Op::eventually && body.op != Op::globally) return std::nullopt;
    for (const ExprPtr& part : body.parts)
        if (is_path(*part)) return std::nullopt;
    // G a has probability 1 (0) exactly if F !a has probability 0 (1) in the other direction (minimum or maximum).
    const bool always = body.op == Op::globally;
    const StateSet right =
        always ? complement_set(states_satisfying(body.parts[0])) : states_satisfying(body.parts.back());
    const StateSet left = body.op == Op::until ? states_satisfying(body.parts[0]) : StateSet(right.size(), true);
    const bool least = (direction == Direction::minimum) != always;
    const bool ask_zero = zero != always;
    StateSet extreme;
    if (ask_zero)
        extreme = least ? prob0e(graph(), left, right) : prob0a(graph(), left, right);
    else
        extreme = least ? prob1a(graph(), left, right) : prob1e(graph(), left, right);
    // `extreme` contains the states in which the probability equals the bound.
    StateVector result;
    for (const bool equal : extreme) {
        bool holds = !equal && zero;
        if (relation == Op::less_equal) holds = equal || one;
        if (relation == Op::greater_equal) holds = equal || zero;
        if (relation == Op::less) holds = !equal && one;
        result.truths.push_back(holds ? Truth::yes : Truth::no);
    }
    return result;
}

StateVector Evaluator::evaluate_question(const Expr& expr, Direction direction) {
    if (expr.op == Op::probability) return path_probabilities(expr.parts[0], direction);
    if (expr.op == Op::steady) return long_run(expr);
    return evaluate_reward(expr, direction);
}

/// Returns the probability of a path formula.
StateVector Evaluator::path_probabilities(const ExprPtr& expr, Direction direction) {
    if (!is_path(*expr)) {
        const StateSet holds = states_satisfying(expr);
        std::vector<Enclosure> numbers;
        for (const bool inside : holds) numbers.push_back(inside ? Enclosure{1, 1} : Enclosure{0, 0});
        return to_state_vector(std::move(numbers));
    }
    const ExprPtr& operand = expr->parts[0];
    if (expr->op == Op::negation) return complement_values(path_probabilities(operand, opposite_direction(direction)));
    if (expr->op == Op::next) return next_probabilities(operand, direction);
    const bool all_steps = !expr->steps && !operand->steps;
    if (all_steps && (expr->op == Op::eventually || expr->op == Op::globally)) {
        if (operand->op == expr->op) return path_probabilities(operand, direction);
        if ((operand->op == Op::eventually || operand->op == Op::globally) && !is_path(*operand->parts[0]))
            return again_and_again(operand->parts[0], expr->op == Op::eventually, direction);
    }
    if (!is_temporal(expr->op) || std::ranges::any_of(expr->parts, [](const ExprPtr& p) { return is_path(*p); }))
        return nested_path(expr, direction);
    const Reachability reach = reachability(*expr);
    if (!reach.negated) return until_probabilities(reach.left, reach.right, expr->steps.get(), direction);
    return complement_values(
        until_probabilities(reach.left, reach.right, expr->steps.get(), opposite_direction(direction)));
}

Reachability Evaluator::reachability(const Expr& expr) {
    const bool inner = std::ranges::any_of(expr.parts, [](const ExprPtr& p) { return is_path(*p); });
    if (inner || !is_temporal(expr.op) || expr.op == Op::next)
        throw Undecided("this query needs F, G, U, W or R over states");
    StateSet b = states_satisfying(expr.parts.back());
    if (expr.op == Op::eventually) return {StateSet(b.size(), true), std::move(b), false};
    if (expr.op == Op::globally) return {StateSet(b.size(), true), complement_set(std::move(b)), true};
    StateSet a = states_satisfying(expr.parts[0]);
    if (expr.op == Op::until) return {std::move(a), std::move(b), false};
    StateSet not_a = complement_set(a);
    StateSet not_b = complement_set(std::move(b));
    if (expr.op == Op::release) return {std::move(not_a), std::move(not_b), true};
    return {intersect_sets(std::move(a), not_b), intersect_sets(std::move(not_a), not_b), true};
}

StateVector Evaluator::next_probabilities(const ExprPtr& operand, Direction direction) {
    if (!chain_.counted.empty()) throw Undecided("X is about one step, but this model does not count steps");
    if (is_path(*operand)) return one_step_before(path_probabilities(operand, direction), direction);
    const StateSet target = states_satisfying(operand);
    if (options_.exact) return to_state_vector(exact_next(chain_, target, direction, options_.budget));
    return to_state_vector(markov::next(chain_, target, direction, options_.budget));
}

/// Returns the expectation of a value after one step.
StateVector Evaluator::one_step_before(const StateVector& after, Direction direction) const {
    StateVector result;
    result.type = Type::real;
    result.reason = after.reason;
    for (markov::State state = 0; state < chain_.states(); ++state) {
        poll();
        std::optional<Real> best;
        for (std::size_t choice = chain_.first_choice[state]; choice < chain_.first_choice[state + 1]; ++choice) {
            Real sum;
            for (std::uint64_t i = chain_.first_branch[choice]; i < chain_.first_branch[choice + 1]; ++i) {
                const markov::Number number = chain_.numbers[chain_.number[i]];
                const Real factor =
                    options_.exact ? Real(chain_.exact[chain_.number[i]]) : Real(Enclosure{number.low, number.high});
                sum = sum + factor * after.number(chain_.target[i]);
            }
            best = best ? extreme_of(*best, sum, direction == Direction::minimum) : sum;
        }
        result.reals.push_back(*best);
    }
    return result;
}

StateVector Evaluator::until_probabilities(const StateSet& left, const StateSet& right, const StepBound* steps,
                                           Direction direction) {
    if (steps == nullptr) {
        if (options_.exact) return to_state_vector(exact_until(chain_, left, right, direction, options_.budget));
        return to_state_vector(markov::until(chain_, left, right, direction, precision()));
    }
    if (!chain_.counted.empty()) return timed_until(left, right, *steps, direction);
    const auto [from, to] = step_range(*steps, code_);
    if (options_.exact)
        return to_state_vector(exact_bounded_until(chain_, left, right, from, to, direction, options_.budget));
    return to_state_vector(bounded_until(chain_, left, right, from, to, direction, precision()));
}

/// Evaluates G F a (`always` false) and F G a. The greatest probability is the probability to reach end components that
/// satisfy the formula. The least is 1 minus the greatest probability of the negation.
StateVector Evaluator::again_and_again(const ExprPtr& operand, bool always, Direction direction) {
    const StateSet states = states_satisfying(operand);
    const StateSet everywhere(states.size(), true);
    if (direction == Direction::maximum) {
        const StateSet components =
            always ? maximal_components(states, everywhere) : maximal_components(everywhere, states);
        return until_probabilities(everywhere, components, nullptr, direction);
    }
    const StateSet not_so = complement_set(states);
    const StateSet components =
        always ? maximal_components(everywhere, not_so) : maximal_components(not_so, everywhere);
    return complement_values(until_probabilities(everywhere, components, nullptr, Direction::maximum));
}

/// Returns the states of those end components within one set that contain a state of the other set.
markov::StateSet Evaluator::maximal_components(const StateSet& within, const StateSet& touched) {
    StateSet result(within.size());
    const markov::SubModel part{within, std::vector<bool>(chain_.choices(), true)};
    for (const markov::EndComponent& component : end_components(graph(), part)) {
        const bool counts = std::ranges::any_of(component.states, [&](markov::State s) { return touched[s]; });
        for (const markov::State state : component.states)
            if (counts) result[state] = true;
    }
    return result;
}

StateVector Evaluator::long_run(const Expr& expr) {
    const StateSet states = states_satisfying(expr.parts[0]);
    if (options_.exact) return to_state_vector(exact_long_run_probability(chain_, states, options_.budget));
    return to_state_vector(long_run_probability(chain_, states, precision()));
}

const markov::Rewards& Evaluator::reward_structure(std::size_t structure) {
    const auto known = rewards_.find(structure);
    if (known != rewards_.end()) return known->second;
    return rewards_.emplace(structure, space_.rewards(structure, options_.exact)).first->second;
}

StateVector Evaluator::evaluate_reward(const Expr& expr, Direction direction) {
    const markov::Rewards& rewards = this->reward_structure(reward_index(*expr.query, space_.model(), code_));
    const Expr& body = *expr.parts[0];
    diagnostics::Budget* const budget = options_.budget;
    switch (body.op) {
        case Op::cumulative: {
            const std::uint64_t steps = step_number(body.parts[0], code_);
            if (!chain_.counted.empty()) return timed_reward(rewards, steps, direction);
            if (options_.exact)
                return to_state_vector(exact_cumulative_reward(chain_, rewards, steps, direction, budget));
            return to_state_vector(cumulative_reward(chain_, rewards, steps, direction, budget));
        }
        case Op::instantaneous: {
            const std::uint64_t steps = step_number(body.parts[0], code_);
            if (!chain_.counted.empty())
                throw Undecided("I= is about a number of steps, but this model does not count steps");
            if (options_.exact)
                return to_state_vector(exact_instantaneous_reward(chain_, rewards, steps, direction, budget));
            return to_state_vector(instantaneous_reward(chain_, rewards, steps, direction, budget));
        }
        case Op::total:
            if (options_.exact) return to_state_vector(exact_total_reward(chain_, rewards, direction, budget));
            return to_state_vector(total_reward(chain_, rewards, direction, precision()));
        case Op::long_run:
            if (options_.exact) return to_state_vector(exact_long_run_reward(chain_, rewards, budget));
            return to_state_vector(long_run_reward(chain_, rewards, precision()));
        default:
            break;
    }
    if (body.op != Op::eventually || body.steps || is_path(*body.parts[0]))
        throw Undecided("rewards of paths other than F of states are not decided");
    const StateSet target = states_satisfying(body.parts[0]);
    if (options_.exact) return to_state_vector(exact_reachability_reward(chain_, rewards, target, direction, budget));
    return to_state_vector(reachability_reward(chain_, rewards, target, direction, precision()));
}

/// Decides A [ path ] and E [ path ] of CTL.
markov::StateSet Evaluator::branching_states(const Expr& expr, bool always) {
    if (expr.steps) throw Undecided("A and E with bounds on the steps are not decided");
    if (expr.op == Op::negation && is_path(expr)) return complement_set(branching_states(*expr.parts[0], !always));
    for (const ExprPtr& part : expr.parts)
        if (is_path(*part)) throw Undecided("A and E of nested path formulas (CTL*) are not decided");
    if (!is_temporal(expr.op)) throw Undecided("A and E need X, F, G, U, W or R");
    const StateSet a = states_satisfying(expr.parts[0]);
    const markov::Graph& model = graph();
    if (expr.op == Op::next) return always ? always_next(model, a) : exists_next(model, a);
    if (expr.op == Op::eventually) return always ? always_finally(model, a) : exists_finally(model, a);
    if (expr.op == Op::globally) return always ? always_globally(model, a) : exists_globally(model, a);
    const StateSet b = states_satisfying(expr.parts[1]);
    if (expr.op == Op::until) return always ? always_until(model, a, b) : exists_until(model, a, b);
    const StateSet not_b = complement_set(b);
    const bool weak = expr.op == Op::weak_until;
    const StateSet left = weak ? intersect_sets(a, not_b) : complement_set(a);
    const StateSet right = weak ? intersect_sets(complement_set(a), not_b) : not_b;
    return complement_set(always ? exists_until(model, left, right) : always_until(model, left, right));
}

}  // namespace robochart::prism
