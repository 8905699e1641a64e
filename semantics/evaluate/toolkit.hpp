// SPDX-License-Identifier: Apache-2.0
// The functions of the toolkit libraries: their names, the types on which they depend, and their values. The libraries
// (frontend/toolkits/library) specify the functions by contract, and csp_emit writes them in CSPM. This file is the
// reference for both.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "semantics/evaluate/evaluate.hpp"

namespace robochart::ir {

/// The type variables of the signature whose carriers the result depends on, as positions in order of first occurrence.
[[nodiscard]] std::vector<std::size_t> toolkit_carriers(const std::string& function);
/// True if the function has a precondition that can be false.
[[nodiscard]] bool toolkit_precondition(const std::string& function);
/// The value of a call such as `set_toolkit_union`; a call that violates the precondition is a fault. `carriers`: the
/// values of the types that toolkit_carriers returns.
[[nodiscard]] Value toolkit_result(const std::string& function, const std::vector<Value>& arguments,
                                   const std::vector<std::vector<Value>>& carriers, diagnostics::Span where);

}  // namespace robochart::ir
