// SPDX-License-Identifier: Apache-2.0
// Determines, for each class of a value, the classes of the values computed from it. Private to this component.
// Example: for `n = n + 1` and the condition n < 5, a value that is at least 5 stays at least 5.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "semantics/data/classes.hpp"

namespace robochart::ir {

/// A flow class with its classes of values.
struct DividedFlow {
    TypeId type;
    const Uses* uses = nullptr;
    const ValueClasses* classes = nullptr;
};

/// Returns, for each class of `source`, to which classes of `target` the value of the expression can belong. The only
/// variable that the expression reads holds a value of the source class. Returns no value if this is not known. The
/// conditions of both flow classes and the expression must belong to one machine, and the conditions on the computed
/// value must divide the values of the source. Method: divide the values of the source by its own conditions, and
/// further by the conditions of the target, in which the expression replaces the value. Each part of this division
/// gives one pair of classes.
[[nodiscard]] std::optional<std::vector<std::set<std::size_t>>> images_of(const System& system,
                                                                          const Sampling& sampling, MachineId machine,
                                                                          const DividedFlow& source,
                                                                          const DividedFlow& target,
                                                                          const ExprPtr& expr);

}  // namespace robochart::ir
