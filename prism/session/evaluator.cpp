// SPDX-License-Identifier: Apache-2.0
// Evaluates expressions pointwise over the states. See evaluator.hpp.
#include "prism/session/evaluator.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "prism/explore/rules.hpp"

namespace robochart::prism {

Evaluator::Evaluator(const StateSpace& space, Code& code, const EvaluatorOptions& options)
    : space_(space), code_(code), options_(options), chain_(space.chain()) {}

const markov::Graph& Evaluator::graph() {
    if (!graph_) graph_.emplace(chain_);
    return *graph_;
}

markov::StateSet Evaluator::initial_state_set() const {
    StateSet result(chain_.states());
    for (const markov::State state : chain_.initial) result[state] = true;
    return result;
}

/// Returns whether the expression contains a query, or a label that no formula of the model defines.
bool Evaluator::contains_query(const ExprPtr& expr) {
    if (const auto known = asks_.find(expr.get()); known != asks_.end()) return known->second;
    bool result =
        expr->op == Op::label || expr->op == Op::filter || (expr->op >= Op::probability && expr->op <= Op::exists_path);
    for (const ExprPtr& part : expr->parts) result = contains_query(part) || result;
    asks_.emplace(expr.get(), result);
    return result;
}

StateVector Evaluator::evaluate(const ExprPtr& expr) {
    if (!contains_query(expr)) return state_expression(expr);
    switch (expr->op) {
        case Op::label:
            return StateVector::from_set(expr->text == "deadlock" ? space_.deadlocks() : initial_state_set());
        case Op::conditional:
            return evaluate_conditional(*expr);
        case Op::implies:
        case Op::iff:
        case Op::disjunction:
        case Op::conjunction:
        case Op::negation:
            return evaluate_logical(*expr);
        case Op::equal:
        case Op::unequal:
        case Op::less:
        case Op::less_equal:
        case Op::greater:
        case Op::greater_equal:
            return evaluate_comparison(*expr);
        case Op::probability:
        case Op::steady:
        case Op::reward:
            return evaluate_query(*expr);
        case Op::forall_paths:
            return StateVector::from_set(branching_states(*expr->parts[0], true));
        case Op::exists_path:
            return StateVector::from_set(branching_states(*expr->parts[0], false));
        case Op::filter:
            return evaluate_filter(*expr);
        // clang-format off
        case Op::boolean: case Op::integer: case Op::real: case Op::name: case Op::add: case Op::subtract:
        case Op::multiply: case Op::divide: case Op::power: case Op::minus: case Op::call: case Op::next:
        case Op::eventually: case Op::globally: case Op::until: case Op::weak_until: case Op::release:
        case Op::cumulative: case Op::total: case Op::instantaneous: case Op::long_run:
            break;
    }
    // clang-format on
    return evaluate_arithmetic(*expr);
}

StateVector Evaluator::state_expression(const ExprPtr& expr) {
    const Code::Root root = code_.compile(expr);
    if (code_.is_constant(root)) return all_states(code_.value(root, nullptr));
    if (code_.type(root) != Type::boolean) return state_by_state(root);
    try {
        return StateVector::from_set(space_.states_satisfying(code_, root));
    } catch (const EvaluationError&) {
        return state_by_state(root);
    }
}

StateVector Evaluator::state_by_state(Code::Root root) {
    StateVector result;
    result.type = code_.type(root);
    std::vector<std::int32_t> values(space_.layout().fields().size());
    for (markov::State state = 0; state < chain_.states(); ++state) {
        poll();
        space_.unpack(state, values.data());
        try {
            if (result.type == Type::boolean)
                result.truths.push_back(code_.holds(root, values.data()) ? Truth::yes : Truth::no);
            else
                result.reals.push_back(code_.real(root, values.data()));
        } catch (const EvaluationError& error) {
            result.add_undefined(std::make_shared<const Undefined>(Undefined{error, ""}));
        }
    }
    return result;
}

/// Throws the error of a value that is missing in a state but needed.
void Evaluator::throw_missing_value(const NoValue& missing) const {
    const std::string state = space_.state_text(static_cast<markov::State>(missing.state()));
    if (!missing.undefined_reason().open.empty())
        throw Undecided(fmt::format("in the state {}: {}", state, missing.undefined_reason().open));
    EvaluationError error = missing.undefined_reason().error;
    error.state = state;
    throw error;
}

StateVector Evaluator::all_states(const Value& value) const {
    StateVector result;
    result.type = value.type;
    if (value.type == Type::boolean)
        result.truths.assign(chain_.states(), value.integer != 0 ? Truth::yes : Truth::no);
    else
        result.reals.assign(chain_.states(), value.number());
    return result;
}

markov::StateSet Evaluator::states_satisfying(const ExprPtr& expr) {
    const StateVector values = evaluate(expr);
    StateSet result(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        values.require_value(i);
        if (values.truths[i] == Truth::unknown)
            throw Undecided(
                fmt::format("in the state {}: {}", space_.state_text(static_cast<markov::State>(i)), values.reason));
        result[i] = values.truths[i] == Truth::yes;
    }
    return result;
}

StateVector Evaluator::evaluate_logical(const Expr& expr) {
    StateVector left = evaluate(expr.parts[0]);
    if (expr.op == Op::negation) {
        for (Truth& truth : left.truths) truth = negation_of(truth);
        return left;
    }
    const StateVector right = evaluate(expr.parts[1]);
    StateVector result;
    result.reason = left.reason.empty() ? right.reason : left.reason;
    for (std::size_t i = 0; i < left.size(); ++i) {
        const Truth a = left.truths[i];
        const Truth b = right.truths[i];
        Truth truth = conjunction_of(a, b);
        if (expr.op == Op::disjunction) truth = negation_of(conjunction_of(negation_of(a), negation_of(b)));
        if (expr.op == Op::implies) truth = negation_of(conjunction_of(a, negation_of(b)));
        if (expr.op == Op::iff)
            truth = conjunction_of(negation_of(conjunction_of(a, negation_of(b))),
                                   negation_of(conjunction_of(b, negation_of(a))));
        if (truth != Truth::undefined) {
            result.truths.push_back(truth);
            continue;
        }
        const UndefinedPtr why = left.undefined_in(i);
        result.add_undefined(why ? why : right.undefined_in(i));
    }
    return result;
}

StateVector Evaluator::evaluate_comparison(const Expr& expr) {
    const StateVector left = evaluate(expr.parts[0]);
    const StateVector right = evaluate(expr.parts[1]);
    StateVector result;
    for (std::size_t i = 0; i < left.size(); ++i) {
        UndefinedPtr why = left.undefined_in(i);
        if (!why) why = right.undefined_in(i);
        if (why) {
            result.add_undefined(std::move(why));
            continue;
        }
        if (left.type == Type::boolean) {
            const bool known = left.truths[i] != Truth::unknown && right.truths[i] != Truth::unknown;
            const bool same = (left.truths[i] == right.truths[i]) == (expr.op == Op::equal);
            Truth truth = Truth::unknown;
            if (known) truth = same ? Truth::yes : Truth::no;
            result.truths.push_back(truth);
            if (!known && result.reason.empty()) result.reason = left.reason.empty() ? right.reason : left.reason;
            continue;
        }
        const Real a = left.number(i);
        const Real b = right.number(i);
        result.truths.push_back(apply_relation(a, expr.op, b));
        if (result.truths.back() == Truth::unknown && result.reason.empty())
            result.reason = fmt::format("{} and {} are too close to be compared", a.text(), b.text());
    }
    return result;
}

StateVector Evaluator::evaluate_conditional(const Expr& expr) {
    const StateVector condition = evaluate(expr.parts[0]);
    const StateVector yes = evaluate(expr.parts[1]);
    const StateVector no = evaluate(expr.parts[2]);
    StateVector result;
    result.type = yes.type == no.type ? yes.type : Type::real;
    result.reason = yes.reason.empty() ? no.reason : yes.reason;
    for (std::size_t i = 0; i < condition.size(); ++i) {
        const StateVector& taken = condition.truths[i] == Truth::yes ? yes : no;
        if (condition.truths[i] == Truth::unknown)
            throw Undecided(
                fmt::format("in the state {}: {}", space_.state_text(static_cast<markov::State>(i)), condition.reason));
        UndefinedPtr why = condition.undefined_in(i);
        if (!why) why = taken.undefined_in(i);
        if (why)
            result.add_undefined(std::move(why));
        else if (result.type == Type::boolean)
            result.truths.push_back(taken.truths[i]);
        else
            result.reals.push_back(taken.number(i));
    }
    return result;
}

namespace {

Real extreme_argument(const std::vector<StateVector>& arguments, std::size_t state, bool least) {
    Real best = arguments[0].number(state);
    for (std::size_t i = 1; i < arguments.size(); ++i) best = extreme_of(best, arguments[i].number(state), least);
    return best;
}

Real round_to_integer(const Real& value, const std::string& function) {
    Real operand = value;
    if (function == "round") operand = operand + Real(Rational(1, 2));
    if (function == "ceil") operand = Real(std::int64_t{0}) - operand;
    const std::optional<Rational> result = floor_of(operand);
    if (!result) throw Unclear(fmt::format("{} of a number {} is not known", function, value.text()));
    return function == "ceil" ? Rational(-*result) : *result;
}

Real apply_operator(const Expr& expr, const std::vector<StateVector>& arguments, std::size_t state) {
    const Real a = arguments[0].number(state);
    const auto b = [&] { return arguments[1].number(state); };
    switch (expr.op) {
        case Op::add:
            return a + b();
        case Op::subtract:
            return a - b();
        case Op::multiply:
            return a * b();
        case Op::divide:
            return a / b();
        case Op::power:
            return power(a, b());
        case Op::minus:
            return Real(std::int64_t{0}) - a;
        default:
            break;
    }
    if (expr.text == "min" || expr.text == "max") return extreme_argument(arguments, state, expr.text == "min");
    if (expr.text == "pow") return power(a, b());
    if (expr.text == "log") return logarithm(a, b());
    if (expr.text != "mod") return round_to_integer(a, expr.text);
    const Real divisor = b();
    const std::optional<int> sign = divisor.compare(Real(std::int64_t{0}));
    if (!sign) throw Unclear("it is unknown whether the divisor of mod is above 0");
    if (*sign != 1) throw std::domain_error("mod: the divisor must be above 0");
    return a - divisor * round_to_integer(a / divisor, "floor");
}

}  // namespace

StateVector Evaluator::evaluate_arithmetic(const Expr& expr) {
    std::vector<StateVector> arguments;
    bool real = expr.op == Op::divide || expr.text == "log";
    StateVector result;
    for (const ExprPtr& part : expr.parts) {
        arguments.push_back(evaluate(part));
        real = real || arguments.back().type == Type::real;
        if (result.reason.empty()) result.reason = arguments.back().reason;
    }
    const bool rounds = expr.text == "floor" || expr.text == "ceil" || expr.text == "round";
    result.type = real && !rounds ? Type::real : Type::integer;
    for (std::size_t i = 0; i < chain_.states(); ++i) {
        UndefinedPtr why;
        for (const StateVector& argument : arguments)
            if (!why) why = argument.undefined_in(i);
        try {
            if (!why) result.reals.push_back(apply_operator(expr, arguments, i));
        } catch (const Unclear& error) {
            why = std::make_shared<const Undefined>(
                Undefined{EvaluationError(rules::too_close, expr.span, {error.what()}), error.what()});
        } catch (const std::domain_error& error) {
            why = std::make_shared<const Undefined>(
                Undefined{EvaluationError(rules::arithmetic, expr.span, {error.what()}), ""});
        }
        if (why) result.add_undefined(std::move(why));
    }
    return result;
}

}  // namespace robochart::prism
