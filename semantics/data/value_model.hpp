// SPDX-License-Identifier: Apache-2.0
// Replaces the numbers of a model by a few values that represent all numbers. The result is used to compare a model
// with code (docs/conformance.md, "All values"). The conditions of the model, and comparisons that the code makes,
// divide the numbers of each type into regions. The explored values are all values that the model writes and two
// further values of each region, or all values of a region that has fewer. In the resulting system the values are
// literals of enumerations, so this component decides the conditions, in the ideal semantics.
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

/// A comparison of a linear form with zero. The form is a sum of coefficients times the numbers of a value
/// (number_parts.hpp), plus a constant in units (ValueModel::scale). For a sequence, the only number is its size, or
/// the least or greatest number in a window. If this is a whole number, the constant is a whole number too.
struct Cut {
    TypeId type;
    std::vector<std::int64_t> coefficients;  ///< one for each number of the type; not all are 0
    std::int64_t constant = 0;
    std::optional<SequenceWindow> window = {};  ///< for a sequence: the window; no value if the number is the size
    friend auto operator<=>(const Cut&, const Cut&) = default;
};
/// Returns the same cut with coprime numbers and a positive first coefficient.
[[nodiscard]] Cut normalized(Cut cut);

/// The explored values of one type. Each value is a list of its numbers: reals in units, other numbers unchanged. The
/// numbers of a sequence are its elements. In the value model, an enumeration replaces the type. It has one literal for
/// each value, in the order of `values`. The first value is the default value of the type.
struct ExploredValues {
    TypeId type;
    std::vector<std::vector<std::int64_t>> values;
    std::size_t written = 0;  ///< the number of values, from the first on, that the model writes itself
};

/// A comparison in a condition of the model. It reads one value. Its other operands are literals and constants.
struct ModelComparison {
    TypeId type;                                    ///< the type of the value, one of ValueModel::types
    const Expr* expr = nullptr;                     ///< the comparison in the system of the model
    std::map<const Expr*, std::int64_t> constants;  ///< its constants: reals in units, other numbers unchanged
    std::vector<bool> answers;  ///< the truth value for each explored value of the type; empty for sequences
    std::optional<Cut> cut;     ///< for windows of reals: the number of the window minus the other operand
    std::size_t window = 0;     ///< with `cut`: the operand that reads the window, 0 or 1
};

/// A system whose numbers are literals of enumerations, one for each explored value.
struct ValueModel {
    System system;
    std::int64_t scale = 1;  ///< the number of units that represent the real number 1
    std::vector<ExploredValues> types;
    std::vector<ReplacedData> data;  ///< for reports: the classes by the conditions of the model, without `cuts`
    std::vector<ModelComparison> comparisons;  ///< for reports: the comparisons whose answers are known
    std::vector<Cut> cuts;  ///< the forms of all conditions and comparisons, normalized and ascending
};

/// Returns the value model of these machines. The conditions of the model and `cuts` divide values into regions.
/// Returns no value if the machines compute numbers or durations, compare values with each other, or contain other data
/// with numbers or without a finite set of values (for example, sequences of records). Also returns no value if there
/// are no numbers, if a condition contains a remainder, or if there are too many regions. `instantiation` is that of
/// the model, with its own carriers.
[[nodiscard]] std::optional<ValueModel> value_model(const System& system, const Instantiation& instantiation,
                                                    const std::vector<MachineId>& machines,
                                                    const std::vector<Cut>& cuts);

}  // namespace robochart::ir
