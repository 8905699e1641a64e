// Which numbers a component only passes on.
#pragma once

#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// Kinds of numbers whose values the component only passes on: it stores, sends and hands them to operations, and no
/// operator, comparison, index or wait depends on them ("data independent": Lazić 1999; Roscoe UCS 17.2).
struct DataIndependence {
    bool nat = true;
    bool integer = true;
    bool real = true;

    [[nodiscard]] bool of(ir::TypeKind) const;
};

/// Of these machines and operations together.
[[nodiscard]] DataIndependence data_independence(const ir::System&, const std::vector<ir::MachineId>&);

}  // namespace robochart::conformance
