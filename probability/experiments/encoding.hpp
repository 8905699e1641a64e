// An encoding of RoboChart as Markov models: what the names of properties are in them, and the models for values of
// constants.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "checker/prism/explore/state_space.hpp"
#include "diagnostics/diagnostic.hpp"
#include "probability/properties/elements.hpp"
#include "probability/properties/question.hpp"

namespace robochart::probability {

/// What names of a model in PRISM say to a reader of the model of RoboChart.
struct Wording {
    struct Variable {
        std::string begin;                           ///< "M::c::s at ", "M::c::s::x = "
        std::map<std::int32_t, std::string> values;  ///< those that are no numbers
    };
    std::map<std::string, Variable> variables;   ///< others only serve the encoding
    std::map<std::string, std::string> actions;  ///< the events
    std::map<std::string, std::string> modules;  ///< the machines
};

/// What random paths are taken through.
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
    /// A constant of the model of RoboChart, by its path, as one that is given values. Throws NotExpressed.
    [[nodiscard]] virtual prism::Constant constant(const std::string& path) = 0;
    /// The states of the model with what the question adds to it, for values of constants by their names in PRISM.
    /// Valid until the next call. Throws NotExpressed, Wrong, prism::EvaluationError, diagnostics::LimitReached.
    [[nodiscard]] virtual const prism::StateSpace& space(const Question&, const prism::Values&) = 0;
    /// The same, not explored, as what random paths are taken through. Throws as `space`.
    [[nodiscard]] virtual Unexplored unexplored(const Question&, const prism::Values&) = 0;
    /// Whether the value of a question is one number; else the least and the greatest over all schedulers.
    [[nodiscard]] virtual bool one_value() const = 0;
};

}  // namespace robochart::probability
