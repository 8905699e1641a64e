// SPDX-License-Identifier: Apache-2.0
// Declares the class that implements evaluate.hpp by structural recursion. Each family of expressions has a member
// function. Four source files define them. Private to this component.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "semantics/evaluate/carrier.hpp"
#include "semantics/evaluate/environment.hpp"

namespace robochart::ir {

[[nodiscard]] inline bool is_composed(TypeKind kind) {
    return kind == TypeKind::vector || kind == TypeKind::matrix;
}

/// Functions may call themselves in their pre- and postconditions, so the nesting of calls is limited.
inline constexpr int deepest_call = 64;
/// Limits the calls of one evaluation. If a function calls itself twice, 64 levels would make 2^64 calls.
inline constexpr int most_calls = 100'000;

class Evaluator {
public:
    Evaluator(const System& system, const Instantiation& instantiation, const Machine* machine,
              const Environment& environment)
        : system_(system), instantiation_(instantiation), machine_(machine), environment_(environment) {}

    Value evaluate_value(const Expr& expr);
    /// Returns true if the preconditions of all called functions are true. Evaluates them in the order of the
    /// semantics.
    bool is_defined(const Expr& expr);
    /// True if the function's preconditions are true for these arguments.
    bool may_be_called(const Function& function, const std::vector<Value>& arguments, const Expr& expr);

private:
    [[noreturn]] static void throw_fault(const Expr& expr, const std::string& cause) {
        throw EvaluationFault(cause, expr.span);
    }

    Value evaluate_literal(const Expr& expr);
    Value name(const Expr& expr);
    static Value truth_value(bool holds) { return {holds ? 1 : 0, {}}; }
    /// Returns the truth value of `holds` for the values of both operands.
    template <class Holds>
    Value compare_operands(const Expr& expr, const Holds& holds);
    /// Returns the truth value of `holds` for the numbers of both operands.
    template <class Holds>
    Value compare_numbers(const Expr& expr, const Holds& holds);
    Value evaluate_arithmetic(const Expr& expr);
    Value clip_result(const Expr& expr, ExprKind kind, TypeId type, const Value& left, const Value& right);
    Value evaluate_negation(const Expr& expr);
    Value negate_value(const Value& value, TypeId type);
    Value apply_entrywise(const Expr& expr, TypeId entry, const Value& left, const Value& right);
    Value scaled_block(const Expr& expr, TypeId entry, const Value& left, const Value& right);
    Value multiply_blocks(const Expr& expr, TypeId entry, const Value& left, const Value& right);
    std::vector<std::vector<Value>> rows_of(const Value& block, TypeId type);
    TypeId entry_type(TypeId id) { return is_composed(kind(id)) ? system_.type(id).args.at(0) : id; }
    Value evaluate_transpose(const Expr& expr);
    Value evaluate_cast(const Expr& expr);
    Value convert_value(const Expr& expr, const Value& value, TypeId from, TypeId to);
    Value converted_parts(const Expr& expr, const Value& value, const Type& source, const Type& target);
    Value converted_pairs(const Expr& expr, const Value& pairs, const std::vector<TypeId>& from, const Type& target);
    Value converted_set(const Expr& expr, const Value& value, const Type& source, const Type& target);
    std::vector<TypeId> pair_types(const Type& type);
    Value evaluate_access(const Expr& expr);
    /// Returns the value of the body for each combination of bound values that satisfies the predicate, in order.
    /// Without a body, returns the combinations themselves.
    std::vector<Value> where_satisfied(const Expr& expr);
    static Value only_candidate(const Expr& expr, const std::vector<Value>& candidates);
    static std::size_t true_ones(const std::vector<Value>& values);
    Value evaluate_let(const Expr& expr);
    Value function_call(const Expr& expr);
    Value function_result(const Function& function, const std::vector<Value>& arguments, const Expr& expr);
    Value function_pairs(const Expr& expr);
    bool defined_for_all(const Expr& expr);
    bool has_preconditions(const Expr& expr) const;
    Value toolkit_call(const Expr& expr);
    bool has_type(const Value& value, TypeId from, TypeId to);
    Value evaluate_range(const Expr& expr);

    const Expr& argument_at(const Expr& expr, std::size_t index);
    Value evaluate_operand(const Expr& expr, std::size_t index) { return evaluate_value(argument_at(expr, index)); }
    bool evaluate_truth(const Expr& expr, std::size_t index) { return evaluate_operand(expr, index).number != 0; }
    TypeKind kind(TypeId id) { return id.is_valid() ? system_.type(id).kind : TypeKind::unit; }
    std::vector<Value> evaluate_operands(const Expr& expr);
    /// Runs `body` for every combination of values of the bound variables.
    template <class Body>
    void each_binding(const Expr& expr, std::size_t index, const Body& body) {
        if (index == expr.bound_names.size()) return body();
        if (index >= expr.bound_types.size()) throw_fault(expr, "a bound variable has no type");
        for (const Value& candidate : carrier_values(system_, instantiation_, expr.bound_types[index])) {
            bindings_.emplace_back(expr.bound_names[index], candidate);
            each_binding(expr, index + 1, body);
            bindings_.pop_back();
        }
    }
    Value bound_value(const Expr& expr);

    const System& system_;
    const Instantiation& instantiation_;
    const Machine* machine_;
    const Environment& environment_;
    std::vector<std::pair<std::string, Value>> bindings_;
    int depth_ = 0;  ///< current depth of function calls
    int calls_ = 0;  ///< number of calls of functions that a postcondition defines
};

}  // namespace robochart::ir
