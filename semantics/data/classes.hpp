// SPDX-License-Identifier: Apache-2.0
// Divides the values of flow classes into classes that no condition can tell apart. Private to this component.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "semantics/data/uses.hpp"

namespace robochart::ir {

/// The classes of values of one flow class. Values are in units of the sampling scale.
struct ValueClasses {
    /// A value of each class. The first class contains the default value of the type.
    std::vector<Value> witnesses;
    /// The class of each value that the model writes.
    std::map<Value, std::size_t> of_value;
    /// For each condition, whether it is true for the values of each class.
    std::map<const Expr*, std::vector<bool>> answers;
    bool all_values = false;      ///< the classes together contain all values of the type; otherwise, those that occur
    bool nothing_tested = false;  ///< no condition reads the values; the last class stands for any value
    bool exact_outputs = false;   ///< outputs of different values have different names in some run
};

/// The classes of every flow class whose values can be replaced by classes, by its least place (docs/data.md). The
/// class model is equal to the ideal model up to the names of values: every condition has one answer for all values of
/// a class, and an input of any value of a class has the same effect (a functional bisimulation).
[[nodiscard]] std::map<PlaceId, ValueClasses> divide_values(const System& system, const Sampling& sampling,
                                                            const Places& places, const std::map<PlaceId, Uses>& uses);

}  // namespace robochart::ir
