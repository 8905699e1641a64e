// SPDX-License-Identifier: Apache-2.0
// Finds the values that a component only passes on.
#pragma once

#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// Values that the component only passes on: it stores them, sends them and passes them to operations, and no operator,
/// comparison, index or wait depends on them ("data independent": Lazić 1999; Roscoe UCS 17.2).
struct DataIndependence {
    bool nat = true;
    bool integer = true;
    bool real = true;
    std::vector<ir::TypeId> looked_into;  ///< types with parts for which something depends on values or on parts of
                                          ///< values

    /// Whether the kind of numbers is only passed on.
    [[nodiscard]] bool of(ir::TypeKind) const;
    /// Whether values of a type with parts are passed on as a whole. False for other types.
    [[nodiscard]] bool of(const ir::System&, ir::TypeId) const;
};

/// For these machines and operations together.
[[nodiscard]] DataIndependence data_independence(const ir::System&, const std::vector<ir::MachineId>&);

/// Declared types are compared by name, others by structure.
[[nodiscard]] bool same_type(const ir::System&, ir::TypeId, ir::TypeId);

}  // namespace robochart::conformance
