// A probabilistic assertion in PRISM's language, as data.
#pragma once

#include <string>
#include <vector>

#include "checker/prism/syntax/syntax.hpp"
#include "frontend/syntax/ast.hpp"

namespace robochart::probability {

/// Values that an assertion gives to a constant, to be tried one after the other.
struct Setting {
    std::string name;                 ///< as written
    std::string path;                 ///< of a constant of the model; "" of an assertion file's
    std::string constant;             ///< of the latter: its name in PRISM
    std::vector<std::string> values;  ///< in PRISM: "0.5"; "1:2:9" is a range with its step
};

/// A property with what it needs beside the model.
struct Question {
    prism::ExprPtr property;
    std::vector<prism::Constant> constants;        ///< open ones that only the property uses
    std::vector<prism::Constant> model_constants;  ///< open ones that rewards and modules use too
    std::vector<prism::RewardStructure> rewards;
    std::vector<prism::Module> modules;
    std::vector<Setting> settings;
    const frontend::Expr* simulation = nullptr;  ///< `using sim with`; null: none
};

}  // namespace robochart::probability
