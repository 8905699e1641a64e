// SPDX-License-Identifier: Apache-2.0
// Declares the interface of an encoding of RoboChart as Markov models. An encoding gives names in properties their
// meaning, and makes the model for given values of constants.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "base/diagnostics/diagnostic.hpp"
#include "prism/assertions/properties/elements.hpp"
#include "prism/assertions/properties/question.hpp"
#include "prism/explore/state_space.hpp"

namespace robochart::probability {

/// Translates names of a PRISM model to terms of the RoboChart model.
struct Wording {
    struct Variable {
        std::string begin;                           ///< "M::c::s at ", "M::c::s::x = "
        std::map<std::int32_t, std::string> values;  ///< names of values that are not numbers
    };
    std::map<std::string, Variable> variables;   ///< other variables are internal to the encoding
    std::map<std::string, std::string> actions;  ///< the events
    std::map<std::string, std::string> modules;  ///< the machines
};

/// The input for random paths: a model whose states are not explored.
struct Unexplored {
    const prism::Instance& instance;
    const Wording& wording;
};

class Encoding {
public:
    Encoding() = default;
    virtual ~Encoding() = default;
    Encoding(const Encoding&) = delete;
    Encoding& operator=(const Encoding&) = delete;

    [[nodiscard]] virtual Elements& elements() = 0;
    /// Returns the PRISM constant for the RoboChart constant with this path. Throws NotExpressed.
    [[nodiscard]] virtual prism::Constant prism_constant(const std::string& path) = 0;
    /// Returns the states of the model, extended as the question needs it. `Values` assigns values to the PRISM names
    /// of constants. The result is valid until the next call. Throws NotExpressed, Wrong, prism::EvaluationError,
    /// diagnostics::LimitReached.
    [[nodiscard]] virtual const prism::StateSpace& explore_space(const Question&, const prism::Values&) = 0;
    /// Returns the same model without exploring its states, for random paths. Throws the same exceptions.
    [[nodiscard]] virtual Unexplored unexplored_model(const Question&, const prism::Values&) = 0;
    /// True if every question has a single value. Otherwise a question has two values: the least and the greatest over
    /// all schedulers.
    [[nodiscard]] virtual bool one_value() const = 0;
};

}  // namespace robochart::probability
