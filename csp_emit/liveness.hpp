// Drops parameters whose values cannot matter any more: a variable that will be overwritten before it is read, a clock
// that will be reset. The processes stay the same, their states become fewer.
#pragma once

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

/// Removes dead parameters from the functions and the arguments for them from all calls, in `initial` too.
void drop_dead_parameters(std::vector<Function>& functions, cspm::ExprPtr& initial);

}  // namespace robochart::csp_emit
