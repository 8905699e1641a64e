// SPDX-License-Identifier: Apache-2.0
// The layout of expressions, types and lists, which models and assertion files share (private to the formatter).
#pragma once

#include <string_view>

#include "frontend/format/format_gaps.hpp"
#include "frontend/syntax/operators.hpp"

namespace robochart::frontend {

/// Holds the kind of file that the expressions are in.
class ExpressionLayout : public WordLayout {
protected:
    using Part = Doc (ExpressionLayout::*)(Gap);

    ExpressionLayout(std::string_view text, const TokenStream& stream, bool is_assertions)
        : WordLayout(text, stream), is_assertions_(is_assertions) {}
    ~ExpressionLayout() = default;

    /// After `!` and `.`: above the levels of all operators, so no operator is read.
    static constexpr int value_level = concat_level + 2;
    Doc format_expression(Gap gap);
    /// Operators that bind at least as tightly as `level`, and their operands.
    Doc format_operand(Gap gap, int level);
    /// `if c then a else b end`, as a statement or an expression.
    Doc format_conditional(Gap gap, Part branch);

    /// A bracketed list separated by `,` or `;`. It is on one line, or has one element per line.
    Doc format_list(Gap gap, Part element);
    /// `a : T`
    Doc format_typed(Gap gap);
    Doc format_type(Gap gap);
    /// `cycleDef e` of RoboSim
    Doc format_cycle(Gap gap);
    /// `input context { uses I event e : T }` of RoboSim, on one line if it fits.
    Doc format_registers(Gap gap);
    /// `(p : @x = e)`
    Doc format_update(Gap gap);

    bool probabilistic_ = false;  ///< true in a probabilistic assertion, in which expressions have more forms

private:
    Doc format_prefix(int level);
    Doc format_chain(Doc left, int level);
    Doc format_infix(int level);
    Doc format_binder(int level);
    Doc format_bindings(Gap gap);
    Doc format_binding(Gap gap);
    Doc format_negation();
    Doc format_postfix();
    Doc format_atom();
    Doc format_register();
    Doc register_member(Gap gap);
    Doc sequence_element(Gap gap);
    Doc sequence_with_set();
    Doc set_element(Gap gap);
    Doc format_field(Gap gap);
    [[nodiscard]] int operator_level() const;
    [[nodiscard]] bool at_step() const;

    // Forms of probabilistic assertions (format_probability.cpp)
    [[nodiscard]] bool at_probabilistic_form() const;
    Doc probabilistic_form();
    Doc path_prefix();
    Doc step_bound();
    Doc format_quantitative();
    Doc reward_path(Gap gap);
    Doc format_simulation();
    Doc format_assigned(Gap gap);
    Doc behind_name(Doc name);

    Doc format_elements(Gap first, Part element);
    Doc atomic_type(Gap gap);
    Doc type_or_size(Gap gap);

    bool is_assertions_;
};

}  // namespace robochart::frontend
