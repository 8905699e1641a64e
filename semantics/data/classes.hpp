// SPDX-License-Identifier: Apache-2.0
// Divides the values of each flow class (places.hpp) into classes. All values of one class give the same answer to
// every condition. Private to this component.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "semantics/data/uses.hpp"
#include "semantics/ir/number_parts.hpp"

namespace robochart::ir {

/// The classes of values of one flow class. Values are in units of the sampling scale.
struct ValueClasses {
    /// One value of each class. The value of the first class is the default value of the type.
    std::vector<Value> witnesses;
    /// The class of each value that the model writes.
    std::map<Value, std::size_t> of_value;
    /// For each condition: whether it is true for the values of each class.
    std::map<const Expr*, std::vector<bool>> answers;
    bool all_values = false;      ///< all values of the type are in a class; otherwise only those that occur
    bool nothing_tested = false;  ///< no condition reads the values; the last class represents any value
    bool exact_outputs = false;   ///< in some run, outputs of different values have different names
};

/// True if the type contains numbers, texts, elements of given types, or sequences, and value_text can show its values.
[[nodiscard]] bool is_replaceable(const System& system, TypeId type);

/// Finds a value for each possible combination of answers of conditions on one place. The type must not contain
/// sequences. Uses linear regions (linear.hpp) or, if this fails, the solver (solver.hpp). Returns no value if both
/// fail.
[[nodiscard]] std::optional<std::vector<Value>> values_for_answers(const System& system, const Sampling& sampling,
                                                                   TypeId type,
                                                                   const std::vector<Condition>& conditions);

/// Returns true if the condition can divide values into classes. It must read only one place, which has this
/// type.
[[nodiscard]] bool can_divide(const System& system, const Sampling& sampling, MachineId machine, TypeId type,
                              const Expr& condition);

/// The classes of all flow classes. A flow class is identified by its least place.
struct DividedData {
    std::map<PlaceId, ValueClasses> classes;  ///< the classes of flow classes whose values can be replaced
    std::map<PlaceId, Keep> kept;             ///< for each other flow class: why it keeps its values
};

/// Returns the classes of every flow class whose values classes can replace (docs/data.md). The class model equals the
/// ideal model up to the names of values (a functional bisimulation). The reason: all values of a class give the same
/// answer to each condition, and have the same effect as inputs. If the class of a computed value is chosen freely,
/// this is true only for the choice that contains the computed value.
[[nodiscard]] DividedData divide_values(const System& system, const Sampling& sampling, const Places& places,
                                        const std::map<PlaceId, Uses>& uses, Computed computed = Computed::exactly);

}  // namespace robochart::ir
