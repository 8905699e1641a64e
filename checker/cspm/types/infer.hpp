// Type inference over a resolved script: Hindley-Milner, one strongly connected group of declarations after the other.
// The scripts' top and modules generalise every name, a let only those with an annotation (as FDR does).
#pragma once

#include <string_view>
#include <vector>

#include "checker/cspm/types/terms.hpp"
#include "checker/cspm/types/unify.hpp"
#include "diagnostics/diagnostic.hpp"

namespace robochart::cspm::types {

class Inference {
public:
    Inference(const ResolvedScript& script, TypeStore& store, diagnostics::Diagnostics& diagnostics)
        : script_(script), store_(store), unifier_(store, here_), diagnostics_(diagnostics) {}

    /// Fills in the schemes of all symbols; findings go to the diagnostics.
    void run();

private:
    using Group = std::vector<Declaration*>;
    enum class ListKind { top, module, let };

    // declarations
    void check_list(DeclarationList& list, ListKind kind);
    void check_group(Group group, ListKind kind);
    void attempt(const Group& group, ListKind kind);
    void check_datatypes_with(const Group& group, ListKind kind);
    void generalise(const Declaration& declaration, ListKind kind);
    void check_fields_known(const Declaration& declaration, ListKind kind);
    void fail_group(const Group& group, TypeFault fault);
    void check(Declaration& declaration);
    void check_function(const Declaration& declaration);
    TypeId equation(const EquationTerm& equation);
    TypeId annotated_equation(const EquationTerm& equation, TypeId signature);
    void check_value(const Declaration& declaration);
    void check_channel(const Declaration& declaration);
    TypeId channel_fields(const Declaration& declaration);
    void check_datatype(const Declaration& declaration);
    void check_subtype(const Declaration& declaration);
    void check_nametype(const Declaration& declaration);
    void check_timed(const Declaration& declaration);
    void check_module(const Declaration& declaration);
    void check_instance(const Declaration& declaration);
    void copy_types(const Declaration& instance, std::vector<std::pair<TypeId, TypeId>> variables);
    void find_comparable(const Declaration& instance);
    void check_assertion(const Declaration& declaration);
    void check_print(const Declaration& declaration);
    TypeId fields(const Term& fields, Constraints constraints);
    TypeId element(TypeId type);
    TypeId annotated(const Annotation& annotation);
    TypeId annotated_type(const TypeTerm& term);

    // expressions
    TypeId infer(const Term& term);
    TypeId infer_value(const Term& term);
    TypeId infer_collection(const Term& term);
    TypeId infer_process(const Term& term);
    TypeId infer_replicated(const Term& term);
    TypeId name(const Term& term);
    TypeId tuple(const Term& term);
    TypeId map(const Term& term);
    TypeId application(const Term& term);
    TypeId lambda(const Term& term);
    TypeId let(const Term& term);
    TypeId conditional(const Term& term);
    TypeId comparison(const Term& term);
    TypeId dotted(const Term& term);
    TypeId prefix(const Term& term);
    TypeId field(const FieldTerm& field);
    TypeId elements(const Term& term, Constraints constraints);
    void range(const Term& term);
    void links(const Term& term);
    void clauses(const std::vector<ClauseTerm>& clauses, TypeKind collection);
    void bind_locals(const std::vector<Symbol*>& symbols);
    TypeId pattern(const PatternTerm& pattern);
    void expect_pattern(const PatternTerm& term, TypeId type);

    TypeId expect(const Term& term, TypeId type, std::string_view because = {});
    void expect_processes(const Term& term, std::size_t count);
    void expect_events(const Term& term, std::size_t index);
    void expect_atom(const Term& term, TypeKind kind, std::string_view because);
    TypeId expect_extendable(const Term& term, TypeId type, std::string_view because);
    TypeId unify(diagnostics::Span span, TypeId expected, TypeId actual, std::string_view because = {});
    void constrain(diagnostics::Span span, Constraint constraint, TypeId type, std::string_view because);
    [[nodiscard]] TypeId atom(TypeKind kind) const { return store_.atom(kind); }

    const ResolvedScript& script_;
    TypeStore& store_;
    diagnostics::Span here_;
    Unifier unifier_;
    diagnostics::Diagnostics& diagnostics_;
    unsigned attempts_ = 0;
};

}  // namespace robochart::cspm::types
