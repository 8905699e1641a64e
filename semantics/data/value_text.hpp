// SPDX-License-Identifier: Apache-2.0
// Writes values as text for reports. Private to this component.
#pragma once

#include <cstdint>
#include <string>

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Returns the value in the notation of RoboChart, for types without strings, functions, relations and matrices.
/// Consecutive equal elements of a sequence are written once, with their number: `<30 times 0.5, 1>`.
[[nodiscard]] std::string value_text(const System& system, std::int64_t scale, TypeId type, const Value& value);

}  // namespace robochart::ir
