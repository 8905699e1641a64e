// SPDX-License-Identifier: Apache-2.0
// Finds the parameters that the functions of a family need. Calls are first written with only those arguments that
// differ from the caller's values. A backward analysis along the calls then finds the live parameters. A variable that
// will be overwritten before it is read, or a clock that will be reset, is not live. Without dead parameters the
// processes are equivalent and have fewer states.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::csp_emit {

/// A function of a family of mutually recursive functions, called as `name(arguments)`, or `name` if it has no
/// parameters.
struct Function {
    std::string name;
    std::vector<std::string> parameters;
    cspm::ExprPtr body;
};

/// The index of each function of a family, by its name.
using FamilyIndex = std::unordered_map<std::string, std::size_t>;  // never iterated
[[nodiscard]] FamilyIndex index_of(const std::vector<Function>& functions);
/// Returns the function of the family that an expression calls, with or without arguments, or null if it calls no
/// function of the family.
[[nodiscard]] const std::size_t* called_function(const FamilyIndex& index, const cspm::Expr& expr);
/// Calls `visit` on the direct parts of an expression.
template <class Visit>
void for_each_part(const cspm::Expr& expr, const Visit& visit) {
    for (const auto& part : expr.args)
        if (part) visit(*part);
    for (const auto& field : expr.fields)
        if (field.value) visit(*field.value);
    for (const auto& clause : expr.clauses)
        if (clause.value) visit(*clause.value);
}

/// Returns the expression with `change` applied to its arguments. If no argument changes, returns the same object.
template <class Change>
[[nodiscard]] cspm::ExprPtr with_parts(const cspm::ExprPtr& expr, const Change& change) {
    std::shared_ptr<cspm::Expr> result;
    for (std::size_t i = 0; i < expr->args.size(); ++i) {
        cspm::ExprPtr part = change(expr->args[i]);
        if (part == expr->args[i]) continue;
        if (!result) result = std::make_shared<cspm::Expr>(*expr);
        result->args[i] = std::move(part);
    }
    return result ? result : expr;
}

/// Arguments by the names of their parameters.
using Arguments = std::vector<std::pair<std::string, cspm::ExprPtr>>;
/// A call within a family that gives only some arguments. The other parameters keep the caller's values.
struct SparseCall {
    std::string function;
    Arguments changed;
    bool after_tock = false;  ///< parameters that count time advance
};

/// The calls within a family whose functions do not have parameters yet, and placeholders for unneeded arguments. Each
/// call is a node of the syntax trees, and the address of the node identifies it.
class FamilyCalls {
public:
    /// Records a call and returns its node.
    [[nodiscard]] cspm::ExprPtr add_call(std::string function, Arguments changed = {}, bool after_tock = false);
    /// Returns the call that the node represents, or null for other nodes.
    [[nodiscard]] const SparseCall* find_call(const cspm::Expr&) const;
    /// Returns the called function if the expression is a call that changes no parameter, or null otherwise.
    [[nodiscard]] const std::string* only_calls(const cspm::Expr&) const;
    /// Changes the target of a call.
    void redirect_call(const cspm::Expr& call, const std::string& function);

    /// Returns the argument for a parameter that is not read after this call returns.
    [[nodiscard]] const cspm::ExprPtr& unneeded_argument() const { return unneeded_; }
    [[nodiscard]] bool is_unneeded(const cspm::ExprPtr& argument) const { return argument == unneeded_; }

private:
    struct Known {
        cspm::ExprPtr node;  ///< owned, so that no other node gets its address
        SparseCall call;
    };
    std::unordered_map<const cspm::Expr*, Known> calls_;  // never iterated
    cspm::ExprPtr unneeded_ = std::make_shared<const cspm::Expr>();
};

/// The possible parameters of the functions of a family.
struct Candidates {
    std::vector<std::string> names;                ///< in the order in which they become parameters
    std::map<std::string, cspm::ExprPtr> ticking;  ///< the value after a tock of each parameter that counts time
    std::vector<std::string> fixed;  ///< parameters that every function gets, even if the function does not read them
    std::vector<std::vector<std::string>> read;  ///< by function: parameters that it needs although its body does not
                                                 ///< read them; may be shorter than the family
    std::string returns;                         ///< the parameter that holds return addresses; may be empty
    /// For a value of `returns`: the function that continues after the call, and the previous value.
    struct Entry {
        std::string behind;
        cspm::ExprPtr outer;
    };
    std::map<const cspm::Expr*, Entry> entries;
};

/// Gives every function its live parameters, and gives every call in `calls`, including those in `initial`, the
/// arguments for them. If a live parameter has no value in `initial`, its name remains free there. Returns these names.
[[nodiscard]] std::vector<std::string> find_parameters(std::vector<Function>& functions, cspm::ExprPtr& initial,
                                                       const FamilyCalls& calls, const Candidates&);
/// Replaces the unneeded arguments of all calls by arbitrary values, given for each parameter.
void fill_unneeded(std::vector<Function>& functions, const FamilyCalls& calls,
                   const std::map<std::string, cspm::ExprPtr>& values);

}  // namespace robochart::csp_emit
