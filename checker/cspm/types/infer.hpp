// SPDX-License-Identifier: Apache-2.0
// Infers the types of a resolved script by Hindley-Milner inference. Infers one group of mutually dependent
// declarations after the other. Generalises the types of all names at the top level and in modules. In a `let`,
// generalises only the types of names with an annotation, as FDR does.
#pragma once

#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "checker/cspm/types/expression_types.hpp"
#include "checker/cspm/types/terms.hpp"

namespace robochart::cspm::types {

/// Infers the types of declarations. Owns the object that infers the types of expressions.
class Inference {
public:
    /// All arguments must outlive this object.
    Inference(const ResolvedScript& script, TypeStore& store, diagnostics::Diagnostics& diagnostics)
        : script_(script),
          store_(store),
          diagnostics_(diagnostics),
          terms_(store, diagnostics, [this](DeclarationList& list) { check_list(list, ListKind::let); }),
          unifier_(terms_.unifier()) {}

    /// Sets the scheme of every symbol. Reports findings to the diagnostics.
    void run();

private:
    using Group = std::vector<Declaration*>;
    enum class ListKind { top, module, let };

    void check_list(DeclarationList& list, ListKind kind);
    void check_group(Group group, ListKind kind);
    void try_group(const Group& group, ListKind kind);
    void check_datatypes_with(const Group& group, ListKind kind);
    void generalise(const Declaration& declaration, ListKind kind);
    void check_fields_known(const Declaration& declaration, ListKind kind);
    void fail_group(const Group& group, TypeFault fault);
    void check_declaration(Declaration& declaration);
    void check_function(const Declaration& declaration);
    TypeId infer_equation(const EquationTerm& equation);
    TypeId check_annotated_equation(const EquationTerm& equation, TypeId signature);
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
    TypeId infer_fields(const Term& fields, Constraints constraints);
    TypeId element_type(TypeId type);
    TypeId bind_annotation(const Annotation& annotation);
    TypeId annotated_type(const TypeTerm& term);

    const ResolvedScript& script_;
    TypeStore& store_;
    diagnostics::Diagnostics& diagnostics_;
    ExpressionTypes terms_;
    Unifier& unifier_;  // the unifier of terms_
    unsigned attempts_ = 0;
};

}  // namespace robochart::cspm::types
