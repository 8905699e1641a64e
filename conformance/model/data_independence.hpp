// SPDX-License-Identifier: Apache-2.0
// Finds the values that a component only passes on.
#pragma once

#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// Values that the component only passes on ("data independent": Lazić 1999; Roscoe UCS 17.2). It stores them, sends
/// them and passes them to operations, but uses them in no operator, comparison, index or wait.
struct DataIndependence {
    bool nat = true;
    bool integer = true;
    bool real = true;
    std::vector<ir::TypeId> looked_into;  ///< types with parts for which something depends on values or on parts of
                                          ///< values

    /// Whether the component only passes on numbers of this kind.
    [[nodiscard]] bool is_independent(ir::TypeKind) const;
    /// Whether the component passes on values of a type with parts as a whole. False for other types.
    [[nodiscard]] bool is_independent(const ir::System&, ir::TypeId) const;
};

/// Analyses these machines and operations together.
[[nodiscard]] DataIndependence data_independence(const ir::System&, const std::vector<ir::MachineId>&);

/// Whether the two types are the same: compares declared types by name, other types by structure.
[[nodiscard]] bool same_type(const ir::System&, ir::TypeId, ir::TypeId);

}  // namespace robochart::conformance
