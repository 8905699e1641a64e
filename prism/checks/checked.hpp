// SPDX-License-Identifier: Apache-2.0
// Declares models and properties without static errors, as data. Names are declared, types are correct, formulas are
// expanded, renamed modules are written out, and the composition is a list of synchronisations.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "prism/syntax/syntax.hpp"

namespace robochart::prism {

/// The commands of one module that have the same action ("": no action).
struct ActionOfModule {
    std::size_t module = 0;
    std::string action;
    friend bool operator==(const ActionOfModule&, const ActionOfModule&) = default;
};

/// A synchronisation consists of one enabled command of each part. `action` is its visible name ("": none).
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
    std::vector<Module> modules;      ///< their variables are in `variables`
    std::vector<Synchronisation> synchronisations;
    std::vector<RewardStructure> rewards;
    ExprPtr initial;   ///< null: one initial state
    ExprPtr left_out;  ///< true in states in which the encoding omits a step of the original model; null: no step is
                       ///< omitted
};

struct CheckedProperties {
    std::vector<Constant> constants;
    std::vector<Definition> labels;
    std::vector<Property> properties;
    std::vector<Type> types;  ///< by property; for `filter(range)` the type of its elements
};

}  // namespace robochart::prism
