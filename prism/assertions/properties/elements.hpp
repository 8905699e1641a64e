// SPDX-License-Identifier: Apache-2.0
// Translates names in probabilistic assertions to elements of the model that decides the assertion. Each encoding of
// RoboChart has its own translation. Paths follow the references of the RoboChart model:
// "Module::controller_ref::machine_ref::x".
#pragma once

#include <stdexcept>
#include <string>

#include "prism/syntax/syntax.hpp"

namespace robochart::probability {

/// Thrown if an element of a property has no counterpart in the encoding. The message contains the element.
class NotExpressed : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Thrown if the model, or a property of it, is wrong. The message contains the reason.
class Wrong : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Finds the counterparts of elements. Every function throws NotExpressed if an element has no counterpart.
class Elements {
public:
    Elements() = default;
    virtual ~Elements() = default;
    Elements(const Elements&) = delete;
    Elements& operator=(const Elements&) = delete;

    [[nodiscard]] virtual prism::ExprPtr variable_expression(const std::string& path) = 0;
    [[nodiscard]] virtual prism::ExprPtr constant_expression(const std::string& path) = 0;
    /// Returns the condition that a machine is in a state. The state is given by its path from the top of the machine:
    /// "Composite::Inner".
    [[nodiscard]] virtual prism::ExprPtr in_state(const std::string& machine, const std::string& state) = 0;
    /// Returns the action of the steps with this event; `direction` is "in" or "out", as seen from the component.
    [[nodiscard]] virtual std::string event_action(const std::string& path, const std::string& direction) = 0;
    /// Returns the last value that the event carried.
    [[nodiscard]] virtual prism::ExprPtr event_value(const std::string& path, const std::string& direction) = 0;
    /// Returns a state reward, adapted to this encoding.
    [[nodiscard]] virtual prism::RewardItem of_state(prism::RewardItem item) { return item; }
    /// True if an element of the model already has this name in PRISM.
    [[nodiscard]] virtual bool is_name_taken(const std::string& name) const = 0;
};

}  // namespace robochart::probability
