// SPDX-License-Identifier: Apache-2.0
// Divides the values of each flow class (places.hpp) into classes. No condition distinguishes two values of one class.
// Private to this component.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "semantics/data/uses.hpp"
#include "semantics/ir/number_parts.hpp"

namespace robochart::ir {

/// The classes of values of one flow class. Values are in units of the sampling scale.
struct ValueClasses {
    /// A value of each class. The first class contains the default value of the type.
    std::vector<Value> witnesses;
    /// The class of each value that the model writes.
    std::map<Value, std::size_t> of_value;
    /// For each condition: for each class, whether the condition is true for its values.
    std::map<const Expr*, std::vector<bool>> answers;
    bool all_values = false;  ///< the classes together contain all values of the type; otherwise only those that occur
    bool nothing_tested = false;  ///< no condition reads the values; the last class represents any value
    bool exact_outputs = false;   ///< outputs of different values have different names in some run
};

/// True if the type contains numbers, texts, elements of given types, or sequences, and value_text can show its values.
[[nodiscard]] bool is_replaceable(const System& system, TypeId type);

/// Finds a value of the type for each possible combination of answers of conditions on one place. The type must not
/// contain sequences. The method uses linear regions (linear.hpp) or, if this fails, the solver (solver.hpp). Returns
/// no value if both fail.
[[nodiscard]] std::optional<std::vector<Value>> values_for_answers(const System& system, const Sampling& sampling,
                                                                   TypeId type,
                                                                   const std::vector<Condition>& conditions);

/// True if the condition has a form that divides values into classes. The condition must read only one place, which has
/// this type.
[[nodiscard]] bool can_divide(const System& system, const Sampling& sampling, MachineId machine, TypeId type,
                              const Expr& condition);

/// The division of all flow classes. The least place of a flow class identifies it.
struct DividedData {
    std::map<PlaceId, ValueClasses> classes;  ///< the classes of flow classes whose values can be replaced
    std::map<PlaceId, Keep> kept;             ///< the reasons why all other flow classes keep their values
};

/// Returns the classes of every flow class whose values can be replaced by classes (docs/data.md). The class model is
/// equal to the ideal model up to the names of values (a functional bisimulation): every condition has one answer for
/// all values of a class, and an input has the same effect for all values of a class. If the classes of computed values
/// are chosen freely, this is true only for the choices to which the computed values belong.
[[nodiscard]] DividedData divide_values(const System& system, const Sampling& sampling, const Places& places,
                                        const std::map<PlaceId, Uses>& uses, Computed computed = Computed::exactly);

}  // namespace robochart::ir
