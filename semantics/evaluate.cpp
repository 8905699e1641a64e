// Evaluation of expressions by structural recursion; the rules are in evaluate.hpp.
#include "semantics/evaluate.hpp"

#include <algorithm>
#include <utility>

#include "semantics/arithmetic.hpp"
#include "semantics/evaluate_composed.hpp"

namespace robochart::ir {
namespace {

bool is_composed(TypeKind kind) {
    return kind == TypeKind::vector || kind == TypeKind::matrix || kind == TypeKind::product;
}

class Evaluator {
public:
    Evaluator(const System& system, const Instantiation& instantiation, const Machine* machine,
              const Environment& environment)
        : system_(system), instantiation_(instantiation), machine_(machine), environment_(environment) {}

    Value value(const Expr& expr);

private:
    [[noreturn]] static void fault(const Expr& expr, const std::string& cause) {
        throw EvaluationFault(cause, expr.span);
    }

    Value literal(const Expr& expr);
    Value name(const Expr& expr);
    Value logic(const Expr& expr);
    Value comparison(const Expr& expr);
    Value arithmetic(const Expr& expr);
    std::optional<std::int64_t> exact(const Expr& expr, std::int64_t left, std::int64_t right);
    Value negate(const Expr& expr);
    Value cast(const Expr& expr);
    Value converted(const Expr& expr, const Value& value, TypeId from, TypeId to);
    Value converted_parts(const Expr& expr, const Value& value, const Type& source, const Type& target);
    Value constructed(const Expr& expr);
    Value access(const Expr& expr);
    Value quantified(const Expr& expr);
    Value let(const Expr& expr);
    Value undefined_function(const Expr& expr);

    const Expr& argument(const Expr& expr, std::size_t index);
    Value operand(const Expr& expr, std::size_t index) { return value(argument(expr, index)); }
    bool truth(const Expr& expr, std::size_t index) { return operand(expr, index).number != 0; }
    TypeKind kind(TypeId id) { return id.valid() ? system_.type(id).kind : TypeKind::unit; }
    std::vector<Value> operands(const Expr& expr);
    template <class Body>
    void each_binding(const Expr& expr, std::size_t index, const Body& body);
    Value bound(const Expr& expr);

    const System& system_;
    const Instantiation& instantiation_;
    const Machine* machine_;
    const Environment& environment_;
    std::vector<std::pair<std::string, Value>> bindings_;
};

const Expr& Evaluator::argument(const Expr& expr, std::size_t index) {
    if (index >= expr.args.size() || !expr.args[index]) fault(expr, "an operand is missing");
    return *expr.args[index];
}

std::vector<Value> Evaluator::operands(const Expr& expr) {
    std::vector<Value> values;
    for (std::size_t i = 0; i < expr.args.size(); ++i) values.push_back(operand(expr, i));
    return values;
}

Value Evaluator::literal(const Expr& expr) {
    if (expr.kind == ExprKind::enum_literal) return {expr.number, operands(expr)};
    if (expr.kind != ExprKind::real) return {expr.number, {}};
    const auto units = scaled(expr.decimal, instantiation_.scale);
    if (!units) fault(expr, "the number does not fit into 64 bits at this scale");
    return {*units, {}};
}

template <class T>
const T* element(const std::vector<T>& values, std::uint32_t index) {
    return index < values.size() ? &values[index] : nullptr;
}

ClockId entry_clock(const Machine& machine, NodeId node) {
    for (std::uint32_t i = 0; i < machine.clocks.size(); ++i)
        if (machine.clocks[i].entry_of == node) return ClockId{i};
    return {};
}

Value Evaluator::name(const Expr& expr) {
    if (expr.kind == ExprKind::variable)
        if (const auto* found = element(environment_.variables, expr.variable.index)) return *found;
    if (expr.kind == ExprKind::constant)
        if (const auto* found = element(environment_.constants, expr.constant.index)) return *found;
    if (expr.kind == ExprKind::trigger_value && environment_.trigger) return *environment_.trigger;
    ClockId clock = expr.clock;
    if (expr.kind == ExprKind::since_entry && machine_ != nullptr) clock = entry_clock(*machine_, expr.node);
    if (expr.kind == ExprKind::since || expr.kind == ExprKind::since_entry)
        if (const auto* found = element(environment_.clocks, clock.index)) return {*found, {}};
    fault(expr, "a name has no value here");
}

Value Evaluator::bound(const Expr& expr) {
    for (auto it = bindings_.rbegin(); it != bindings_.rend(); ++it)
        if (it->first == expr.text) return it->second;
    fault(expr, "'" + expr.text + "' is not bound here");
}

Value Evaluator::logic(const Expr& expr) {
    bool result = false;
    switch (expr.kind) {
        case ExprKind::logical_not:
            result = !truth(expr, 0);
            break;
        case ExprKind::conjunction:
            result = truth(expr, 0) && truth(expr, 1);
            break;
        case ExprKind::disjunction:
            result = truth(expr, 0) || truth(expr, 1);
            break;
        case ExprKind::implies:
            result = !truth(expr, 0) || truth(expr, 1);
            break;
        default:
            result = truth(expr, 0) == truth(expr, 1);
            break;
    }
    return {result ? 1 : 0, {}};
}

Value Evaluator::comparison(const Expr& expr) {
    const Value left = operand(expr, 0);
    const Value right = operand(expr, 1);
    bool result = false;
    switch (expr.kind) {
        case ExprKind::equal:
            result = left == right;
            break;
        case ExprKind::not_equal:
            result = left != right;
            break;
        case ExprKind::greater:
            result = left.number > right.number;
            break;
        case ExprKind::greater_equal:
            result = left.number >= right.number;
            break;
        case ExprKind::less:
            result = left.number < right.number;
            break;
        default:
            result = left.number <= right.number;
            break;
    }
    return {result ? 1 : 0, {}};
}

/// The result before clipping; nothing if it lies beyond 64 bits, hence outside every carrier.
std::optional<std::int64_t> Evaluator::exact(const Expr& expr, std::int64_t left, std::int64_t right) {
    const bool real = kind(expr.type) == TypeKind::real;
    const bool divides = expr.kind == ExprKind::divide || expr.kind == ExprKind::modulus;
    if (divides && right == 0) fault(expr, "division by zero");
    switch (expr.kind) {
        case ExprKind::plus:
            return checked_add(left, right);
        case ExprKind::minus:
            return checked_subtract(left, right);
        case ExprKind::times:
            return real ? multiply_divide(left, right, instantiation_.scale) : checked_multiply(left, right);
        case ExprKind::divide:
            return real ? multiply_divide(left, instantiation_.scale, right) : floor_divide(left, right);
        default:
            return floor_modulus(left, right);
    }
}

Value Evaluator::arithmetic(const Expr& expr) {
    const Value left = operand(expr, 0);
    const Value right = operand(expr, 1);
    const bool composed = is_composed(kind(argument(expr, 0).type)) || is_composed(kind(argument(expr, 1).type));
    if (composed) fault(expr, "arithmetic on vectors and matrices is not supported yet");
    const auto result = exact(expr, left.number, right.number);
    if (!result || !in_carrier(system_, instantiation_, expr.type, {*result, {}})) return left;
    return {*result, {}};
}

Value Evaluator::negate(const Expr& expr) {
    const Value value = operand(expr, 0);
    if (is_composed(kind(expr.type))) fault(expr, "arithmetic on vectors and matrices is not supported yet");
    const auto result = checked_subtract(0, value.number);
    if (!result || !in_carrier(system_, instantiation_, expr.type, {*result, {}})) return value;
    return {*result, {}};
}

/// The value in the other type's unit, part by part: only numbers have one.
Value Evaluator::converted(const Expr& expr, const Value& value, TypeId from, TypeId to) {
    if (from == to || !from.valid() || !to.valid()) return value;
    const Type& source = system_.type(from);
    const Type& target = system_.type(to);
    const bool from_real = source.kind == TypeKind::real;
    const bool to_real = target.kind == TypeKind::real;
    if (!value.parts.empty() && !target.args.empty()) return converted_parts(expr, value, source, target);
    if (from_real == to_real) return value;
    const auto result = to_real ? checked_multiply(value.number, instantiation_.scale)
                                : floor_divide(value.number, instantiation_.scale);
    if (!result) fault(expr, "the number does not fit into 64 bits at this scale");
    return {*result, {}};
}

Value Evaluator::converted_parts(const Expr& expr, const Value& value, const Type& source, const Type& target) {
    if (source.kind != target.kind || source.args.size() != target.args.size())
        fault(expr, "no conversion from " + source.name + " to " + target.name);
    const bool by_place = source.kind == TypeKind::product;
    if (!by_place && source.args.size() != 1)
        fault(expr, "no conversion between " + source.name + " and " + target.name);
    Value result = value;
    for (std::size_t i = 0; i < result.parts.size(); ++i) {
        const std::size_t place = by_place ? i : 0;
        result.parts[i] = converted(expr, value.parts[i], source.args.at(place), target.args.at(place));
    }
    return result;
}

Value Evaluator::cast(const Expr& expr) {
    return converted(expr, operand(expr, 0), argument(expr, 0).type, expr.type);
}

Value Evaluator::constructed(const Expr& expr) {
    switch (expr.kind) {
        case ExprKind::set:
            return set_of(operands(expr));
        case ExprKind::matrix:
            return matrix_of(operands(expr), expr.number);
        case ExprKind::set_range:
            return range_set(operand(expr, 0).number, operand(expr, 1).number, expr.span);
        default:
            return {0, operands(expr)};
    }
}

Value Evaluator::access(const Expr& expr) {
    Value base = operand(expr, 0);
    if (expr.kind == ExprKind::concat) {
        const Value tail = operand(expr, 1);
        base.parts.insert(base.parts.end(), tail.parts.begin(), tail.parts.end());
        return base;
    }
    if (expr.kind == ExprKind::member) {
        const bool record = kind(argument(expr, 0).type) == TypeKind::record;
        return part(base, expr.number + (record ? 1 : 0), expr.span);
    }
    std::vector<Value> rest = operands(expr);
    rest.erase(rest.begin());
    if (expr.kind == ExprKind::apply) return applied(base, rest, expr.span);
    for (const Value& index : rest) base = part(base, index.number, expr.span);
    return base;
}

/// Runs `body` for every combination of the bound variables' values.
template <class Body>
void Evaluator::each_binding(const Expr& expr, std::size_t index, const Body& body) {
    if (index == expr.bound_names.size()) return body();
    if (index >= expr.bound_types.size()) fault(expr, "a bound variable has no type");
    for (const Value& candidate : carrier(system_, instantiation_, expr.bound_types[index])) {
        bindings_.emplace_back(expr.bound_names[index], candidate);
        each_binding(expr, index + 1, body);
        bindings_.pop_back();
    }
}

Value Evaluator::quantified(const Expr& expr) {
    const std::size_t bindings = bindings_.size();
    std::vector<Value> found;  // value of the body wherever the predicate holds
    each_binding(expr, 0, [&] {
        if (!truth(expr, 0)) return;
        Value arguments = bound_tuple(bindings_, bindings);
        if (expr.kind == ExprKind::lambda)
            found.push_back({0, {arguments, operand(expr, 1)}});
        else if (expr.kind == ExprKind::the || expr.kind == ExprKind::set_comprehension)
            found.push_back(expr.args.size() > 1 && expr.args[1] ? operand(expr, 1) : std::move(arguments));
        else
            found.push_back(operand(expr, 1));
    });
    const auto holds = std::count_if(found.begin(), found.end(), [](const Value& v) { return v.number != 0; });
    switch (expr.kind) {
        case ExprKind::forall:
            return {holds == static_cast<std::ptrdiff_t>(found.size()) ? 1 : 0, {}};
        case ExprKind::exists:
            return {holds > 0 ? 1 : 0, {}};
        case ExprKind::exists_unique:
            return {holds == 1 ? 1 : 0, {}};
        case ExprKind::the:
            if (found.size() != 1) fault(expr, "`the` needs exactly one candidate");
            return found.front();
        default:
            return set_of(std::move(found));
    }
}

/// A function without definition is the constant 0, true or first literal (semantics 3.13).
Value Evaluator::undefined_function(const Expr& expr) {
    operands(expr);
    return default_value(system_, instantiation_, expr.type);
}

Value Evaluator::let(const Expr& expr) {
    const std::size_t bindings = bindings_.size();
    for (std::size_t i = 0; i < expr.bound_names.size(); ++i) {
        Value value = operand(expr, i);
        bindings_.emplace_back(expr.bound_names[i], std::move(value));
    }
    Value result = operand(expr, expr.bound_names.size());
    bindings_.resize(bindings);
    return result;
}

Value Evaluator::value(const Expr& expr) {
    switch (expr.kind) {
        case ExprKind::boolean:
        case ExprKind::integer:
        case ExprKind::real:
        case ExprKind::enum_literal:
            return literal(expr);
        case ExprKind::variable:
        case ExprKind::constant:
        case ExprKind::trigger_value:
        case ExprKind::since:
        case ExprKind::since_entry:
            return name(expr);
        case ExprKind::bound:
            return bound(expr);
        case ExprKind::logical_not:
        case ExprKind::iff:
        case ExprKind::implies:
        case ExprKind::disjunction:
        case ExprKind::conjunction:
            return logic(expr);
        case ExprKind::equal:
        case ExprKind::not_equal:
        case ExprKind::greater:
        case ExprKind::greater_equal:
        case ExprKind::less:
        case ExprKind::less_equal:
            return comparison(expr);
        case ExprKind::plus:
        case ExprKind::minus:
        case ExprKind::times:
        case ExprKind::divide:
        case ExprKind::modulus:
            return arithmetic(expr);
        case ExprKind::negate:
            return negate(expr);
        case ExprKind::if_then_else:
            return truth(expr, 0) ? operand(expr, 1) : operand(expr, 2);
        case ExprKind::cast:
            return cast(expr);
        case ExprKind::tuple:
        case ExprKind::record:
        case ExprKind::sequence:
        case ExprKind::matrix:
        case ExprKind::set:
        case ExprKind::set_range:
            return constructed(expr);
        case ExprKind::member:
        case ExprKind::index:
        case ExprKind::apply:
        case ExprKind::concat:
            return access(expr);
        case ExprKind::is_in:
            return {is_part(operand(expr, 1), operand(expr, 0)) ? 1 : 0, {}};
        case ExprKind::forall:
        case ExprKind::exists:
        case ExprKind::exists_unique:
        case ExprKind::lambda:
        case ExprKind::the:
        case ExprKind::set_comprehension:
            return quantified(expr);
        case ExprKind::let:
            return let(expr);
        case ExprKind::string:
            fault(expr, "strings are not supported yet");
        case ExprKind::call:
            return undefined_function(expr);
        case ExprKind::function_value:
            fault(expr, "the function has no definition to evaluate");
    }
    fault(expr, "the expression has no value");
}

}  // namespace

Value evaluate(const System& system, const Instantiation& instantiation, const Machine* machine,
               const Environment& environment, const Expr& expr) {
    return Evaluator(system, instantiation, machine, environment).value(expr);
}

std::optional<std::int64_t> scaled(const Decimal& decimal, std::int64_t scale) {
    const auto divisor = power_of_ten(decimal.decimals);
    if (!divisor) return std::nullopt;
    return multiply_divide(decimal.unscaled, scale, *divisor);
}

}  // namespace robochart::ir
