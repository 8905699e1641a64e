// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/expressions/cpp_expr.hpp"

#include <cassert>

namespace robochart::cpp_emit {

CppExpr CppExpr::equality_test(std::string text, std::string operand, bool differs) {
    assert(!text.empty() && !operand.empty());
    CppExpr result(std::move(text), Binding::equality);
    result.last_ = {std::move(operand), differs, Joined::alone};
    return result;
}

CppExpr CppExpr::in_parentheses() const {
    assert(!text_.empty());
    CppExpr result("(" + text_ + ")");
    result.last_ = last_;
    return result;
}

/// Joins conditions. GCC warns if an earlier test makes a later one useless (`a && x == 1 && x == 2`), and no pragma
/// can disable this warning. GCC does not warn if the later test is the result of a function.
CppExpr CppExpr::join_conditions(const CppExpr& first, const CppExpr& second, Binding least, Joined how) {
    assert(how != Joined::alone);
    if (first.empty()) return second;
    if (second.empty()) return first;
    const bool differs = how == Joined::any;
    const auto tests = [&](const CppExpr& condition) {
        return !condition.last_.operand.empty() && condition.last_.differs == differs &&
               (condition.last_.joined == Joined::alone || condition.last_.joined == how);
    };
    const bool excluded = tests(first) && tests(second) && first.last_.operand == second.last_.operand;
    const CppExpr behind = excluded ? CppExpr("robochart::holds(" + second.whole_text() + ")") : second;
    const bool all = how == Joined::all;
    CppExpr result(first.as_operand(least) + (all ? " && " : " || ") + behind.as_operand(least),
                   all ? Binding::conjunction : Binding::disjunction);
    if (tests(second)) result.last_ = {second.last_.operand, differs, how};
    return result;
}

CppExpr conjunction(const CppExpr& first, const CppExpr& second, Binding least) {
    return CppExpr::join_conditions(first, second, least, CppExpr::Joined::all);
}

CppExpr disjunction(const CppExpr& first, const CppExpr& second, Binding least) {
    return CppExpr::join_conditions(first, second, least, CppExpr::Joined::any);
}

CppExpr negation(const CppExpr& condition) {
    assert(!condition.empty());
    CppExpr result("!" + condition.as_operand(), Binding::prefix);
    result.last_ = condition.last_;
    result.last_.differs = !result.last_.differs;
    if (result.last_.joined == CppExpr::Joined::all) {
        result.last_.joined = CppExpr::Joined::any;
    } else if (result.last_.joined == CppExpr::Joined::any) {
        result.last_.joined = CppExpr::Joined::all;
    }
    return result;
}

}  // namespace robochart::cpp_emit
