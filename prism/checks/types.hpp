// SPDX-License-Identifier: Apache-2.0
// Checks the types of expressions in models and properties.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "prism/syntax/syntax.hpp"

namespace robochart::prism {

/// The types of names at some place in the text, and the kinds of expressions that are allowed there.
struct Scope {
    struct Symbol {
        Type type = Type::integer;
        bool variable = false;
    };
    ModelKind kind = ModelKind::mdp;
    std::map<std::string, Symbol, std::less<>> symbols;
    bool properties = false;                    ///< queries and labels are allowed
    std::set<std::string, std::less<>> labels;  ///< with "deadlock" and "init"
    std::vector<std::string> rewards;           ///< names, "" if a structure has none
    /// The known types of properties, by name.
    std::map<std::string, std::optional<Type>, std::less<>> named;
};

/// Determines the types of trees in a scope. If a tree has a type error, the error is reported, and the tree has no
/// type.
class TypeChecker {
public:
    TypeChecker(const Scope& scope, diagnostics::Diagnostics& diagnostics) : scope_(scope), diagnostics_(diagnostics) {}

    std::optional<Type> type(const ExprPtr& expr) { return type(expr, false); }
    /// Reports an error if the type differs; an int is accepted as a double. Null is accepted.
    void expect_type(const ExprPtr& expr, Type expected, bool constant = false, const char* what = "");

private:
    using Result = std::optional<Type>;

    /// Determines the type of an expression. `path`: whether path formulas are allowed.
    Result type(const ExprPtr& expr, bool path);
    Result compute_type(const Expr& expr, bool path);
    Result type_of_name(const Expr& expr);
    Result type_of_label(const Expr& expr);
    Result type_of_conditional(const Expr& expr);
    Result type_of_logical(const Expr& expr, bool path);
    Result type_of_equality(const Expr& expr);
    Result type_of_comparison(const Expr& expr);
    Result type_of_arithmetic(const Expr& expr);
    Result type_of_call(const Expr& expr);
    Result type_of_query(const Expr& expr);
    Result type_of_reward(const Expr& expr);
    Result type_of_filter(const Expr& expr);
    Result type_of_path_operator(const Expr& expr);
    bool check_operand(const ExprPtr& expr, Type expected, bool path = false);
    /// Determines the type of an operation on numbers: int if all operands are int. Reports operands that are no
    /// numbers.
    Result type_of_numbers(const std::vector<ExprPtr>& parts);
    Result report_wrong_type(const Expr& expr, const std::string& expected, Type found);
    void check_constant(const ExprPtr& expr, const char* what);

    const Scope& scope_;
    diagnostics::Diagnostics& diagnostics_;
    std::unordered_map<const Expr*, Result> known_[2];  ///< index 0: where path formulas are not allowed; index 1:
                                                        ///< where they are
};

}  // namespace robochart::prism
