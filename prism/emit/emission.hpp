// SPDX-License-Identifier: Apache-2.0
// The result of the emission, as data.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "prism/syntax/syntax.hpp"

namespace robochart::prism_emit {

/// The PRISM name of an element of the model.
struct NameOf {
    std::string kind;                        ///< "STM", "event", "constant", "variable", "node", "transition"
    std::string element;                     ///< "modUVC::ctrlUVC::stm_ref0::p0"
    std::string name;                        ///< "modUVC_ctrlUVC_stm_ref0_p0"
    std::vector<std::string> literals = {};  ///< for a variable of an enumeration: its values, from 0
};

/// Bounds of a type of numbers.
struct Range {
    std::int64_t low = 0, high = 0;
    bool asked = false;  ///< whether the user has given the range, which is then not widened
    friend bool operator==(const Range&, const Range&) = default;
};

/// RoboTool's preferences of the translation.
struct Preferences {
    Range nat, integer, real;
    prism::ModelKind kind = prism::ModelKind::dtmc;
    std::vector<std::string> ignored = {};  ///< settings of the file that are ignored
    friend bool operator==(const Preferences&, const Preferences&) = default;
};

/// Functions that assertions define, by name: the result for arguments (R16, `pfunction`).
using Functions = std::map<std::string, std::function<prism::ExprPtr(const std::vector<prism::ExprPtr>&)>>;

/// A module of the RoboChart model in PRISM.
struct Emission {
    prism::ModelFile model;
    std::vector<NameOf> names;
};

}  // namespace robochart::prism_emit
