// The functions of the toolkit libraries: which there are, what they need to know, and their values. The libraries
// (frontend/toolkits/library) say what they mean by contract; csp_emit writes them in CSPM, here is the reference for
// that.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "semantics/evaluate/evaluate.hpp"

namespace robochart::ir {

/// For functions whose result depends on all values of a type: which of the type variables of the signature (by order
/// of first occurrence) these are.
[[nodiscard]] std::vector<std::size_t> toolkit_carriers(const std::string& function);
/// Whether the function has a precondition that can be false.
[[nodiscard]] bool toolkit_precondition(const std::string& function);
/// The value of `set_toolkit_union` and the like; a fault outside its precondition. `carriers`: the values of the types
/// that toolkit_carriers names.
[[nodiscard]] Value toolkit_result(const std::string& function, const std::vector<Value>& arguments,
                                   const std::vector<std::vector<Value>>& carriers, diagnostics::Span where);

}  // namespace robochart::ir
