// SPDX-License-Identifier: Apache-2.0
// Evaluates nested path formulas in the product of the model with an automaton of the formula. See evaluator.hpp.
#include <algorithm>

#include "prism/automata/product.hpp"
#include "prism/markov/operators/exact.hpp"
#include "prism/markov/operators/unbounded.hpp"
#include "prism/session/evaluator.hpp"

namespace robochart::prism {

/// Translates expressions to formulas; state formulas become atoms.
class Evaluator::PathReader {
public:
    PathReader(Evaluator& evaluator, automata::Formulas& formulas) : evaluator_(evaluator), formulas_(formulas) {}

    automata::FormulaId operator()(const ExprPtr& expr) {
        if (!is_path(*expr)) return formulas_.atom(atom(expr));
        const bool step = expr->op == Op::next || expr->steps;
        if (step && !evaluator_.chain_.counted.empty())
            throw Undecided("path formulas with steps inside of others are not decided where steps are not counted");
        const automata::FormulaId a = (*this)(expr->parts[0]);
        if (expr->op == Op::negation) return formulas_.make_negation(a);
        if (expr->op == Op::next) return formulas_.make_next(a);
        const automata::Steps steps = steps_of(*expr);
        if (expr->op == Op::eventually) return formulas_.make_until(automata::Formulas::yes, a, steps);
        if (expr->op == Op::globally) return formulas_.make_release(automata::Formulas::no, a, steps);
        const automata::FormulaId b = (*this)(expr->parts[1]);
        return binary(expr->op, a, b, steps);
    }

    [[nodiscard]] std::vector<automata::Letter> letters_of_states() const {
        std::vector<automata::Letter> result(evaluator_.chain_.states());
        for (std::size_t i = 0; i < atoms_.size(); ++i)
            for (std::size_t state = 0; state < result.size(); ++state)
                if (atoms_[i].second[state]) result[state] |= automata::Letter{1} << i;
        return result;
    }

private:
    automata::FormulaId binary(Op op, automata::FormulaId a, automata::FormulaId b, automata::Steps steps) {
        const automata::FormulaId not_a = formulas_.make_negation(a);
        switch (op) {
            case Op::conjunction:
                return formulas_.make_conjunction(a, b);
            case Op::disjunction:
                return formulas_.make_disjunction(a, b);
            case Op::implies:
                return formulas_.make_disjunction(not_a, b);
            case Op::iff:
                return formulas_.make_conjunction(formulas_.make_disjunction(not_a, b),
                                                  formulas_.make_disjunction(a, formulas_.make_negation(b)));
            case Op::until:
                return formulas_.make_until(a, b, steps);
            case Op::release:
                return formulas_.make_release(a, b, steps);
            default:
                // a W b is not (a & !b) U (!a & !b).
                return formulas_.make_release(formulas_.make_disjunction(not_a, b), formulas_.make_disjunction(a, b),
                                              steps);
        }
    }

    automata::Steps steps_of(const Expr& expr) {
        if (!expr.steps) return {};
        const StepRange range = step_range(*expr.steps, evaluator_.code_);
        return {range.from, range.to};
    }

    std::uint32_t atom(const ExprPtr& expr) {
        const auto known = std::ranges::find_if(atoms_, [&](const auto& atom) { return same_expr(atom.first, expr); });
        const auto number = static_cast<std::uint32_t>(known - atoms_.begin());
        if (known != atoms_.end()) return number;
        if (number == automata::most_atoms) throw Undecided("the formula contains more than 64 sets of states");
        atoms_.emplace_back(expr, evaluator_.states_satisfying(expr));
        return number;
    }

    Evaluator& evaluator_;
    automata::Formulas& formulas_;
    std::vector<std::pair<ExprPtr, StateSet>> atoms_;
};

StateVector Evaluator::nested_path(const ExprPtr& expr, Direction direction) {
    automata::Formulas formulas;
    PathReader reader(*this, formulas);
    const automata::FormulaId formula = reader(expr);
    // The least probability of a formula is 1 minus the greatest probability of its negation.
    const bool opposite = direction == Direction::minimum && !formulas[formula].co_safe;
    const Direction solved_direction = opposite ? Direction::maximum : direction;
    try {
        automata::Residues residues(formulas);
        const automata::Condition condition =
            automata::condition(formulas, opposite ? formulas.make_negation(formula) : formula);
        automata::Automaton automaton(residues, condition.parts);
        const automata::Product product =
            automata::product(chain_, reader.letters_of_states(), automaton, options_.budget);
        const auto is_part = [&](bool holds) {
            const std::vector<automata::Conjunction> only{automata::Conjunction{automata::Literal{0, holds}}};
            return condition.any == only && !condition.parts[0].always;
        };
        const bool co_safe = is_part(true);
        const bool safe = is_part(false);
        const StateSet goal = co_safe || safe
                                  ? automata::done_states(product, automaton, 0)
                                  : automata::winning_states(product, automaton, condition, options_.budget);
        Direction product_direction = safe ? Direction::minimum : Direction::maximum;
        if (co_safe) product_direction = solved_direction;
        StateVector found = in_product(product, goal, product_direction);
        if (safe) found = complement_values(std::move(found));
        return opposite ? complement_values(std::move(found)) : found;
    } catch (const automata::NotDecided& why) {
        throw Undecided(why.what());
    }
}

/// Returns the probability to reach a set of the product, for the states in which its paths begin.
StateVector Evaluator::in_product(const automata::Product& product, const StateSet& goal, Direction direction) const {
    const StateSet everywhere(product.model.states(), true);
    const StateVector all =
        options_.exact ? to_state_vector(exact_until(product.model, everywhere, goal, direction, options_.budget))
                       : to_state_vector(markov::until(product.model, everywhere, goal, direction, precision()));
    StateVector result;
    result.type = all.type;
    result.reason = all.reason;
    for (const markov::State state : product.begin) {
        if (options_.exact)
            result.reals.push_back(all.reals[state]);
        else
            result.numbers.push_back(all.numbers[state]);
    }
    return result;
}

}  // namespace robochart::prism
