// SPDX-License-Identifier: Apache-2.0
// Evaluates the functions of the toolkit libraries, and finds the types on which they depend. The libraries
// (frontend/toolkits/library) specify the functions by contract, and csp_emit writes them in CSPM. This file is the
// reference for both.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "semantics/evaluate/evaluate.hpp"

namespace robochart::ir {

/// Returns the type variables whose carriers affect the result. A type variable gets its number when it first occurs in
/// the signature.
[[nodiscard]] std::vector<std::size_t> toolkit_carriers(const std::string& function);
/// True if the function has a precondition that can be false.
[[nodiscard]] bool toolkit_precondition(const std::string& function);
/// Returns the value of a call such as `set_toolkit_union`. A false precondition is a fault. `carriers` contains the
/// carriers of the types that toolkit_carriers returns.
[[nodiscard]] Value toolkit_result(const std::string& function, const std::vector<Value>& arguments,
                                   const std::vector<std::vector<Value>>& carriers, diagnostics::Span where);

}  // namespace robochart::ir
