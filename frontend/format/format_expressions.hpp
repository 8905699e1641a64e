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

    static constexpr int value_level = concat_level + 2;  ///< after `!` and `.`: tighter than every operator, so none
                                                          ///< is read
    Doc expression(Gap gap);
    /// Operators that bind at least as tightly as `level`, and their operands.
    Doc operand(Gap gap, int level);
    /// `if c then a else b end`, as a statement or an expression.
    Doc conditional(Gap gap, Part branch);

    /// A bracketed list separated by `,` or `;`: on one line, or one element a line.
    Doc list(Gap gap, Part element);
    /// `a : T`
    Doc typed(Gap gap);
    Doc type(Gap gap);
    /// `(p : @x = e)`
    Doc update(Gap gap);

    bool probabilistic_ = false;  ///< in a probabilistic assertion, where expressions have more forms

private:
    Doc prefix(int level);
    Doc chain(Doc left, int level);
    Doc infix(int level);
    Doc binder(int level);
    Doc bindings(Gap gap);
    Doc binding(Gap gap);
    Doc negation();
    Doc postfix();
    Doc atom();
    Doc sequence_element(Gap gap);
    Doc sequence_with_set();
    Doc set_element(Gap gap);
    Doc field(Gap gap);
    [[nodiscard]] int operator_level() const;
    [[nodiscard]] bool at_step() const;

    // Forms of probabilistic assertions (format_probability.cpp)
    [[nodiscard]] bool at_probabilistic_form() const;
    Doc probabilistic_form();
    Doc path_prefix();
    Doc step_bound();
    Doc quantitative();
    Doc reward_path(Gap gap);
    Doc simulation();
    Doc assigned(Gap gap);
    Doc behind_name(Doc name);

    Doc elements(Gap first, Part element);
    Doc atomic_type(Gap gap);
    Doc type_or_size(Gap gap);

    bool is_assertions_;
};

}  // namespace robochart::frontend
