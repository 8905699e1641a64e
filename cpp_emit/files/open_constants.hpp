// SPDX-License-Identifier: Apache-2.0
// Finds the constants of a component whose values come from options of the generator and not from the model. Generated
// code contains these values, so logs and parameters name them.
#pragma once

#include <string>
#include <vector>

#include "cpp_emit/expressions/generation.hpp"

namespace robochart::cpp_emit {

/// A constant whose value is not in the model, or is replaced by an option.
struct OpenConstant {
    std::string path;  ///< path in the model: "M::C::S::SPEED"
    ir::TypeId type;
    ir::Value value;
    std::string literal;  ///< the value as RoboChart text, as for `--const`
};

/// Returns the open constants of the component's machines that an option can set: truth values, numbers, and literals
/// without arguments. They are ordered by their names in CSP.
[[nodiscard]] std::vector<OpenConstant> open_constants(const Generation&);

}  // namespace robochart::cpp_emit
