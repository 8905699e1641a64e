// SPDX-License-Identifier: Apache-2.0
// Formats expressions, types and lists, which occur in models and in assertion files (private to the formatter).
#pragma once

#include <string_view>

#include "frontend/format/format_gaps.hpp"
#include "frontend/syntax/operators.hpp"

namespace robochart::frontend {

/// Formats expressions. The object stores the kind of the file that contains them.
class ExpressionLayout : public WordLayout {
protected:
    using Part = Doc (ExpressionLayout::*)(Gap);

    ExpressionLayout(std::string_view text, const TokenStream& stream, bool is_assertions)
        : WordLayout(text, stream), is_assertions_(is_assertions) {}
    ~ExpressionLayout() = default;

    /// The level for values after `!` and `.`. It is above the levels of all operators, so no operator is read.
    static constexpr int value_level = concat_level + 2;
    Doc format_expression(Gap gap);
    /// Formats operators that bind at least as tightly as `level`, and their operands.
    Doc format_operand(Gap gap, int level);
    /// Formats `if c then a else b end`, a statement or an expression.
    Doc format_conditional(Gap gap, Part branch);

    /// Formats a list in brackets, separated by `,` or `;`. It is written on one line, or with one element per line.
    Doc format_list(Gap gap, Part element);
    /// Formats `a : T`.
    Doc format_typed(Gap gap);
    Doc format_type(Gap gap);
    /// Formats `cycleDef e` of RoboSim.
    Doc format_cycle(Gap gap);
    /// Formats `input context { uses I event e : T }` of RoboSim, on one line if it fits.
    Doc format_registers(Gap gap);
    /// Formats `(p : @x = e)`.
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
