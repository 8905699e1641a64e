// SPDX-License-Identifier: Apache-2.0
// Creates JSON values from containers, optional values and measured numbers.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/diagnostics/json.hpp"

namespace robochart::diagnostics {

/// Returns an array with one value for each item, in the same order. `value_of` maps an item to its value; it is a
/// function or a pointer to a member.
template <class Items, class ValueOf>
[[nodiscard]] Json json_array(const Items& items, const ValueOf& value_of) {
    Json list = Json::array();
    for (const auto& item : items) list.push_back(std::invoke(value_of, item));
    return list;
}

/// Returns an object with one member for each pair of a name and a value.
template <class Pairs>
[[nodiscard]] Json json_object(const Pairs& pairs) {
    Json object = Json::object();
    for (const auto& [name, value] : pairs) object[name] = value;
    return object;
}

/// Returns the value, or null if there is none.
template <class Value>
[[nodiscard]] Json json_or_null(const std::optional<Value>& value) {
    return value ? Json(*value) : Json(nullptr);
}

/// Returns the number with six significant digits, or null if it is infinite or not a number.
[[nodiscard]] Json json_number(double value);

}  // namespace robochart::diagnostics
