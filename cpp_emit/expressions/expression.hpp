// SPDX-License-Identifier: Apache-2.0
// Writes expressions of the model as C++ text over the Types policy.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/expressions/cpp_expr.hpp"
#include "cpp_emit/expressions/generation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Returns the struct member for the number in ExprKind::member, which is the index of a field, or a position counted
/// from 1.
[[nodiscard]] std::string member_name(const ir::Type&, std::int64_t number);

/// Returns the parameters of the functions of a unit: its frame f, and the frames of other units whose variables or
/// clocks it uses.
[[nodiscard]] std::string frame_parameters(const Component&, const Unit&);
/// Returns the arguments with which functions of a unit call each other: "f", "f, TurnFrame_f".
[[nodiscard]] std::string frame_arguments(const Component&, const Unit&);
/// Returns the arguments with which a function of `caller` calls the unit's functions. `frame` is the expression for
/// the unit's frame in this function.
[[nodiscard]] std::string frame_arguments(const Component&, const Unit&, const Unit& caller, const std::string& frame);
/// Returns the name of the parameter for the frame of a unit whose variables or clocks an operation uses.
[[nodiscard]] std::string lent_frame(const Unit& owner);

class ExpressionWriter {
public:
    /// Writes expressions inside the unit's own functions.
    ExpressionWriter(const Generation& generation, const Unit& unit) : ExpressionWriter(generation, unit, unit, "f") {}
    /// Writes the unit's expressions inside a function of `caller`. `frame` is the expression for the unit's frame in
    /// this function, for example "f.Turn".
    ExpressionWriter(const Generation& generation, const Unit& unit, const Unit& caller, std::string frame)
        : generation_(generation), unit_(unit), caller_(caller), frame_(std::move(frame)) {}

    /// Sets the C++ text of `trigger_value`, the incoming value.
    void set_incoming(std::string text) { incoming_ = std::move(text); }

    /// Returns the expression. Every list that the code builds passes through `Cycle::fit`. So if a list is cut, the
    /// step always returns StepResult::capacity.
    [[nodiscard]] CppExpr cpp_expression(const ir::Expr&) const;
    /// Returns the expression, converted to a numeric type; unchanged for other types.
    [[nodiscard]] CppExpr expression_as(const ir::Expr&, ir::TypeId) const;
    /// Returns the text as a complete expression: an argument, an initial value, a condition inside parentheses.
    [[nodiscard]] std::string write(const ir::Expr& expr) const { return cpp_expression(expr).whole_text(); }
    [[nodiscard]] std::string write_as(const ir::Expr& expr, ir::TypeId type) const {
        return expression_as(expr, type).whole_text();
    }
    /// Returns the text as an operand of any operator, in parentheses unless it has the highest precedence.
    [[nodiscard]] std::string write_operand(const ir::Expr& expr) const { return cpp_expression(expr).as_operand(); }
    /// Returns the condition that all called functions have true preconditions, innermost calls first (semantics 3.5).
    /// The code must test it before it evaluates the expression. Empty if no precondition can be false.
    [[nodiscard]] CppExpr precondition_test(const ir::Expr&) const;
    /// Returns the condition after its preconditions. It is false if the code cannot build a list that the condition
    /// needs.
    [[nodiscard]] CppExpr expression_asked(const ir::Expr& condition) const;
    /// Returns the member that stores a variable; "" for shared variables that are never read.
    [[nodiscard]] std::string register_text(const EventUse&, ir::VariableId) const;
    [[nodiscard]] std::string variable_member(ir::VariableId) const;
    [[nodiscard]] std::string clock_member(ir::ClockId) const;
    /// Returns the index of an item, counted from 1.
    [[nodiscard]] std::string item_index(const ir::Expr& index) const;

private:
    [[nodiscard]] CppExpr of_kind(const ir::Expr&) const;  ///< empty for a kind that C++ cannot express
    /// Returns the value. If it contains lists, the items beyond their capacity are removed (Cycle::fit).
    [[nodiscard]] std::string fitting(ir::TypeId, const std::string& value) const;
    [[nodiscard]] std::string pair_text(const ir::Type& whole, const ir::Expr& pair) const;
    [[nodiscard]] std::string operand_as(const ir::Expr&, ir::TypeKind) const;
    /// Writes arithmetic on two operands. For reals, uses the operator. For whole numbers, uses the function with this
    /// name, which is also defined at the limits of the type.
    [[nodiscard]] CppExpr write_arithmetic(const ir::Expr&, const char* symbol, const char* name, Binding) const;
    [[nodiscard]] CppExpr write_negation(const ir::Expr&) const;
    [[nodiscard]] std::string write_function(const ir::Expr&, const char* name) const;
    [[nodiscard]] CppExpr write_comparison(const ir::Expr&, const char* symbol, Binding) const;
    [[nodiscard]] CppExpr comparison_text(const ir::Expr&, const char* symbol, const std::string& left,
                                          const std::string& right, Binding) const;
    [[nodiscard]] std::string constant_text(const ir::Expr&) const;
    [[nodiscard]] std::string enum_literal(const ir::Expr&) const;
    [[nodiscard]] std::string argument_list(const ir::Expr&, const std::vector<ir::TypeId>& types) const;
    [[nodiscard]] std::string built_value(const ir::Expr&, const char* maker) const;
    [[nodiscard]] std::string write_cast(const ir::Expr&) const;
    [[nodiscard]] std::string write_call(const ir::Expr&) const;
    [[nodiscard]] std::string write_let(const ir::Expr&) const;
    [[nodiscard]] ir::TypeKind kind_of(const ir::Expr&) const;
    [[nodiscard]] std::string type_text(ir::TypeId) const;
    [[nodiscard]] std::string write_index(const ir::Expr&) const;
    [[nodiscard]] std::string write_membership(const ir::Expr&) const;

    // expression_conditions.cpp: preconditions of functions
    [[nodiscard]] std::vector<CppExpr> preconditions(const ir::Expr&) const;
    [[nodiscard]] std::vector<CppExpr> bound_preconditions(const ir::Expr&) const;
    /// Returns the text inside the first `count` names that the `let` binds.
    [[nodiscard]] std::string bound_by_let(const ir::Expr&, std::size_t count, std::string text) const;

    // expression_composed.cpp: binders, functions as values, toolkits, vectors and matrices
    [[nodiscard]] std::string write_any(const ir::Expr&, std::size_t from, const std::string& visit) const;
    [[nodiscard]] CppExpr write_quantifier(const ir::Expr&) const;
    [[nodiscard]] std::string write_collection(const ir::Expr&) const;
    [[nodiscard]] std::string collected_item(const ir::Expr&) const;
    [[nodiscard]] std::string bound_values(const ir::Expr&, ir::TypeId) const;
    [[nodiscard]] std::string write_application(const ir::Expr&) const;
    [[nodiscard]] std::string write_lookup(const ir::Expr& function, const std::vector<std::string>& arguments,
                                           ir::TypeId domain) const;
    [[nodiscard]] std::string beta_reduced(const ir::Expr& lambda, const std::vector<std::string>& arguments) const;
    [[nodiscard]] std::string platform_call(ir::FunctionId, const std::string& arguments) const;
    [[nodiscard]] const FunctionHook& hook_of(ir::FunctionId) const;
    [[nodiscard]] std::string call_arguments(const ir::Expr&) const;
    [[nodiscard]] std::string function_value(const ir::Expr&) const;
    [[nodiscard]] std::string write_toolkit_call(const ir::Expr&) const;
    [[nodiscard]] std::string write_range(const ir::Expr&) const;
    [[nodiscard]] std::string is_type(const ir::Expr&) const;
    [[nodiscard]] bool block_arithmetic(const ir::Expr&) const;
    [[nodiscard]] std::string block_operand(const ir::Expr&, ir::TypeId entry) const;
    [[nodiscard]] CppExpr block_arithmetic_text(const ir::Expr&) const;

    // expression_views.cpp: collections that are visited in place
    [[nodiscard]] CppExpr write_fold(const ir::Expr&) const;
    [[nodiscard]] CppExpr fold_of_toolkit(const ir::Expr&) const;
    [[nodiscard]] CppExpr membership_in_view(const ir::Expr&) const;
    [[nodiscard]] CppExpr view_has_elements(const ir::Expr& view) const;
    [[nodiscard]] std::string write_view(const ir::Expr&) const;
    [[nodiscard]] std::string view_of_interval(const ir::Expr&) const;
    [[nodiscard]] std::string view_of_comprehension(const ir::Expr&) const;
    [[nodiscard]] CppExpr predicate_of(const ir::Expr& binder) const;

    [[nodiscard]] std::string frame_of(const Unit& owner) const;

    const Generation& generation_;
    const Unit& unit_;
    const Unit& caller_;  ///< the unit whose function contains the text
    std::string frame_;
    std::string incoming_;
};

/// Writes `pre_f(n)` and similar functions of Step, which test preconditions.
void write_preconditions(const Generation&, CodeWriter&);

}  // namespace robochart::cpp_emit
