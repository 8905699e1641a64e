// SPDX-License-Identifier: Apache-2.0
// Replaces names in trees: formulas by their definitions, names by other names.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <unordered_map>

#include "prism/syntax/syntax.hpp"

namespace robochart::prism {

/// Replaces names. Equal parts of a tree stay shared.
class Rewriter {
public:
    /// Names that are replaced by expressions.
    std::map<std::string, ExprPtr, std::less<>> expressions;
    /// Functions that are renamed.
    std::map<std::string, std::string, std::less<>> functions;

    /// Returns the tree with all names replaced, or null for null.
    [[nodiscard]] ExprPtr operator()(const ExprPtr& expr);

private:
    [[nodiscard]] ExprPtr rewrite_expression(const ExprPtr& expr);
    std::unordered_map<const Expr*, ExprPtr> done_;  ///< results of the current call
};

/// Calls `visit` with every name in a tree, once for each shared part.
void for_each_name(const ExprPtr& expr, const std::function<void(const Expr&)>& visit);

}  // namespace robochart::prism
