// SPDX-License-Identifier: Apache-2.0
// The layout of model files: declarations, machines, statements (private to the formatter). The formatter reads the
// tokens again after the parser has found no mistakes. Constructs that are missing here would be laid out badly, but
// not lost.
#pragma once

#include <string_view>

#include "frontend/format/format_expressions.hpp"

namespace robochart::frontend {

/// Holds the kind of the last member, which decides about empty lines.
class ModelLayout final : public ExpressionLayout {
public:
    ModelLayout(std::string_view text, const TokenStream& stream) : ExpressionLayout(text, stream, false) {}

private:
    using ModelPart = Doc (ModelLayout::*)(Gap);
    using ExpressionLayout::conditional;
    using ExpressionLayout::list;
    Doc list(Gap gap, ModelPart element) { return list(gap, static_cast<Part>(element)); }
    Doc conditional(Gap gap, ModelPart branch) { return conditional(gap, static_cast<Part>(branch)); }

    // Files, declarations, types (format_declarations.cpp)
    Doc member(Gap gap) override;
    Doc declaration(Gap gap);
    Doc braces(ModelPart part, Gap inside, Gap between);
    Doc members(ModelPart part, Gap inside, Gap between);
    Doc block(Gap gap);
    Doc operation(Gap gap);
    Doc enumeration(Gap gap);
    Doc record(Gap gap);
    Doc literal(Gap gap);
    Doc interfaces(Gap gap);
    Doc variables(Gap gap);
    Doc variable(Gap gap);
    Doc event(Gap gap);
    Doc signature(Gap gap);
    Doc reference(Gap gap);
    Doc connection(Gap gap);
    Doc contract(Gap gap);
    [[nodiscard]] bool opens_block() const;

    // Machines (format_machines.cpp)
    Doc state(Gap gap);
    Doc action(Gap gap);
    Doc action_body();
    Doc transition(Gap gap);
    Doc clauses(Gap gap);
    Doc clause(Gap gap, bool trigger_before);
    Doc deadline(Gap gap);

    // Statements (format_statements.cpp)
    Doc statement(Gap gap);
    Doc sequence(Gap gap);
    Doc timed_statement(Gap gap);
    Doc basic_statement(Gap gap);
    Doc communication(Gap gap);
    Doc predicate();

    bool after_block_ = false;  ///< the last member had a body of several lines
};

}  // namespace robochart::frontend
