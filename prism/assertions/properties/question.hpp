// SPDX-License-Identifier: Apache-2.0
// Declares a probabilistic assertion in PRISM's language, as data.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "prism/syntax/syntax.hpp"

namespace robochart::probability {

/// The values that an assertion gives to a constant, to be tried one after another.
struct Setting {
    std::string name;                 ///< as written
    std::string path;                 ///< the path of a constant of the model; "" for a constant of an assertion file
    std::string constant;             ///< the PRISM name of a constant of an assertion file
    std::vector<std::string> values;  ///< the values in PRISM: "0.5"; "1:2:9" is a range with its step
};

/// A requested random path. Its members `steps`, `repeats` and `limit` are names of constants in Question::constants.
struct Generation {
    std::string steps;    ///< number of steps; "": until a deadlock
    std::string repeats;  ///< number of further attempts if a path reaches no deadlock; "": none
    std::string limit;    ///< the largest number of steps of a path; "": the default
};

/// `using sim with`
struct Sampling {
    std::string method;  ///< a name for prism::read_method: "ci"
    /// The parameters of the method, such as "width", each with the name of the constant (in Question::constants) that
    /// contains its value.
    std::vector<std::pair<std::string, std::string>> parameters;
};

/// A property, with everything that must be added to the model to decide it.
struct Question {
    prism::ExprPtr property;  ///< null: a path is requested
    std::optional<Generation> path = {};
    std::vector<prism::Constant> constants;        ///< open constants used only by the property, and numbers of `using`
    std::vector<prism::Constant> model_constants;  ///< open constants that rewards and modules also use
    std::vector<prism::RewardStructure> rewards;
    std::vector<prism::Module> modules;
    std::vector<Setting> settings;
    std::optional<Sampling> simulation = {};
};

}  // namespace robochart::probability
