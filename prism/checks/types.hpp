// SPDX-License-Identifier: Apache-2.0
// Types of expressions of models and properties.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "prism/syntax/syntax.hpp"
#include "base/diagnostics/diagnostic.hpp"

namespace robochart::prism {

/// The meaning of names, and the allowed kinds of expressions.
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
    /// Known types of properties by name.
    std::map<std::string, std::optional<Type>, std::less<>> named;
};

/// Determines the types of trees in a scope. If a tree has a type error, the error is reported, and the tree has no
/// type.
class TypeChecker {
public:
    TypeChecker(const Scope& scope, diagnostics::Diagnostics& diagnostics) : scope_(scope), diagnostics_(diagnostics) {}

    std::optional<Type> type(const ExprPtr& expr) { return type(expr, false); }
    /// Reports an error if the type differs; an int is accepted as a double. Null is accepted.
    void expect(const ExprPtr& expr, Type wanted, bool constant = false, const char* what = "");

private:
    using Result = std::optional<Type>;

    /// `path`: whether path formulas are allowed.
    Result type(const ExprPtr& expr, bool path);
    Result computed(const Expr& expr, bool path);
    Result name(const Expr& expr);
    Result label(const Expr& expr);
    Result conditional(const Expr& expr);
    Result logical(const Expr& expr, bool path);
    Result equality(const Expr& expr);
    Result comparison(const Expr& expr);
    Result arithmetic(const Expr& expr);
    Result call(const Expr& expr);
    Result query(const Expr& expr);
    Result reward(const Expr& expr);
    Result filter(const Expr& expr);
    Result path_operator(const Expr& expr);
    bool operand(const ExprPtr& expr, Type wanted, bool path = false);
    /// All operands must be numbers; the result is int if all are int.
    Result numbers(const std::vector<ExprPtr>& parts);
    Result wrong(const Expr& expr, const std::string& wanted, Type found);
    void constant(const ExprPtr& expr, const char* what);

    const Scope& scope_;
    diagnostics::Diagnostics& diagnostics_;
    std::unordered_map<const Expr*, Result> known_[2];  ///< index 0: where path formulas are not allowed; index 1:
                                                        ///< where they are
};

}  // namespace robochart::prism
