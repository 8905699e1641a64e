// An encoding of RoboChart as Markov models: what the names of properties are in them, and the models for values of
// constants.
#pragma once

#include <stdexcept>
#include <string>

#include "checker/prism/explore/state_space.hpp"
#include "diagnostics/diagnostic.hpp"
#include "probability/properties/elements.hpp"
#include "probability/properties/question.hpp"

namespace robochart::probability {

/// The model, or the property in it, is wrong; the message says what.
class Wrong : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

class Encoding {
public:
    Encoding() = default;
    virtual ~Encoding() = default;
    Encoding(const Encoding&) = delete;
    Encoding& operator=(const Encoding&) = delete;

    [[nodiscard]] virtual Elements& elements() = 0;
    /// A constant of the model of RoboChart, by its path, as one that is given values. Throws NotExpressed.
    [[nodiscard]] virtual prism::Constant constant(const std::string& path) = 0;
    /// The states of the model with what the question adds to it, for values of constants by their names in PRISM.
    /// Valid until the next call. Throws NotExpressed, Wrong, prism::EvaluationError, diagnostics::LimitReached.
    [[nodiscard]] virtual const prism::StateSpace& space(const Question&, const prism::Values&) = 0;
    /// Whether the value of a question is one number; else the least and the greatest over all schedulers.
    [[nodiscard]] virtual bool one_value() const = 0;
};

}  // namespace robochart::probability
