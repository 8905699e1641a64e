// SPDX-License-Identifier: Apache-2.0
// Formats model files: declarations, machines, statements (private to the formatter). The formatter reads the tokens of
// a text in which the parser has found no errors. A construct that the formatter does not know gets a bad layout, but
// no text is lost.
#pragma once

#include <string_view>

#include "frontend/format/format_expressions.hpp"

namespace robochart::frontend {

/// Formats a model file. The object stores the kind of the last member, which determines whether an empty line follows.
class ModelLayout final : public ExpressionLayout {
public:
    ModelLayout(std::string_view text, const TokenStream& stream) : ExpressionLayout(text, stream, false) {}

private:
    using ModelPart = Doc (ModelLayout::*)(Gap);
    using ExpressionLayout::format_conditional;
    using ExpressionLayout::format_list;
    Doc format_list(Gap gap, ModelPart element) { return format_list(gap, static_cast<Part>(element)); }
    Doc format_conditional(Gap gap, ModelPart branch) { return format_conditional(gap, static_cast<Part>(branch)); }

    // Files, declarations, types (format_declarations.cpp)
    Doc format_member(Gap gap) override;
    Doc format_declaration(Gap gap);
    Doc format_braces(ModelPart part, Gap inside, Gap between);
    Doc format_members(ModelPart part, Gap inside, Gap between);
    Doc format_block(Gap gap);
    Doc format_operation(Gap gap);
    Doc format_enumeration(Gap gap);
    Doc format_record(Gap gap);
    Doc format_literal(Gap gap);
    Doc format_interfaces(Gap gap);
    Doc format_variables(Gap gap);
    Doc format_variable(Gap gap);
    Doc format_event(Gap gap);
    Doc format_signature(Gap gap);
    Doc format_reference(Gap gap);
    Doc format_connection(Gap gap);
    Doc format_contract(Gap gap);
    [[nodiscard]] bool opens_block() const;

    // Machines (format_machines.cpp)
    Doc format_state(Gap gap);
    Doc format_action(Gap gap);
    Doc action_body();
    Doc format_transition(Gap gap);
    Doc format_clauses(Gap gap);
    Doc format_clause(Gap gap, bool trigger_before);
    Doc format_deadline(Gap gap);

    // Statements (format_statements.cpp)
    Doc format_statement(Gap gap);
    Doc format_sequence(Gap gap);
    Doc timed_statement(Gap gap);
    Doc basic_statement(Gap gap);
    Doc format_communication(Gap gap);
    Doc format_predicate();

    bool after_block_ = false;  ///< the last member had a body of several lines
};

}  // namespace robochart::frontend
