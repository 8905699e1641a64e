// SPDX-License-Identifier: Apache-2.0
// Determines which classes a computed value can have, for each class of the value from which it is computed. Private to
// this component. Example: for `n = n + 1` and the condition n < 5, a value that is at least 5 stays at least 5.
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

/// Returns, for each class of `source`, the classes of `target` to which the value of the expression can belong, if the
/// only variable that it reads holds a value of the class. Returns no value if this is not known. The conditions of
/// both flow classes and the expression must belong to one machine, and the conditions on the computed value must
/// divide the values of the source. Method: the conditions of the source divide the values of the source. The
/// conditions of the target, with the expression in the place of the value, divide them further. Each part of the
/// common division gives one pair of classes.
[[nodiscard]] std::optional<std::vector<std::set<std::size_t>>> images_of(const System& system,
                                                                          const Sampling& sampling, MachineId machine,
                                                                          const DividedFlow& source,
                                                                          const DividedFlow& target,
                                                                          const ExprPtr& expr);

}  // namespace robochart::ir
