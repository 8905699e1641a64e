// SPDX-License-Identifier: Apache-2.0
// Resolves names and computes types inside types, expressions, statements and communications (private to the front
// end). Every method fills the `target` and `type` fields that it visits, and reports errors. An expression with an
// error gets no type, and rules ignore expressions without a type.
#pragma once

#include <string>
#include <vector>

#include "frontend/names/name_lookup.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/types/type_algebra.hpp"

namespace robochart::frontend {

/// The declarations that are visible to an expression.
struct Surroundings {
    Place place;
    const Scope* scope = nullptr;          ///< the scope of the machine, operation or interface; null at file level
    const Function* function = nullptr;    ///< the function whose `result` and parameters are in scope
    const Machine* machine = nullptr;      ///< the machine whose states `sinceEntry` may name
    std::vector<const Variable*> bound;    ///< variables of enclosing binders, innermost last
    const Registers* registers = nullptr;  ///< the registers that `$` names; null outside of RoboSim machines
};

class Typer {
public:
    explicit Typer(Finder& finder) : finder_(finder) {}

    // Types (type_reader.cpp)
    TypePtr assign_type(TypeExpr& written, Surroundings& around);
    /// Returns the type of a type declaration.
    [[nodiscard]] TypePtr declared_type(const TypeDeclaration& declaration) const;

    // Expressions (typer.cpp, typer_names.cpp, typer_operators.cpp, typer_binders.cpp, typer_calls.cpp)
    TypePtr assign_type(Expr& expr, Surroundings& around);
    TypePtr assign_type(const ExprPtr& expr, Surroundings& around) {
        return expr ? assign_type(*expr, around) : nullptr;
    }
    /// Computes the type of an expression, and reports an error if it is not boolean. The message begins with `what`.
    void check_boolean(const ExprPtr& expr, Surroundings& around, const std::string& what);

    // Statements (typer_statements.cpp)
    void check_statement(Stmt& statement, Surroundings& around);
    void check_communication(Communication& communication, Surroundings& around, bool is_trigger);
    const Clock* find_clock(const QualifiedName& name, Surroundings& around, const diagnostics::Rule& rule);

private:
    TypePtr compute_type(Expr& expr, Surroundings& around);
    TypePtr type_all(Expr& expr, Surroundings& around, TypeForm collection);
    void size(Expr& expr, Surroundings& around, long& value);
    TypePtr named_type(TypeExpr& written, Surroundings& around);

    TypePtr name(Expr& expr, Surroundings& around);
    TypePtr bare_function(const Expr& expr, const Function& function);
    TypePtr type_since(Expr& expr, Surroundings& around);
    TypePtr since_entry(Expr& expr, Surroundings& around);
    const Declaration* value_named(const QualifiedName& name, Surroundings& around);
    void unknown_value(const QualifiedName& name, Surroundings& around);

    TypePtr type_unary(Expr& expr, Surroundings& around);
    TypePtr type_binary(Expr& expr, Surroundings& around);
    diagnostics::Diagnostic& report_mismatch(const Expr& expr, const TypePtr& left, const TypePtr& right);
    TypePtr reject_mismatch(const Expr& expr, const TypePtr& left, const TypePtr& right);
    TypePtr type_logical(Expr& expr, const TypePtr& left, const TypePtr& right);
    TypePtr type_comparison(Expr& expr, const TypePtr& left, const TypePtr& right);
    TypePtr type_membership(Expr& expr, const TypePtr& left, const TypePtr& right);
    TypePtr type_arithmetic(Expr& expr, const TypePtr& left, const TypePtr& right);
    TypePtr type_concatenation(Expr& expr, const TypePtr& left, const TypePtr& right);

    TypePtr type_conditional(Expr& expr, Surroundings& around);
    TypePtr type_binder(Expr& expr, Surroundings& around);
    TypePtr bound_body(Expr& expr, Surroundings& around, const TypePtr& variables);
    TypePtr type_let(Expr& expr, Surroundings& around);
    TypePtr type_cast(Expr& expr, Surroundings& around);
    TypePtr type_elements(Expr& expr, Surroundings& around);
    TypePtr type_range(Expr& expr, Surroundings& around);
    void check_indices(const Expr& expr);
    TypePtr type_matrix(Expr& expr, Surroundings& around);

    TypePtr check_call(Expr& expr, Surroundings& around);
    TypePtr call_function(Expr& expr, const Function& function, const std::vector<TypePtr>& args);
    TypePtr call_literal(Expr& expr, const EnumLiteral& literal, const std::vector<TypePtr>& args);
    TypePtr apply(Expr& expr, const TypePtr& function, const std::vector<TypePtr>& args, const std::string& name);
    TypePtr type_member(Expr& expr, Surroundings& around);
    TypePtr type_index(Expr& expr, Surroundings& around);
    TypePtr tuple_part(Expr& expr, const TypePtr& tuple);
    TypePtr type_record(Expr& expr, Surroundings& around);

    // RoboSim (typer_registers.cpp)
    TypePtr type_register(Expr& expr, Surroundings& around);
    TypePtr read_register(Expr& expr, Surroundings& around);
    TypePtr written_register(Expr& expr, Surroundings& around);
    void check_store(Expr& expr, Surroundings& around);
    void unknown_register(const QualifiedName& name, Span whole, bool written, Surroundings& around);
    const Event* output_event(const Communication& communication, Surroundings& around);
    bool find_output_operation(Stmt& statement, Surroundings& around);

    void check_assignment(Stmt& statement, Surroundings& around);
    bool resets_clock(const Stmt& statement, const Expr& named, std::string_view what, Surroundings& around);
    void check_call(Stmt& statement, Surroundings& around);
    void unknown_operation(const Stmt& statement, Surroundings& around);
    void check_wait(const ExprPtr& duration, Surroundings& around);
    const Event* find_event(Communication& communication, Surroundings& around);
    void unknown_event(const Communication& communication, Surroundings& around);
    void check_communicated(Communication& communication, const Event& event, Surroundings& around);
    void check_received(const Communication& communication, const Event& event);
    const Variable* stored_into(const QualifiedName& name, Surroundings& around);

    /// Describes why a member of a component was not found.
    struct Missing {
        bool reported = false;               ///< the name was already reported, or its target cannot be known
        const Context* interface = nullptr;  ///< interface that declares the member but has no clause in the component
    };
    Missing find_missing(std::string_view name, DeclKind kind, const Surroundings& around);
    void note_missing(const Missing& missing, std::string_view clause, std::string_view name,
                      diagnostics::Diagnostic& finding) const;

    Finder& finder_;
    const Expr* written_ = nullptr;  ///< the register that the assignment in progress writes
};

/// Removes parentheses around an expression.
[[nodiscard]] const Expr& strip_parentheses(const Expr& expr);
/// Returns the plural ending for n items, as in "1 argument" and "2 arguments".
[[nodiscard]] std::string plural(std::size_t n);

}  // namespace robochart::frontend
