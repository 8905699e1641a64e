// Expressions: names to indices, mixed number types made explicit, negated literals folded. Private to
// semantics/lower*.
#pragma once

#include "semantics/lower/lowering.hpp"

namespace robochart::ir {

/// What names stand for where an expression is written.
struct Names {
    ByDeclaration<VariableId> variables;
    ByDeclaration<ConstantId> constants;
    ByDeclaration<EventId> events;
    ByDeclaration<ClockId> clocks;
    ByDeclaration<OperationId> operations;
    ByDeclaration<NodeId> nodes;
    Machine* machine = nullptr;                               ///< gets the clocks of sinceEntry; null outside machines
    const frontend::Declaration* trigger_variable = nullptr;  ///< replaced by trigger_value: we are in its guard
    TypeId result;                                            ///< of the function whose postcondition we are in
};

/// The expression as the IR has it. With an `expected` type, a number of a narrower type becomes one of that type:
/// literals are retyped, whole numbers used as reals are cast. Never null; after an error some literal.
[[nodiscard]] ExprPtr lower_expression(Lowering&, const Names&, const frontend::Expr&, TypeId expected = {});
/// The expression as one of the type: retyped literal, cast, or itself.
[[nodiscard]] ExprPtr coerce(Lowering&, const ExprPtr&, TypeId);

/// The id of a function that the model declares, its signature and conditions lowered at its first use. Functions for
/// all types (`?X`) are reported here; the id is invalid then.
[[nodiscard]] FunctionId lower_function(Lowering&, const frontend::Function&, diagnostics::Span where);

/// Whether type variables (`?X`) occur in the signature.
[[nodiscard]] bool is_generic(const frontend::Function&);
/// The id of a function for all types, used for these types; none, and a report, where it is used for too many.
[[nodiscard]] FunctionId lower_instance(Lowering&, const frontend::Function&, const std::vector<TypeId>& parameters,
                                        TypeId result, std::map<std::string, TypeId> variables,
                                        diagnostics::Span where);

[[nodiscard]] ExprPtr make_boolean(bool, diagnostics::Span);
/// Null operands stand for true.
[[nodiscard]] ExprPtr make_conjunction(const ExprPtr&, const ExprPtr&);
[[nodiscard]] ExprPtr make_negation(const ExprPtr&);
/// Whether since or sinceEntry occurs in it.
[[nodiscard]] bool mentions_time(const ExprPtr&);
/// Whether the value of the trigger occurs in it.
[[nodiscard]] bool mentions_trigger_value(const ExprPtr&);

}  // namespace robochart::ir
