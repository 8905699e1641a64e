// SPDX-License-Identifier: Apache-2.0
// A model over a few values that stand for all numbers, for a comparison with code (docs/conformance.md, "All values").
// The conditions of the model, and comparisons that the code makes, divide the numbers of each type into regions. The
// values are: all that the model writes, and two more of each region, or all of a region that has fewer. In the
// resulting system the values are literals of enumerations, so conditions are decided here, in the ideal semantics.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "semantics/data/class_model.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// A comparison of a linear form with zero: the sum of coefficients times the numbers of a value (number_parts.hpp),
/// plus the constant in units (ValueModel::scale).
struct Cut {
    TypeId type;
    std::vector<std::int64_t> coefficients;  ///< one for each number of the type; not all are 0
    std::int64_t constant = 0;
    friend auto operator<=>(const Cut&, const Cut&) = default;
};
/// The same cut with coprime numbers and a positive first coefficient.
[[nodiscard]] Cut normalized(Cut cut);

/// The values of one type, number by number: reals in units, others whole. The enumerations of the model have a literal
/// for each, in this order; the first is the default value of the type.
struct ExploredValues {
    TypeId type;
    std::vector<std::vector<std::int64_t>> values;
};

struct ValueModel {
    System system;
    std::int64_t scale = 1;  ///< units of one real
    std::vector<ExploredValues> types;
    std::vector<ReplacedData> data;  ///< with the classes of the model's own conditions
    std::vector<Cut> cuts;           ///< all that have one sign in each region, normalized and ascending
};

/// The value model of these machines, which divides values by its conditions and by `cuts`. No value if the machines
/// have data that are computed, compared with each other, or no numbers, if they compute with clocks, or if there are
/// too many regions. The instantiation is the model's own.
[[nodiscard]] std::optional<ValueModel> value_model(const System& system, const Instantiation& instantiation,
                                                    const std::vector<MachineId>& machines,
                                                    const std::vector<Cut>& cuts);

}  // namespace robochart::ir
