// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/solver.hpp"

#include "semantics/data/kept_data.hpp"

#ifdef ROBOCHART_Z3

#include <z3++.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>

#include "semantics/ir/arithmetic.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

constexpr std::size_t most_combinations = 4'096;
constexpr std::size_t most_numbers = 8;  ///< limit for one value; each number doubles the decimals that are tried
/// Limits for one call of the solver. The time is limited too, because the solver does not count all of its steps.
constexpr unsigned most_steps = 2'000'000, most_milliseconds = 2'000;
/// The limit for all values.
constexpr std::chrono::seconds most_time{10};
/// The limit of the solver's memory in MB.
constexpr unsigned most_memory = 1'024;

/// Translates conditions on one value into formulas over the numbers in it. For nat and int, the solver uses integers,
/// and otherwise reals.
class SolverFormulas {
public:
    using Formula = std::optional<z3::expr>;

    SolverFormulas(z3::context& context, const System& system, const Sampling& sampling)
        : context_(context), system_(system), sampling_(sampling), numbers_(context) {}

    /// Returns no value if the condition has another form.
    [[nodiscard]] Formula truth(const Condition& condition) {
        machine_ = condition.machine;
        return read_truth(*condition.body);
    }
    [[nodiscard]] const std::vector<NumberPart>& parts() const { return parts_; }
    /// Returns the solver's numbers, in the order of the parts.
    [[nodiscard]] const z3::expr_vector& numbers() const { return numbers_; }

private:
    [[nodiscard]] Formula read_truth(const Expr& expr);
    [[nodiscard]] Formula read_connective(const Expr& expr);
    [[nodiscard]] Formula read_comparison(const Expr& expr);
    [[nodiscard]] Formula read_membership(const Expr& expr);
    [[nodiscard]] Formula read_number(const Expr& expr);
    [[nodiscard]] Formula read_operation(const Expr& expr);
    [[nodiscard]] Formula read_quotient(const Expr& expr);
    [[nodiscard]] Formula read_cast(const Expr& expr);
    [[nodiscard]] Formula read_choice(const Expr& expr, Formula then, Formula otherwise);
    [[nodiscard]] Formula read_part(const Expr& expr);
    [[nodiscard]] Formula literal(const Expr& expr) const;
    [[nodiscard]] TypeKind kind_of(const Expr& expr) const { return system_.type(expr.type).kind; }
    [[nodiscard]] z3::expr number_at(const NumberPart& part);

    z3::context& context_;
    const System& system_;
    const Sampling& sampling_;
    MachineId machine_;
    std::vector<NumberPart> parts_;
    z3::expr_vector numbers_;
};

bool is_solver_number(TypeKind kind) {
    return kind == TypeKind::nat || kind == TypeKind::integer || kind == TypeKind::real;
}

/// Returns the value of an expression without variables.
SolverFormulas::Formula SolverFormulas::literal(const Expr& expr) const {
    const auto value = sampling_.closed_value(machine_, expr);
    if (!value) return std::nullopt;
    const TypeKind kind = kind_of(expr);
    if (kind == TypeKind::boolean) return context_.bool_val(value->number != 0);
    const std::string number = std::to_string(value->number);
    if (kind != TypeKind::real) return context_.int_val(number.c_str());
    return context_.real_val((number + "/" + std::to_string(sampling_.instantiation().scale)).c_str());
}

z3::expr SolverFormulas::number_at(const NumberPart& part) {
    const auto found = std::ranges::find(parts_, part);
    if (found != parts_.end()) return numbers_[static_cast<int>(found - parts_.begin())];
    const std::string name = "x" + std::to_string(parts_.size());
    z3::sort sort = context_.int_sort();
    if (part.kind == TypeKind::real) sort = context_.real_sort();
    if (part.kind == TypeKind::boolean) sort = context_.bool_sort();
    parts_.push_back(part);
    numbers_.push_back(context_.constant(name.c_str(), sort));
    return numbers_.back();
}

/// Returns the value that the condition reads, or a part of it.
SolverFormulas::Formula SolverFormulas::read_part(const Expr& expr) {
    NumberPart part{{}, kind_of(expr)};
    if (!is_solver_number(part.kind) && part.kind != TypeKind::boolean) return std::nullopt;
    const Expr* at = &expr;
    for (; at->kind == ExprKind::member; at = at->args.at(0).get()) {
        const bool record = kind_of(*at->args.at(0)) == TypeKind::record;
        part.path.insert(part.path.begin(), static_cast<std::size_t>(at->number) - (record ? 0 : 1));
    }
    if (at->kind != ExprKind::variable && at->kind != ExprKind::trigger_value) return std::nullopt;
    return number_at(part);
}

SolverFormulas::Formula SolverFormulas::read_choice(const Expr& expr, Formula then, Formula otherwise) {
    const Formula condition = read_truth(*expr.args.at(0));
    if (!condition || !then || !otherwise) return std::nullopt;
    return z3::ite(*condition, *then, *otherwise);
}

SolverFormulas::Formula SolverFormulas::read_truth(const Expr& expr) {
    if (const Formula closed = literal(expr)) return closed;
    if (is_connective(expr.kind)) return read_connective(expr);
    if (is_comparison(expr.kind)) return read_comparison(expr);
    if (expr.kind == ExprKind::is_in) return read_membership(expr);
    if (expr.kind == ExprKind::if_then_else)
        return read_choice(expr, read_truth(*expr.args.at(1)), read_truth(*expr.args.at(2)));
    return read_part(expr);
}

SolverFormulas::Formula SolverFormulas::read_connective(const Expr& expr) {
    std::vector<z3::expr> parts;
    for (const ExprPtr& argument : expr.args) {
        const Formula part = read_truth(*argument);
        if (!part) return std::nullopt;
        parts.push_back(*part);
    }
    if (expr.kind == ExprKind::logical_not) return !parts.at(0);
    const z3::expr& left = parts.at(0);
    const z3::expr& right = parts.at(1);
    if (expr.kind == ExprKind::conjunction) return left && right;
    if (expr.kind == ExprKind::disjunction) return left || right;
    if (expr.kind == ExprKind::implies) return z3::implies(left, right);
    return left == right;
}

SolverFormulas::Formula SolverFormulas::read_comparison(const Expr& expr) {
    const Expr& first = *expr.args.at(0);
    const Expr& second = *expr.args.at(1);
    const bool truths = kind_of(first) == TypeKind::boolean && kind_of(second) == TypeKind::boolean;
    if ((kind_of(first) == TypeKind::real) != (kind_of(second) == TypeKind::real)) return std::nullopt;
    const Formula left = truths ? read_truth(first) : read_number(first);
    const Formula right = truths ? read_truth(second) : read_number(second);
    if (!left || !right) return std::nullopt;
    if (expr.kind == ExprKind::equal) return *left == *right;
    if (expr.kind == ExprKind::not_equal) return *left != *right;
    if (truths) return std::nullopt;
    if (expr.kind == ExprKind::less) return *left < *right;
    if (expr.kind == ExprKind::less_equal) return *left <= *right;
    if (expr.kind == ExprKind::greater) return *left > *right;
    return *left >= *right;
}

/// Translates membership of a number in a list of numbers.
SolverFormulas::Formula SolverFormulas::read_membership(const Expr& expr) {
    const Formula number = read_number(*expr.args.at(0));
    const Expr& set = *expr.args.at(1);
    if (!number || set.kind != ExprKind::set) return std::nullopt;
    z3::expr result = context_.bool_val(false);
    for (const ExprPtr& argument : set.args) {
        const Formula member = read_number(*argument);
        if (!member || member->is_int() != number->is_int()) return std::nullopt;
        result = result || *number == *member;
    }
    return result;
}

SolverFormulas::Formula SolverFormulas::read_number(const Expr& expr) {
    if (!is_solver_number(kind_of(expr))) return std::nullopt;
    if (const Formula closed = literal(expr)) return closed;
    if (expr.kind == ExprKind::plus || expr.kind == ExprKind::minus || expr.kind == ExprKind::times)
        return read_operation(expr);
    if (expr.kind == ExprKind::divide || expr.kind == ExprKind::modulus) return read_quotient(expr);
    if (expr.kind == ExprKind::cast) return read_cast(expr);
    if (expr.kind == ExprKind::if_then_else)
        return read_choice(expr, read_number(*expr.args.at(1)), read_number(*expr.args.at(2)));
    if (expr.kind != ExprKind::negate) return read_part(expr);
    const Formula number = read_number(*expr.args.at(0));
    if (!number) return std::nullopt;
    return -*number;
}

SolverFormulas::Formula SolverFormulas::read_operation(const Expr& expr) {
    const Formula left = read_number(*expr.args.at(0)), right = read_number(*expr.args.at(1));
    if (!left || !right || left->is_int() != right->is_int()) return std::nullopt;
    if (expr.kind == ExprKind::plus) return *left + *right;
    if (expr.kind == ExprKind::minus) return *left - *right;
    return *left * *right;
}

/// Translates quotients and remainders with positive constant divisors. They are rounded down, like those of the solver
/// for integers. The remainder of a real is left - right * floor(left / right).
SolverFormulas::Formula SolverFormulas::read_quotient(const Expr& expr) {
    const auto divisor = sampling_.closed_value(machine_, *expr.args.at(1));
    const Formula left = read_number(*expr.args.at(0)), right = read_number(*expr.args.at(1));
    if (!divisor || divisor->number <= 0 || !left || !right || left->is_int() != right->is_int()) return std::nullopt;
    if (expr.kind == ExprKind::divide) return *left / *right;
    if (left->is_int()) return z3::mod(*left, *right);
    const z3::expr turns(context_, Z3_mk_real2int(context_, *left / *right));
    return *left - *right * z3::to_real(turns);
}

SolverFormulas::Formula SolverFormulas::read_cast(const Expr& expr) {
    const TypeKind from = kind_of(*expr.args.at(0)), to = kind_of(expr);
    if (to == TypeKind::nat && from != TypeKind::nat) return std::nullopt;  // undefined for negative numbers
    const Formula number = read_number(*expr.args.at(0));
    if (!number) return std::nullopt;
    if (to == TypeKind::real && number->is_int()) return z3::to_real(*number);
    if (to != TypeKind::real && !number->is_int()) return z3::expr(context_, Z3_mk_real2int(context_, *number));
    return number;
}

/// A number as a fraction.
struct SolverFraction {
    std::int64_t numerator = 0, denominator = 1;
};

/// Returns the number, or a slightly smaller fraction if the number is irrational.
std::optional<SolverFraction> read_fraction(z3::context& context, const z3::expr& number) {
    z3::expr rational = number;
    if (!number.is_numeral() && number.is_algebraic()) rational = number.algebraic_lower(9);
    SolverFraction result;
    if (!rational.is_numeral() ||
        !Z3_get_numeral_rational_int64(context, rational, &result.numerator, &result.denominator))
        return std::nullopt;
    return result;
}

/// Finds the combinations of answers, one after the other.
class SolverSearch {
public:
    SolverSearch(const System& system, const Sampling& sampling, TypeId type, const std::vector<Condition>& conditions)
        : system_(system),
          sampling_(sampling),
          type_(type),
          conditions_(conditions),
          formulas_(context_, system, sampling),
          truths_(context_) {}

    [[nodiscard]] std::optional<std::vector<Value>> values() {
        for (const Condition& condition : conditions_) {
            const auto truth = formulas_.truth(condition);
            if (!truth || formulas_.parts().size() > most_numbers) return std::nullopt;
            truths_.push_back(*truth);
        }
        z3::solver solver = make_solver();
        std::vector<Value> found;
        while (found.size() <= most_combinations) {
            const z3::check_result result = check(solver);
            if (result == z3::unsat) return found;
            if (result == z3::unknown || !add_value(solver, found)) return std::nullopt;
        }
        return std::nullopt;
    }

private:
    using Answers = std::vector<int>;

    /// Makes a solver for the logic of the conditions. Z3 decides polynomials over the reals completely in the logic
    /// QF_NRA (Jovanović and de Moura, Solving non-linear arithmetic, IJCAR 2012).
    [[nodiscard]] z3::solver make_solver() {
        const bool reals = std::ranges::all_of(formulas_.parts(), [](const NumberPart& part) {
            return part.kind == TypeKind::real || part.kind == TypeKind::boolean;
        });
        const bool rounds = std::ranges::any_of(conditions_, [](const Condition& condition) {
            bool found = false;
            visit_operands(*condition.body, [&](const Expr& expr) {
                found = found || expr.kind == ExprKind::modulus || expr.kind == ExprKind::cast;
            });
            return found;
        });
        z3::solver result = reals && !rounds ? z3::solver(context_, "QF_NRA") : z3::solver(context_);
        for (std::size_t i = 0; i < formulas_.parts().size(); ++i)
            if (formulas_.parts()[i].kind == TypeKind::nat) result.add(formulas_.numbers()[static_cast<int>(i)] >= 0);
        return result;
    }

    /// Runs the solver. Sets ctrl_c to false: otherwise the solver would replace our handler of SIGINT while it
    /// runs.
    [[nodiscard]] z3::check_result check(z3::solver& solver) {
        sampling_.instantiation().poll();
        if (std::chrono::steady_clock::now() > end_) return z3::unknown;
        z3::params limits(context_);
        limits.set("rlimit", most_steps);
        limits.set("timeout", most_milliseconds);
        limits.set("max_memory", most_memory);
        limits.set("ctrl_c", false);
        solver.set(limits);
        const z3::check_result result = solver.check();
        sampling_.instantiation().poll();
        return result;
    }

    /// Adds a value that has the answers of the solver's model. Then excludes this combination of answers.
    [[nodiscard]] bool add_value(z3::solver& solver, std::vector<Value>& found) {
        const z3::model model = solver.get_model();
        Answers answers;
        z3::expr other = context_.bool_val(false);
        for (unsigned i = 0; i < truths_.size(); ++i) {
            const z3::expr truth = truths_[static_cast<int>(i)];
            answers.push_back(model.eval(truth, true).is_true() ? 1 : 0);
            other = other || truth != context_.bool_val(answers.back() == 1);
        }
        auto value = decimal_value(model, answers);
        if (!value) return false;
        found.push_back(std::move(*value));
        solver.add(other);
        return true;
    }

    [[nodiscard]] std::optional<Value> decimal_value(const z3::model& model, const Answers& answers);
    [[nodiscard]] std::optional<Value> rounded_value(const std::vector<SolverFraction>& numbers, std::int64_t step,
                                                     const Answers& answers) const;
    [[nodiscard]] bool gives(const Value& value, const Answers& answers) const;

    const System& system_;
    const Sampling& sampling_;
    TypeId type_;
    const std::vector<Condition>& conditions_;
    z3::context context_;
    SolverFormulas formulas_;
    z3::expr_vector truths_;
    std::chrono::steady_clock::time_point end_ = std::chrono::steady_clock::now() + most_time;
};

bool SolverSearch::gives(const Value& value, const Answers& answers) const {
    for (std::size_t c = 0; c < conditions_.size(); ++c)
        if (sampling_.truth(conditions_[c].machine, *conditions_[c].body, value) != answers[c]) return false;
    return true;
}

/// Returns a value close to the solver's numbers. Each of its numbers is a multiple of the step, in units.
std::optional<Value> SolverSearch::rounded_value(const std::vector<SolverFraction>& numbers, std::int64_t step,
                                                 const Answers& answers) const {
    const std::int64_t scale = sampling_.instantiation().scale;
    for (std::size_t above = 0; above < std::size_t{1} << numbers.size(); ++above) {
        std::vector<std::int64_t> units;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const bool real = formulas_.parts()[i].kind == TypeKind::real;
            const auto steps = real ? multiply_divide(numbers[i].numerator, scale / step, numbers[i].denominator)
                                    : std::optional(numbers[i].numerator);
            const bool next = real && ((above >> i) & 1U) != 0;
            const auto number = steps ? checked_multiply(*steps + (next ? 1 : 0), real ? step : 1) : std::nullopt;
            if (!number) return std::nullopt;
            units.push_back(*number);
        }
        sampling_.instantiation().poll();
        Value value = value_at(system_, sampling_.instantiation(), type_, formulas_.parts(), units);
        if (gives(value, answers)) return value;
    }
    return std::nullopt;
}

/// Returns a value with as few decimal places as possible.
std::optional<Value> SolverSearch::decimal_value(const z3::model& model, const Answers& answers) {
    std::vector<SolverFraction> numbers;
    for (std::size_t i = 0; i < formulas_.parts().size(); ++i) {
        const z3::expr number = model.eval(formulas_.numbers()[static_cast<int>(i)], true);
        if (formulas_.parts()[i].kind == TypeKind::boolean) {
            numbers.push_back({number.is_true() ? 1 : 0, 1});
            continue;
        }
        const auto fraction = read_fraction(context_, number);
        if (!fraction) return std::nullopt;
        numbers.push_back(*fraction);
    }
    for (std::int64_t step = sampling_.instantiation().scale; step > 0; step /= 10)
        if (auto value = rounded_value(numbers, step, answers)) return value;
    return std::nullopt;
}

}  // namespace

bool has_solver() {
    return true;
}

std::optional<std::vector<Value>> solve_answers(const System& system, const Sampling& sampling, TypeId type,
                                                const std::vector<Condition>& conditions) {
    try {
        return SolverSearch(system, sampling, type, conditions).values();
    } catch (const z3::exception&) {
        return std::nullopt;  // for example, a limit on memory
    }
}

}  // namespace robochart::ir

#else

namespace robochart::ir {

bool has_solver() {
    return false;
}

std::optional<std::vector<Value>> solve_answers(const System&, const Sampling&, TypeId, const std::vector<Condition>&) {
    return std::nullopt;
}

}  // namespace robochart::ir

#endif
