// What the names of probabilistic assertions stand for in the model that answers them. Each encoding of RoboChart has
// its own: paths are those of the model of RoboChart, through references: "Module::controller_ref::machine_ref::x".
#pragma once

#include <stdexcept>
#include <string>

#include "checker/prism/syntax/syntax.hpp"

namespace robochart::probability {

/// Something that a property speaks of has no counterpart in the encoding; the message says what.
class NotExpressed : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The model, or the property in it, is wrong; the message says what.
class Wrong : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The counterparts of elements. All throw NotExpressed where there is none.
class Elements {
public:
    Elements() = default;
    virtual ~Elements() = default;
    Elements(const Elements&) = delete;
    Elements& operator=(const Elements&) = delete;

    [[nodiscard]] virtual prism::ExprPtr variable(const std::string& path) = 0;
    [[nodiscard]] virtual prism::ExprPtr constant(const std::string& path) = 0;
    /// Whether a machine is in a state, given by its path from the top of the machine: "Composite::Inner".
    [[nodiscard]] virtual prism::ExprPtr in_state(const std::string& machine, const std::string& state) = 0;
    /// The action of the steps that are the event, `direction` "in" or "out" as the component sees it.
    [[nodiscard]] virtual std::string action(const std::string& path, const std::string& direction) = 0;
    /// The value that it carried last.
    [[nodiscard]] virtual prism::ExprPtr value(const std::string& path, const std::string& direction) = 0;
    /// A reward of states, as it counts in this encoding.
    [[nodiscard]] virtual prism::RewardItem of_state(prism::RewardItem item) { return item; }
    /// Whether something of the model has this name in PRISM already.
    [[nodiscard]] virtual bool taken(const std::string& name) const = 0;
};

}  // namespace robochart::probability
