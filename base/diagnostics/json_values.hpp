// SPDX-License-Identifier: Apache-2.0
// JSON values of containers, optional values and measured numbers.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/diagnostics/json.hpp"

namespace robochart::diagnostics {

/// An array with one value for each item, in the same order. `value_of` maps an item to its value; it is a function or
/// a pointer to a member.
template <class Items, class ValueOf>
[[nodiscard]] Json json_array(const Items& items, const ValueOf& value_of) {
    Json list = Json::array();
    for (const auto& item : items) list.push_back(std::invoke(value_of, item));
    return list;
}

/// An object with one member for each pair of a name and a value.
template <class Pairs>
[[nodiscard]] Json json_object(const Pairs& pairs) {
    Json object = Json::object();
    for (const auto& [name, value] : pairs) object[name] = value;
    return object;
}

/// The value; null if there is none.
template <class Value>
[[nodiscard]] Json json_or_null(const std::optional<Value>& value) {
    return value ? Json(*value) : Json(nullptr);
}

/// The number with six significant digits; null if it is infinite or not a number.
[[nodiscard]] Json json_number(double value);

}  // namespace robochart::diagnostics
