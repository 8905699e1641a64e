// SPDX-License-Identifier: Apache-2.0
// Unifies types by FDR's rules for dotted types. If a value is expected, a dotted value takes as many arguments as its
// head can take ("longest match"). If an extendable is expected, it takes as few arguments as possible ("shortest
// match").
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "checker/cspm/types/type.hpp"

namespace robochart::cspm::types {

/// A type error as an exception. The code that checks the enclosing declaration catches it.
struct TypeFault {
    const diagnostics::Rule* rule = nullptr;
    std::vector<std::string> arguments;
    std::vector<diagnostics::Note> notes;
    diagnostics::Span span;
};

class Unifier {
public:
    /// `here` is where findings are reported. The caller changes it for each part that it checks.
    Unifier(TypeStore& store, const diagnostics::Span& here) : store_(store), here_(here) {}

    /// Makes both types equal and returns the result. Throws TypeFault if they cannot be equal.
    TypeId unify(TypeId expected, TypeId actual);
    /// Unifies the types of a pattern and its argument. The pattern must not split a dotted value of the argument.
    TypeId unify_one_way(TypeId expected, TypeId actual);
    /// Makes a type satisfy a constraint. Throws TypeFault if this is impossible.
    void constrain(Constraint constraint, TypeId type);
    void constrain_all(Constraints constraints, TypeId type);
    /// Applies every head of a dotted type inside `type` to the following parts.
    TypeId evaluate_dots(TypeId type);

    TypeId instantiate(const Scheme& scheme);
    /// Returns a copy of a type in which some variables and datatypes are replaced. Both lists must be sorted.
    TypeId copy_type(TypeId type, const std::vector<std::pair<TypeId, TypeId>>& variables,
                     const std::vector<std::pair<std::uint32_t, std::uint32_t>>& datatypes);

private:
    enum class Match { shortest, longest };
    using Parts = std::vector<TypeId>;

    TypeId unify_heads(TypeId a, TypeId b);
    TypeId unify_variables(TypeId a, TypeId b);
    TypeId unify_variable(TypeId variable, TypeId type);
    TypeId unify_arguments(TypeId a, TypeId b);
    TypeId unify_dotables(TypeId a, TypeId b);
    TypeId unify_dots(TypeId a, TypeId b);
    TypeId unify_dot_with(TypeId dot, TypeId other, bool dot_expected);
    TypeId unify_extendable(TypeId a, TypeId b);
    void set_arguments(TypeId variable, TypeId arguments);
    TypeId substitute(TypeId variable, TypeId type);
    Parts evaluate(Parts parts, Match match);
    Parts combine(Parts a, Parts b);
    Parts take_left(Parts a, const Parts& b);
    Parts take_right(const Parts& a, Parts b);
    TypeId result_type(TypeId type);
    TypeId one_by_one(TypeId dotable);
    [[nodiscard]] bool has_kind(TypeId type, TypeKind kind) { return store_.kind(type) == kind; }
    void constrain_variable(Constraint constraint, TypeId variable);
    bool constrain_parts(Constraint constraint, TypeId type);
    [[noreturn]] void mismatch();
    [[nodiscard]] TypeFault make_fault(TypeWriter& writer, TypeId expected, TypeId actual);
    TypeId type_to_display(TypeId type);
    [[noreturn]] void fail_constraint(Constraint constraint, TypeId type);

    TypeStore& store_;
    const diagnostics::Span& here_;
    std::vector<std::pair<TypeId, TypeId>> pairs_;  // pairs (expected, actual) being unified, outermost first
    std::vector<TypeId> constrained_;               // types being constrained, outermost first
    bool one_way_ = false;
    bool failing_ = false;
};

}  // namespace robochart::cspm::types
