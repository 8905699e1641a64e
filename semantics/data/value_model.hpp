// SPDX-License-Identifier: Apache-2.0
// A model over a few values that stand for all numbers, for a comparison with code (docs/conformance.md, "All values").
// The conditions of the model, and comparisons that the code makes, divide the numbers of each type into regions. The
// values are: all that the model writes, and two more of each region, or all of a region that has fewer. In the
// resulting system the values are literals of enumerations, so conditions are decided here, in the ideal semantics.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "semantics/data/class_model.hpp"
#include "semantics/data/window.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// A comparison of a linear form with zero: the sum of coefficients times the numbers of a value (number_parts.hpp),
/// plus the constant in units (ValueModel::scale). The form of a sequence has one number, which is the least or
/// greatest one at the places of a window, or the size; the constant is whole if this number is.
struct Cut {
    TypeId type;
    std::vector<std::int64_t> coefficients;  ///< one for each number of the type; not all are 0
    std::int64_t constant = 0;
    std::optional<SequenceWindow> window = {};  ///< of a sequence; no value: the size
    friend auto operator<=>(const Cut&, const Cut&) = default;
};
/// The same cut with coprime numbers and a positive first coefficient.
[[nodiscard]] Cut normalized(Cut cut);

/// The values of one type, number by number: reals in units, others whole. The numbers of a sequence are its items. The
/// enumerations of the model have a literal for each, in this order; the first is the default value of the type.
struct ExploredValues {
    TypeId type;
    std::vector<std::vector<std::int64_t>> values;
    std::size_t written = 0;  ///< the number of values, from the first on, that the model writes itself
};

/// A comparison in a condition of the model that reads one value, and other numbers only from literals and constants.
struct ModelComparison {
    TypeId type;                                    ///< of the value; one of ValueModel::types
    const Expr* expr = nullptr;                     ///< in the system of the model
    std::map<const Expr*, std::int64_t> constants;  ///< the constants in it: reals in units, others whole
    std::vector<bool> answers;                      ///< for each explored value of the type
};

/// A system whose numbers are literals of enumerations, one for each explored value.
struct ValueModel {
    System system;
    std::int64_t scale = 1;  ///< units of one real
    std::vector<ExploredValues> types;
    std::vector<ReplacedData> data;  ///< for reports: the classes by the conditions of the model, without `cuts`
    std::vector<ModelComparison> comparisons;  ///< for reports: those whose answers are known
    std::vector<Cut> cuts;  ///< the forms of all conditions and comparisons, normalized and ascending
};

/// The value model of these machines, whose regions are divided by the conditions of the model and by `cuts`. No value
/// if the machines compute numbers or durations, compare values with each other, or contain other data with numbers or
/// without a finite set of values (sequences of records, say). No value either if there are no numbers, a remainder, or
/// too many regions. The instantiation is that of the model, with its own carriers.
[[nodiscard]] std::optional<ValueModel> value_model(const System& system, const Instantiation& instantiation,
                                                    const std::vector<MachineId>& machines,
                                                    const std::vector<Cut>& cuts);

}  // namespace robochart::ir
