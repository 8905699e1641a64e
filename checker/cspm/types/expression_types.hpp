// SPDX-License-Identifier: Apache-2.0
// Infers the types of expressions and patterns. Determines where findings about them are reported.
#pragma once

#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "checker/cspm/types/terms.hpp"
#include "checker/cspm/types/unify.hpp"

namespace robochart::cspm::types {

/// Infers types. Owns the unifier and the place at which the unifier's findings are reported. Throws TypeFault for an
/// ill-typed expression, and TypeOverflow if a type becomes too large.
class ExpressionTypes {
public:
    /// A function that checks the declarations of a let. It is called before the body is checked.
    using CheckLet = std::function<void(DeclarationList&)>;

    /// The store and the diagnostics must outlive this object. It uses the diagnostics only to poll the budget.
    ExpressionTypes(TypeStore& store, diagnostics::Diagnostics& diagnostics, CheckLet check_let)
        : store_(store), unifier_(store, here_), diagnostics_(diagnostics), check_let_(std::move(check_let)) {}
    ExpressionTypes(const ExpressionTypes&) = delete;
    ExpressionTypes& operator=(const ExpressionTypes&) = delete;

    [[nodiscard]] Unifier& unifier() { return unifier_; }
    /// Returns the place where the unifier's findings are reported.
    [[nodiscard]] diagnostics::Span current_span() const { return here_; }
    void set_span(diagnostics::Span span) { here_ = span; }

    TypeId infer(const Term& term);
    /// Returns the type of the values that the pattern matches. bind_locals must have given its variables types.
    TypeId infer_pattern(const PatternTerm& pattern);
    /// Gives each variable a new type.
    void bind_locals(const std::vector<Symbol*>& symbols);

    // Requires a type. If the term has another type, reports a finding at this term or span; `because` becomes its
    // note.
    TypeId expect_type(const Term& term, TypeId type, std::string_view because = {});
    /// Requires a type of this kind. Reports an error at the branch or the body of a let that causes it, and not at the
    /// whole expression.
    void expect_atom(const Term& term, TypeKind kind, std::string_view because);
    TypeId unify(diagnostics::Span span, TypeId expected, TypeId actual, std::string_view because = {});
    void constrain(diagnostics::Span span, Constraint constraint, TypeId type, std::string_view because);

private:
    TypeId infer_value(const Term& term);
    TypeId infer_collection(const Term& term);
    TypeId infer_process(const Term& term);
    TypeId infer_replicated(const Term& term);
    TypeId infer_name(const Term& term);
    TypeId infer_tuple(const Term& term);
    TypeId infer_map(const Term& term);
    TypeId infer_application(const Term& term);
    TypeId infer_lambda(const Term& term);
    TypeId infer_let(const Term& term);
    TypeId infer_conditional(const Term& term);
    TypeId infer_comparison(const Term& term);
    TypeId infer_dot(const Term& term);
    TypeId infer_prefix(const Term& term);
    TypeId infer_field(const FieldTerm& field);
    TypeId infer_elements(const Term& term, Constraints constraints);
    void check_range(const Term& term);
    void check_links(const Term& term);
    void check_clauses(const std::vector<ClauseTerm>& clauses, TypeKind collection);
    void expect_pattern(const PatternTerm& term, TypeId type);
    void expect_processes(const Term& term, std::size_t count);
    void expect_events(const Term& term, std::size_t index);
    TypeId expect_extendable(const Term& term, TypeId type, std::string_view because);
    [[nodiscard]] TypeId atom(TypeKind kind) const { return store_.atom(kind); }

    TypeStore& store_;
    diagnostics::Span here_;
    Unifier unifier_;
    diagnostics::Diagnostics& diagnostics_;
    CheckLet check_let_;
};

}  // namespace robochart::cspm::types
