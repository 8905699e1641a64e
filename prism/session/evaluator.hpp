// SPDX-License-Identifier: Apache-2.0
// Computes the values of property expressions in every state, from the innermost operators outwards. See "Meaning" in
// docs/probability.md.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

#include "prism/explore/question_numbers.hpp"
#include "prism/explore/state_space.hpp"
#include "prism/markov/graph/graph.hpp"
#include "prism/markov/operators/exact.hpp"
#include "prism/markov/solve/solution.hpp"
#include "prism/session/result.hpp"
#include "prism/session/state_values.hpp"

namespace robochart::prism {

namespace automata {
struct Product;
}

/// Thrown if a query cannot be decided; the message contains the reason.
class Undecided : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A path formula as `left U right`, or as the negation of such a formula. The step bound is that of the path formula.
struct Reachability {
    markov::StateSet left, right;
    bool negated = false;
};

/// Returns the direction of a query P or R: a lower bound needs the minimum, an upper bound the maximum.
[[nodiscard]] markov::Direction direction_of(const Query& query);

struct EvaluatorOptions {
    double relative = 1e-6;  ///< width of enclosures
    bool exact = false;
    diagnostics::Budget* budget = nullptr;
};

/// Labels in the expressions must have been replaced, except for "deadlock" and "init". Throws EvaluationError,
/// Undecided, markov::Unsupported, LimitReached.
class Evaluator {
public:
    Evaluator(const StateSpace& space, Code& code, const EvaluatorOptions& options);

    /// Evaluates an expression in every state. If it has no value in a state, such as 0/0, this is an error only if the
    /// missing value is used.
    [[nodiscard]] StateVector evaluate(const ExprPtr& expr);
    /// Returns the result for the states of the filter if there is one, otherwise for the initial states.
    [[nodiscard]] Result answer_question(const ExprPtr& expr);
    /// Returns the states in which the expression holds. Throws Undecided if this is unknown in some state.
    [[nodiscard]] markov::StateSet states_satisfying(const ExprPtr& expr);
    /// Reduces F, G, U, W or R of state formulas. G a is not F !a; a W b is not (a & !b) U (!a & !b); a R b is not !a U
    /// !b.
    [[nodiscard]] Reachability reachability(const Expr& expr);

private:
    using Direction = markov::Direction;
    using StateSet = markov::StateSet;

    // expressions
    StateVector state_expression(const ExprPtr& expr);
    StateVector state_by_state(Code::Root root);
    StateVector evaluate_logical(const Expr& expr);
    StateVector evaluate_comparison(const Expr& expr);
    StateVector evaluate_conditional(const Expr& expr);
    StateVector evaluate_arithmetic(const Expr& expr);
    StateVector all_states(const Value& value) const;

    // queries
    StateVector evaluate_query(const Expr& expr);
    StateVector evaluate_question(const Expr& expr, Direction direction);
    StateVector compare_with_bound(const Expr& expr, const StateVector& numbers, const Real& bound, Op relation) const;
    std::optional<StateVector> compare_qualitatively(const Expr& expr, Direction direction, const Real& bound,
                                                     Op relation);
    StateVector path_probabilities(const ExprPtr& expr, Direction direction);
    class PathReader;
    StateVector nested_path(const ExprPtr& expr, Direction direction);
    [[nodiscard]] StateVector in_product(const automata::Product& product, const StateSet& goal,
                                         Direction direction) const;
    StateVector next_probabilities(const ExprPtr& operand, Direction direction);
    StateVector one_step_before(const StateVector& after, Direction direction) const;
    StateVector until_probabilities(const StateSet& left, const StateSet& right, const StepBound* steps,
                                    Direction direction);
    StateVector timed_until(const StateSet& left, const StateSet& right, const StepBound& steps, Direction direction);
    StateVector layered_until(const StateSet& left, const StateSet& right, const StepRange& range, Direction direction);
    StateVector long_until(const StateSet& left, const StateSet& right, Direction direction);
    StateVector timed_reward(const markov::Rewards& rewards, std::uint64_t units, Direction direction);
    StateVector again_and_again(const ExprPtr& operand, bool always, Direction direction);
    StateSet maximal_components(const StateSet& within, const StateSet& touched);
    StateVector evaluate_reward(const Expr& expr, Direction direction);
    const markov::Rewards& reward_structure(std::size_t structure);
    StateVector long_run(const Expr& expr);
    StateSet branching_states(const Expr& expr, bool always);
    StateVector evaluate_filter(const Expr& expr);
    Result filter_result(const Expr& expr);

    [[nodiscard]] StateVector complement_values(StateVector values) const;
    [[nodiscard]] StateVector to_state_vector(const markov::Solution& solution) const;
    [[nodiscard]] StateVector to_state_vector(const markov::ExactSolution& solution) const;
    [[nodiscard]] StateVector to_state_vector(std::vector<Enclosure> numbers) const;
    [[nodiscard]] markov::Precision precision() const {
        return {options_.relative, most_sweeps, options_.budget, false};
    }
    [[nodiscard]] bool contains_query(const ExprPtr& expr);
    [[nodiscard]] const markov::Graph& graph();
    Result summarise_values(const StateVector& values, const StateSet& states) const;
    Result extreme_states(const Expr& expr);
    [[noreturn]] void throw_missing_value(const NoValue& missing) const;
    [[nodiscard]] StateSet initial_state_set() const;
    void poll() const {
        if (options_.budget != nullptr) options_.budget->poll();
    }

    static constexpr std::uint64_t most_sweeps = 1'000'000;
    const StateSpace& space_;
    Code& code_;
    EvaluatorOptions options_;
    const markov::Model& chain_;
    std::optional<markov::Graph> graph_;
    std::map<std::size_t, markov::Rewards> rewards_;
    std::unordered_map<const Expr*, bool> asks_;
};

}  // namespace robochart::prism
