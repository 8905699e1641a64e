// Text of a C++ expression that knows its outermost operator.
#pragma once

#include <string>

namespace robochart::cpp_emit {

/// How tightly the outermost operator of an expression binds, the loosest first. There is neither a comma operator nor
/// an assignment in generated expressions.
enum class Binding { conditional, disjunction, conjunction, equality, order, sum, product, prefix, primary };

/// It becomes text only for a place that says what it needs, so that nothing is pasted where it would come apart.
class CppExpr {
public:
    /// None: a condition that nothing asks for.
    CppExpr() = default;
    CppExpr(std::string text, Binding binding) : text_(std::move(text)), binding_(binding) {}
    /// A name, a literal, a call, something in parentheses.
    explicit CppExpr(std::string text) : text_(std::move(text)) {}
    /// Whether `operand` is equal to something fixed, or differs from it.
    [[nodiscard]] static CppExpr test(std::string text, std::string operand, bool differs);

    [[nodiscard]] bool empty() const { return text_.empty(); }
    /// Standing alone: an argument, an initial value, what is returned, a condition between parentheses.
    [[nodiscard]] const std::string& whole() const { return text_; }
    /// As an operand where what binds less tightly would come apart: in parentheses if it does.
    [[nodiscard]] std::string operand(Binding least = Binding::primary) const {
        return binding_ < least ? "(" + text_ + ")" : text_;
    }
    /// The same in parentheses.
    [[nodiscard]] CppExpr enclosed() const;

    /// Both conditions; either may be none. Operands that bind less tightly than `least` are in parentheses.
    friend CppExpr conjunction(const CppExpr& first, const CppExpr& second, Binding least);
    friend CppExpr disjunction(const CppExpr& first, const CppExpr& second, Binding least);
    /// `!condition`.
    friend CppExpr negation(const CppExpr& condition);

private:
    /// Conditions joined by `&&`, by `||`, or one that stands alone.
    enum class Joined { alone, all, any };

    /// The test in which a chain of conditions ends.
    struct Last {
        std::string operand;  ///< "" if it ends in something else
        bool differs = false;
        Joined joined = Joined::alone;
    };

    [[nodiscard]] static CppExpr joined(const CppExpr& first, const CppExpr& second, Binding least, Joined how);

    std::string text_;
    Binding binding_ = Binding::primary;
    Last last_;
};

[[nodiscard]] CppExpr conjunction(const CppExpr& first, const CppExpr& second, Binding least = Binding::conjunction);
[[nodiscard]] CppExpr disjunction(const CppExpr& first, const CppExpr& second, Binding least = Binding::disjunction);
[[nodiscard]] CppExpr negation(const CppExpr& condition);

}  // namespace robochart::cpp_emit
