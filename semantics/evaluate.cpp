// Evaluation of expressions by structural recursion; the rules are in evaluate.hpp.
#include "semantics/evaluate.hpp"

#include <algorithm>
#include <utility>

#include "semantics/arithmetic.hpp"
#include "semantics/evaluate_composed.hpp"
#include "semantics/toolkit.hpp"

namespace robochart::ir {
namespace {

bool is_set_like(TypeKind kind) {
    return kind == TypeKind::set || kind == TypeKind::relation || kind == TypeKind::function;
}

bool is_composed(TypeKind kind) {
    return kind == TypeKind::vector || kind == TypeKind::matrix;
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
    Value clipped(const Expr& expr, ExprKind kind, TypeId type, const Value& left, const Value& right);
    Value negate(const Expr& expr);
    Value negated(const Value& value, TypeId type);
    Value zipped(const Expr& expr, TypeId entry, const Value& left, const Value& right);
    Value scaled_block(const Expr& expr, TypeId entry, const Value& left, const Value& right);
    Value product(const Expr& expr, TypeId entry, const Value& left, const Value& right);
    std::vector<std::vector<Value>> rows(const Value& block, TypeId type);
    TypeId entry_type(TypeId id) { return is_composed(kind(id)) ? system_.type(id).args.at(0) : id; }
    Value transposed(const Expr& expr);
    Value cast(const Expr& expr);
    Value converted(const Expr& expr, const Value& value, TypeId from, TypeId to);
    Value converted_parts(const Expr& expr, const Value& value, const Type& source, const Type& target);
    Value converted_pairs(const Expr& expr, const Value& pairs, const std::vector<TypeId>& from, const Type& target);
    Value converted_set(const Expr& expr, const Value& value, const Type& source, const Type& target);
    std::vector<TypeId> pair_types(const Type& type);
    Value constructed(const Expr& expr);
    Value access(const Expr& expr);
    Value quantified(const Expr& expr);
    Value let(const Expr& expr);
    Value function_call(const Expr& expr);
    Value function_result(const Function& function, const std::vector<Value>& arguments, const Expr& expr);
    Value function_pairs(const Expr& expr);
    Value toolkit_call(const Expr& expr);
    bool has_type(const Value& value, TypeId from, TypeId to);
    Value range(const Expr& expr);

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
    int depth_ = 0;  ///< functions being searched for
};

/// Functions may call themselves in their postconditions.
constexpr int deepest_call = 64;

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
std::optional<std::int64_t> exact(ExprKind kind, bool real, std::int64_t scale, std::int64_t left, std::int64_t right) {
    switch (kind) {
        case ExprKind::plus:
            return checked_add(left, right);
        case ExprKind::minus:
            return checked_subtract(left, right);
        case ExprKind::times:
            return real ? multiply_divide(left, right, scale) : checked_multiply(left, right);
        case ExprKind::divide:
            return real ? multiply_divide(left, scale, right) : floor_divide(left, right);
        default:
            return floor_modulus(left, right);
    }
}

/// RoboTool's Plus, Minus, ... on numbers of a type.
Value Evaluator::clipped(const Expr& expr, ExprKind op, TypeId type, const Value& left, const Value& right) {
    const bool divides = op == ExprKind::divide || op == ExprKind::modulus;
    if (divides && right.number == 0) fault(expr, "division by zero");
    const auto result = exact(op, kind(type) == TypeKind::real, instantiation_.scale, left.number, right.number);
    if (!result || !in_carrier(system_, instantiation_, type, {*result, {}})) return left;
    return {*result, {}};
}

Value Evaluator::arithmetic(const Expr& expr) {
    const Value left = operand(expr, 0);
    const Value right = operand(expr, 1);
    const bool left_block = is_composed(kind(argument(expr, 0).type));
    const bool right_block = is_composed(kind(argument(expr, 1).type));
    if (!left_block && !right_block) return clipped(expr, expr.kind, expr.type, left, right);
    const TypeId entry = entry_type(expr.type);
    if (expr.kind != ExprKind::times) return zipped(expr, entry, left, right);
    return left_block && right_block ? product(expr, entry, left, right) : scaled_block(expr, entry, left, right);
}

/// Entry by entry.
Value Evaluator::zipped(const Expr& expr, TypeId entry, const Value& left, const Value& right) {
    if (left.parts.empty()) return clipped(expr, expr.kind, entry, left, right);
    if (left.parts.size() != right.parts.size()) fault(expr, "the sizes differ");
    Value result;
    for (std::size_t i = 0; i < left.parts.size(); ++i)
        result.parts.push_back(zipped(expr, entry, left.parts[i], right.parts[i]));
    return result;
}

/// A number times every entry, the operands in their order: clipping keeps the first.
Value Evaluator::scaled_block(const Expr& expr, TypeId entry, const Value& left, const Value& right) {
    if (left.parts.empty() && right.parts.empty()) return clipped(expr, ExprKind::times, entry, left, right);
    Value result;
    for (const Value& part : left.parts) result.parts.push_back(scaled_block(expr, entry, part, right));
    if (left.parts.empty())
        for (const Value& part : right.parts) result.parts.push_back(scaled_block(expr, entry, left, part));
    return result;
}

/// A vector is a column.
std::vector<std::vector<Value>> Evaluator::rows(const Value& block, TypeId type) {
    std::vector<std::vector<Value>> result;
    for (const Value& part : block.parts)
        result.push_back(kind(type) == TypeKind::vector ? std::vector<Value>{part} : part.parts);
    return result;
}

/// Rows times columns, sums from the left; two vectors: their dot product.
Value Evaluator::product(const Expr& expr, TypeId entry, const Value& left, const Value& right) {
    const TypeId left_type = argument(expr, 0).type;
    const bool dot = kind(left_type) == TypeKind::vector && kind(argument(expr, 1).type) == TypeKind::vector;
    auto a = rows(left, left_type);
    const auto b = rows(right, argument(expr, 1).type);
    if (dot) a = {left.parts};
    if (a.empty() || b.empty() || a.front().size() != b.size()) fault(expr, "the sizes do not fit");
    const auto entry_at = [&](std::size_t row, std::size_t column) {
        Value sum = clipped(expr, ExprKind::times, entry, a[row][0], b[0][column]);
        for (std::size_t i = 1; i < b.size(); ++i)
            sum = clipped(expr, ExprKind::plus, entry, sum,
                          clipped(expr, ExprKind::times, entry, a[row][i], b[i][column]));
        return sum;
    };
    if (dot) return entry_at(0, 0);
    Value result;
    for (std::size_t row = 0; row < a.size(); ++row) {
        Value line;
        for (std::size_t column = 0; column < b.front().size(); ++column) line.parts.push_back(entry_at(row, column));
        result.parts.push_back(kind(expr.type) == TypeKind::vector ? line.parts.at(0) : std::move(line));
    }
    return result;
}

Value Evaluator::transposed(const Expr& expr) {
    const auto a = rows(operand(expr, 0), argument(expr, 0).type);
    Value result;
    for (std::size_t column = 0; column < a.at(0).size(); ++column) {
        Value line;
        for (const auto& row : a) line.parts.push_back(row.at(column));
        result.parts.push_back(std::move(line));
    }
    return result;
}

Value Evaluator::negated(const Value& value, TypeId type) {
    Value result;
    for (const Value& part : value.parts) result.parts.push_back(negated(part, type));
    if (!result.parts.empty()) return result;
    const auto number = checked_subtract(0, value.number);
    return number && in_carrier(system_, instantiation_, type, {*number, {}}) ? Value{*number, {}} : value;
}

Value Evaluator::negate(const Expr& expr) {
    return negated(operand(expr, 0), entry_type(expr.type));
}

/// The types of the parts of a value: one for each part.
std::vector<TypeId> part_types(const System& system, const Type& type, std::size_t parts) {
    if (type.kind == TypeKind::product || type.kind == TypeKind::record) return type.args;
    if (type.kind != TypeKind::matrix) return std::vector<TypeId>(parts, type.args.at(0));
    for (std::uint32_t i = 0; i < system.types.size(); ++i)
        if (system.types[i].kind == TypeKind::vector && system.types[i].args == type.args &&
            system.types[i].sizes.at(0) == type.sizes.at(1))
            return std::vector<TypeId>(parts, TypeId{i});
    return {};
}

/// The value as one of another type: numbers in its unit, sequences as sets of pairs where it is made of those.
Value Evaluator::converted(const Expr& expr, const Value& value, TypeId from, TypeId to) {
    if (from == to || !from.valid() || !to.valid()) return value;
    const Type& source = system_.type(from);
    const Type& target = system_.type(to);
    if (source.kind == TypeKind::sequence && is_set_like(target.kind))
        return converted_pairs(expr, pairs_of(value), {TypeId{}, source.args.at(0)}, target);
    if (is_set_like(source.kind) && is_set_like(target.kind)) return converted_set(expr, value, source, target);
    if (!value.parts.empty() && !target.args.empty()) return converted_parts(expr, value, source, target);
    const bool from_real = source.kind == TypeKind::real;
    const bool to_real = target.kind == TypeKind::real;
    if (from_real == to_real) return value;
    const auto result = to_real ? checked_multiply(value.number, instantiation_.scale)
                                : floor_divide(value.number, instantiation_.scale);
    if (!result) fault(expr, "the number does not fit into 64 bits at this scale");
    return {*result, {}};
}

/// The types of the two places of pairs; a set's elements that are no pairs have none.
std::vector<TypeId> Evaluator::pair_types(const Type& type) {
    if (type.args.size() == 2) return type.args;
    const Type& element = system_.type(type.args.at(0));
    return element.kind == TypeKind::product && element.args.size() == 2 ? element.args : std::vector<TypeId>{};
}

Value Evaluator::converted_pairs(const Expr& expr, const Value& pairs, const std::vector<TypeId>& from,
                                 const Type& target) {
    const std::vector<TypeId> to = pair_types(target);
    if (to.size() != 2) fault(expr, "no conversion to " + target.name);
    std::vector<Value> result;
    for (const Value& pair : pairs.parts)
        result.push_back({0,
                          {converted(expr, pair.parts.at(0), from[0].valid() ? from[0] : to[0], to[0]),
                           converted(expr, pair.parts.at(1), from[1], to[1])}});
    return set_of(std::move(result));
}

Value Evaluator::converted_set(const Expr& expr, const Value& value, const Type& source, const Type& target) {
    const std::vector<TypeId> from = pair_types(source);
    if (!from.empty() && !pair_types(target).empty()) return converted_pairs(expr, value, from, target);
    if (source.kind != TypeKind::set || target.kind != TypeKind::set) return value;
    std::vector<Value> result;
    for (const Value& part : value.parts) result.push_back(converted(expr, part, source.args.at(0), target.args.at(0)));
    return set_of(std::move(result));
}

Value Evaluator::converted_parts(const Expr& expr, const Value& value, const Type& source, const Type& target) {
    const auto from = part_types(system_, source, value.parts.size());
    const auto to = part_types(system_, target, value.parts.size());
    if (from.size() != value.parts.size() || to.size() != value.parts.size())
        fault(expr, "no conversion from " + source.name + " to " + target.name);
    Value result = value;
    for (std::size_t i = 0; i < result.parts.size(); ++i)
        result.parts[i] = converted(expr, value.parts[i], from[i], to[i]);
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
            return kind(expr.type) == TypeKind::vector ? Value{0, operands(expr)}
                                                       : matrix_of(operands(expr), expr.number);
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

Value Evaluator::function_call(const Expr& expr) {
    const std::vector<Value> arguments = operands(expr);
    if (!expr.function.valid()) return default_value(system_, instantiation_, expr.type);
    return function_result(system_.functions.at(expr.function.index), arguments, expr);
}

/// A function without definition is the constant 0, true or first literal (semantics 3.13); with postconditions, the
/// first value that satisfies them, that constant before all others.
Value Evaluator::function_result(const Function& function, const std::vector<Value>& arguments, const Expr& expr) {
    const Value constant = default_value(system_, instantiation_, function.result);
    if (function.postconditions.empty()) return constant;
    if (++depth_ > deepest_call) fault(expr, "the function " + function.name + " calls itself without end");
    std::vector<std::pair<std::string, Value>> inside;
    for (std::size_t i = 0; i < std::min(arguments.size(), function.parameter_names.size()); ++i)
        inside.emplace_back(function.parameter_names[i], arguments[i]);
    std::swap(inside, bindings_);
    const auto satisfies = [&](const Value& candidate) {
        bindings_.emplace_back("result", candidate);
        const bool holds = std::all_of(function.postconditions.begin(), function.postconditions.end(),
                                       [&](const ExprPtr& condition) { return value(*condition).number != 0; });
        bindings_.pop_back();
        return holds;
    };
    std::optional<Value> found;
    if (satisfies(constant)) found = constant;
    if (!found)
        for (const Value& candidate : carrier(system_, instantiation_, function.result))
            if (satisfies(candidate)) {
                found = candidate;
                break;
            }
    std::swap(inside, bindings_);
    --depth_;
    if (!found) fault(expr, "no value satisfies the postcondition of " + function.name);
    return *found;
}

/// A function as the set of its pairs.
Value Evaluator::function_pairs(const Expr& expr) {
    const Function& function = system_.functions.at(expr.function.index);
    std::vector<Value> pairs;
    for (const Value& argument : carrier(system_, instantiation_, system_.type(expr.type).args.at(0))) {
        const bool one = function.parameters.size() == 1;
        pairs.push_back(
            {0, {argument, function_result(function, one ? std::vector<Value>{argument} : argument.parts, expr)}});
    }
    return set_of(std::move(pairs));
}

Value Evaluator::toolkit_call(const Expr& expr) {
    std::vector<std::vector<Value>> carriers;
    for (const std::size_t place : toolkit_carriers(expr.text))
        carriers.push_back(carrier(system_, instantiation_, expr.bound_types.at(place)));
    return toolkit_result(expr.text, operands(expr), carriers, expr.span);
}

bool Evaluator::has_type(const Value& value, TypeId from, TypeId to) {
    if (kind(from) == TypeKind::real && kind(to) != TypeKind::real) {
        const auto rest = floor_modulus(value.number, instantiation_.scale);
        const auto whole = floor_divide(value.number, instantiation_.scale);
        return rest == 0 && in_carrier(system_, instantiation_, to, {*whole, {}});
    }
    Expr nowhere;
    return in_carrier(system_, instantiation_, to, converted(nowhere, value, from, to));
}

/// Whole numbers between the bounds, or the reals of the carrier between them.
Value Evaluator::range(const Expr& expr) {
    const std::int64_t low = operand(expr, 0).number;
    const std::int64_t high = operand(expr, 1).number;
    const bool open_low = expr.number == 1 || expr.number == 3;
    const bool open_high = expr.number >= 2;
    const auto& types = system_.type(expr.type).args;
    const TypeId element = types.empty() ? expr.args.at(0)->type : types[0];
    if (!element.valid() || kind(element) != TypeKind::real)
        return range_set(low + (open_low ? 1 : 0), high - (open_high ? 1 : 0), expr.span);
    std::vector<Value> members;
    for (const Value& value : carrier(system_, instantiation_, element))
        if ((open_low ? low < value.number : low <= value.number) &&
            (open_high ? value.number < high : value.number <= high))
            members.push_back(value);
    return set_of(std::move(members));
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
            return string_value(expr.text);
        case ExprKind::call:
            return function_call(expr);
        case ExprKind::function_value:
            return function_pairs(expr);
        case ExprKind::toolkit:
            return toolkit_call(expr);
        case ExprKind::is_type:
            return {has_type(operand(expr, 0), argument(expr, 0).type, expr.bound_types.at(0)) ? 1 : 0, {}};
        case ExprKind::range:
            return range(expr);
        case ExprKind::transpose:
            return transposed(expr);
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
