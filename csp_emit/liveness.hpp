// Drops parameters whose values cannot matter any more: a variable that will be overwritten before it is read, a clock
// that will be reset. The processes stay the same, their states become fewer.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "checker/cspm/syntax.hpp"

namespace robochart::csp_emit {

/// One of a family of mutually recursive functions, called `name(arguments)`, or `name` if it has no parameters.
struct Function {
    std::string name;
    std::vector<std::string> parameters;
    cspm::ExprPtr body;
};

/// Where each function of a family stands, by its name.
using FamilyIndex = std::map<std::string, std::size_t>;
[[nodiscard]] FamilyIndex index_of(const std::vector<Function>& functions);
/// The function that an expression calls, with arguments or without, if it is one of the family; else null.
[[nodiscard]] const std::size_t* called(const FamilyIndex& index, const cspm::Expr& expr);
/// Calls `visit` on the direct parts of an expression.
void for_each_part(const cspm::Expr& expr, const std::function<void(const cspm::Expr&)>& visit);

/// Removes dead parameters from the functions and the arguments for them from all calls, in `initial` too.
void drop_dead_parameters(std::vector<Function>& functions, cspm::ExprPtr& initial);

}  // namespace robochart::csp_emit
