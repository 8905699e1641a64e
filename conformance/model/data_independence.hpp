// Which values a component only passes on.
#pragma once

#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// Values that the component only passes on: it stores, sends and hands them to operations, and no operator,
/// comparison, index or wait depends on them ("data independent": Lazić 1999; Roscoe UCS 17.2).
struct DataIndependence {
    bool nat = true;
    bool integer = true;
    bool real = true;
    std::vector<ir::TypeId> looked_into;  ///< types with parts on whose values, or parts of values, something depends

    /// Of kinds of numbers.
    [[nodiscard]] bool of(ir::TypeKind) const;
    /// Of a type with parts: its values are passed on as wholes. False for other types.
    [[nodiscard]] bool of(const ir::System&, ir::TypeId) const;
};

/// Of these machines and operations together.
[[nodiscard]] DataIndependence data_independence(const ir::System&, const std::vector<ir::MachineId>&);

/// Declared types by their names, others by what they are made of.
[[nodiscard]] bool same_type(const ir::System&, ir::TypeId, ir::TypeId);

}  // namespace robochart::conformance
