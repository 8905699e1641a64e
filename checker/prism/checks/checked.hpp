// Models and properties without static errors, as data: names are declared, types fit, formulas are expanded, renamed
// modules are written out, the composition is a list of what acts together.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "checker/prism/syntax/syntax.hpp"

namespace robochart::prism {

/// Commands of one module with one action ("": none).
struct ActionOfModule {
    std::size_t module = 0;
    std::string action;
    friend bool operator==(const ActionOfModule&, const ActionOfModule&) = default;
};

/// What acts together: one enabled command of each part. Seen from outside as `action` ("": none).
struct Synchronisation {
    std::string action;
    std::vector<ActionOfModule> parts;
};

struct CheckedModel {
    ModelKind kind = ModelKind::mdp;
    std::vector<Constant> constants;
    std::vector<Definition> formulas;  ///< expanded
    std::vector<Definition> labels;
    std::vector<Variable> variables;  ///< the global ones first, then module by module
    std::vector<Module> modules;      ///< their variables are among `variables`
    std::vector<Synchronisation> synchronisations;
    std::vector<RewardStructure> rewards;
    ExprPtr initial;   ///< null: one initial state
    ExprPtr left_out;  ///< where a step of the model that was meant is left out; null: nowhere
};

struct CheckedProperties {
    std::vector<Constant> constants;
    std::vector<Definition> labels;
    std::vector<Property> properties;
    std::vector<Type> types;  ///< of each property; of `filter(range)` that of its elements
};

}  // namespace robochart::prism
