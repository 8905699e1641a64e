// SPDX-License-Identifier: Apache-2.0
// Declares the result of the emission, as data.
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
    std::vector<std::string> literals = {};  ///< the values of a variable whose type is an enumeration, from 0
};

/// The bounds of a numeric type.
struct Range {
    std::int64_t low = 0, high = 0;
    bool asked = false;  ///< whether the user has given the range; such a range is not widened
    friend bool operator==(const Range&, const Range&) = default;
};

/// RoboTool's preferences for the translation.
struct Preferences {
    Range nat, integer, real;
    prism::ModelKind kind = prism::ModelKind::dtmc;
    std::vector<std::string> ignored = {};  ///< settings of the file that are ignored
    friend bool operator==(const Preferences&, const Preferences&) = default;
};

/// The functions that assertions define, by name. Each computes the result for given arguments (R16, `pfunction`).
using Functions = std::map<std::string, std::function<prism::ExprPtr(const std::vector<prism::ExprPtr>&)>>;

/// The PRISM encoding of a RoboChart module.
struct Emission {
    prism::ModelFile model;
    std::vector<NameOf> names;
};

}  // namespace robochart::prism_emit
