// Values as the checker prints them, in the notation of the model.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runs/run.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::runs {

/// Splits at `separator` outside brackets and texts in quotes.
[[nodiscard]] std::vector<std::string> split(std::string_view text, std::string_view separator);
[[nodiscard]] std::string_view trim(std::string_view text);

/// A value of the type: reals in decimals instead of units of 1/scale, literals without the name of their type, parts
/// likewise. What is not in that form stays as it is.
[[nodiscard]] std::string value_text(const ir::System&, const ir::Instantiation&, ir::TypeId, std::string_view text);
/// The values behind the dots of an event: `types` says how many dots belong to one of them.
[[nodiscard]] std::vector<Value> values_of_event(const ir::System&, const ir::Instantiation&,
                                                 const std::vector<ir::TypeId>& types, std::string_view text);

}  // namespace robochart::runs
