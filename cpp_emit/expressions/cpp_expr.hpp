// SPDX-License-Identifier: Apache-2.0
// Stores the text of a C++ expression and the precedence of its outermost operator.
#pragma once

#include <string>

namespace robochart::cpp_emit {

/// The precedences of the outermost operator of an expression, lowest first. Generated expressions contain no comma
/// operator and no assignment.
enum class Binding { conditional, disjunction, conjunction, equality, order, sum, product, prefix, primary };

/// A C++ expression. Its text can be read only for a given precedence, so parentheses are added wherever they are
/// necessary.
class CppExpr {
public:
    /// Makes an empty condition, which is always true.
    CppExpr() = default;
    CppExpr(std::string text, Binding binding) : text_(std::move(text)), binding_(binding) {}
    /// Makes an expression from a name, a literal, a call, or an expression in parentheses.
    explicit CppExpr(std::string text) : text_(std::move(text)) {}
    /// Makes a test whether `operand` equals a constant or, with `differs`, differs from it.
    [[nodiscard]] static CppExpr equality_test(std::string text, std::string operand, bool differs);

    [[nodiscard]] bool empty() const { return text_.empty(); }
    /// Returns the text as a complete expression: an argument, an initial value, a returned value, or a condition
    /// inside parentheses.
    [[nodiscard]] const std::string& whole_text() const { return text_; }
    /// Returns the text as an operand, in parentheses if its precedence is lower than `least`.
    [[nodiscard]] std::string as_operand(Binding least = Binding::primary) const {
        return binding_ < least ? "(" + text_ + ")" : text_;
    }
    /// Returns the expression in parentheses.
    [[nodiscard]] CppExpr in_parentheses() const;

    /// Returns the conjunction. Either condition may be empty. Operands with a lower precedence than `least` get
    /// parentheses.
    friend CppExpr conjunction(const CppExpr& first, const CppExpr& second, Binding least);
    friend CppExpr disjunction(const CppExpr& first, const CppExpr& second, Binding least);
    /// Returns `!condition`.
    friend CppExpr negation(const CppExpr& condition);

private:
    /// What joins the parts of the expression: nothing (a single condition), `&&`, or `||`.
    enum class Joined { alone, all, any };

    /// The last test of a chain of conditions.
    struct Last {
        std::string operand;  ///< "" if the chain does not end in a test
        bool differs = false;
        Joined joined = Joined::alone;
    };

    [[nodiscard]] static CppExpr join_conditions(const CppExpr& first, const CppExpr& second, Binding least,
                                                 Joined how);

    std::string text_;
    Binding binding_ = Binding::primary;
    Last last_;
};

[[nodiscard]] CppExpr conjunction(const CppExpr& first, const CppExpr& second, Binding least = Binding::conjunction);
[[nodiscard]] CppExpr disjunction(const CppExpr& first, const CppExpr& second, Binding least = Binding::disjunction);
[[nodiscard]] CppExpr negation(const CppExpr& condition);

}  // namespace robochart::cpp_emit
