// SPDX-License-Identifier: Apache-2.0
// Collects how a model uses the values of each flow class. Private to this component.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "semantics/data/kept_data.hpp"
#include "semantics/data/places.hpp"
#include "semantics/data/sampling.hpp"

namespace robochart::ir {

/// A condition that depends only on the value of one place.
struct Condition {
    const Expr* expr = nullptr;
    MachineId machine;
    ExprPtr body;  ///< the condition with calls replaced by the bodies of functions
};

/// A value that is stored or sent, other than a copy of a place.
struct Written {
    const Expr* expr = nullptr;  ///< null: the default value of the type
    MachineId machine;
    bool closed = false;      ///< the expression has the same value in all contexts
    bool initial = false;     ///< the initial value of a variable
    std::set<PlaceId> reads;  ///< if not closed: the flow classes from which it is computed
};

/// The uses of one flow class.
struct Uses {
    std::vector<Condition> conditions;
    std::vector<Written> writes;
    /// For every transition that receives a value of the class: its condition on the value. Null if the transition
    /// accepts every value.
    std::vector<const Expr*> entries;
    std::optional<Keep> needs_values;  ///< a use that needs the values themselves, if any; the first one found
};

/// How the class model represents computed values.
enum class Computed {
    exactly,  ///< computed values keep their carriers if a condition reads them
    freely,   ///< computed values may belong to any class, or be undefined
};

/// Collects the uses of all flow classes. Wherever the model copies a value, unites the flow classes of the two places
/// in `places`.
[[nodiscard]] std::map<PlaceId, Uses> collect_uses(const System& system, const Sampling& sampling, Places& places,
                                                   Computed computed = Computed::exactly);

}  // namespace robochart::ir
