// SPDX-License-Identifier: Apache-2.0
// Converts values that the checker has printed to the notation of the model.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "counterexample/run.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::runs {

/// Splits a text at `separator`, except inside brackets and quoted texts.
[[nodiscard]] std::vector<std::string> split_outside_brackets(std::string_view text, std::string_view separator);
[[nodiscard]] std::string_view trim_blanks(std::string_view text);

/// Returns the text of a value for people: reals are decimals instead of units of 1/scale, and literals do not contain
/// the name of their type. The parts of the value are converted in the same way. Text in another form is returned
/// unchanged.
[[nodiscard]] std::string value_text(const ir::System&, const ir::Instantiation&, ir::TypeId, std::string_view text);
/// Returns the values after the dots of an event. `types` determines how many dots belong to each value.
[[nodiscard]] std::vector<Value> values_of_event(const ir::System&, const ir::Instantiation&,
                                                 const std::vector<ir::TypeId>& types, std::string_view text);

}  // namespace robochart::runs
