// SPDX-License-Identifier: Apache-2.0
// Lists the elements of a component that messages carry. Private to this component.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cpp_emit/api/class_api.hpp"
#include "cpp_emit/ros2/mapping.hpp"
#include "cpp_emit/ros2/model_values.hpp"

namespace robochart::cpp_emit::ros2 {

/// An operation, event or variable at the component's boundary, in one direction.
struct Element {
    ElementKind kind = ElementKind::operation;
    bool published = false;
    std::string name;
    const ApiOperation* operation = nullptr;
    const ApiEvent* event = nullptr;
    const ApiVariable* variable = nullptr;
    diagnostics::Span span;
    const Item* item = nullptr;  ///< the item for the element in the mapping
    const Deadline* deadline = nullptr;

    [[nodiscard]] bool is_mapped() const { return item != nullptr || deadline != nullptr; }
};

/// Returns all elements, in the order of the classes.
[[nodiscard]] std::vector<Element> elements_of(const Generation&, const ClassApi&);
/// Returns the type of the value of an event or a variable.
[[nodiscard]] std::optional<ir::TypeId> type_of(const Element&);
/// Returns the parameters of an operation, or the value of an event or variable.
[[nodiscard]] std::vector<ModelValue> values_of(const Element&);

}  // namespace robochart::cpp_emit::ros2
