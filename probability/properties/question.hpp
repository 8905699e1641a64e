// A probabilistic assertion in PRISM's language, as data.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "checker/prism/syntax/syntax.hpp"

namespace robochart::probability {

/// Values that an assertion gives to a constant, to be tried one after the other.
struct Setting {
    std::string name;                 ///< as written
    std::string path;                 ///< of a constant of the model; "" of an assertion file's
    std::string constant;             ///< of the latter: its name in PRISM
    std::vector<std::string> values;  ///< in PRISM: "0.5"; "1:2:9" is a range with its step
};

/// A random path that is asked for. Its numbers are constants among Question::constants, by their names.
struct Generation {
    std::string steps;    ///< how many; "": up to a deadlock
    std::string repeats;  ///< how many other paths are tried where one comes to no deadlock; "": none
    std::string limit;    ///< how many steps a path may have; "": as many as there are usually
};

/// `using sim with`
struct Sampling {
    std::string method;  ///< as prism::read_method reads it: "ci"
    /// Its parameters, "width", and the constants among Question::constants that hold their values.
    std::vector<std::pair<std::string, std::string>> parameters;
};

/// A property with what it needs beside the model.
struct Question {
    prism::ExprPtr property;  ///< null: a path is asked for
    std::optional<Generation> path = {};
    std::vector<prism::Constant> constants;        ///< open ones that only the property uses, and numbers of `using`
    std::vector<prism::Constant> model_constants;  ///< open ones that rewards and modules use too
    std::vector<prism::RewardStructure> rewards;
    std::vector<prism::Module> modules;
    std::vector<Setting> settings;
    std::optional<Sampling> simulation = {};
};

}  // namespace robochart::probability
