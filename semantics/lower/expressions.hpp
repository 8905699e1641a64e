// SPDX-License-Identifier: Apache-2.0
// Lowers expressions: names become indices, conversions between number types become explicit, and a negated literal
// becomes one literal. Private to semantics/lower*.
#pragma once

#include "semantics/lower/lowering.hpp"

namespace robochart::ir {

/// The meanings of the names in an expression.
struct Names {
    ByDeclaration<VariableId> variables;
    ByDeclaration<ConstantId> constants;
    ByDeclaration<EventId> events;
    ByDeclaration<ClockId> clocks;
    ByDeclaration<OperationId> operations;
    ByDeclaration<NodeId> nodes;
    Machine* machine = nullptr;  ///< receives the clocks of sinceEntry; null outside machines
    const frontend::Declaration* trigger_variable = nullptr;  ///< the variable that trigger_value replaces in a guard
    TypeId result;                                            ///< the type of the function's result in a postcondition
    // RoboSim
    ByDeclaration<std::size_t> inputs;               ///< events and variables of the input context: Machine::inputs
    ByDeclaration<VariableId> registers;             ///< variables of the contexts
    ByDeclaration<OperationId> platform_operations;  ///< operations of the output context
    std::vector<StmtPtr>* stores = nullptr;          ///< receives the assignments of `$e?v`; null outside conditions
};

/// Returns the expression in the IR. With an `expected` type, a number of a narrower type is converted to it: literals
/// get the type, and other whole numbers that are used as reals are cast. The result is never null. After an error, it
/// is some literal.
[[nodiscard]] ExprPtr lower_expression(Lowering&, const Names&, const frontend::Expr&, TypeId expected = {});
/// Returns the expression converted to the type: a literal of this type, a cast, or the expression itself.
[[nodiscard]] ExprPtr coerce_to_type(Lowering&, const ExprPtr&, TypeId);

/// Returns the id of a function that the model declares. Its signature and conditions are lowered at its first use. A
/// generic function (`?X`) is reported, and its id is invalid.
[[nodiscard]] FunctionId lower_function(Lowering&, const frontend::Function&, diagnostics::Span where);

/// True if type variables (`?X`) occur in the signature.
[[nodiscard]] bool is_generic(const frontend::Function&);
/// Returns the id of a generic function, instantiated for these types. If it is used for too many types, this is
/// reported and the id is invalid.
[[nodiscard]] FunctionId lower_instance(Lowering&, const frontend::Function&, const std::vector<TypeId>& parameters,
                                        TypeId result, std::map<std::string, TypeId> variables,
                                        diagnostics::Span where);

[[nodiscard]] ExprPtr make_boolean(bool, diagnostics::Span);
/// Returns the conjunction. A null operand means true.
[[nodiscard]] ExprPtr make_conjunction(const ExprPtr&, const ExprPtr&);
[[nodiscard]] ExprPtr make_negation(const ExprPtr&);
/// True if since or sinceEntry occurs in the expression.
[[nodiscard]] bool mentions_time(const ExprPtr&);
/// True if the value of the trigger occurs in the expression.
[[nodiscard]] bool mentions_trigger_value(const ExprPtr&);

}  // namespace robochart::ir
