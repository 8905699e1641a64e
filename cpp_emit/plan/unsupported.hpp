// SPDX-License-Identifier: Apache-2.0
// Rejects constructs for which no code can be generated. Each is reported by name before any code is written.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// The maximal number of values of one input that the exploration interface lists.
inline constexpr std::size_t max_input_values = 4096;

/// Reports every construct of the component that has no translation to C++ (rules.hpp). Returns true if there is none.
[[nodiscard]] bool check_support(const ir::System&, const ir::Instantiation&, const Component&,
                                 diagnostics::Diagnostics&);

/// A part of a component with more values than the tables of the exploration interface can contain, and the violated
/// limit.
struct BeyondExploration {
    std::string name;
    std::string limit;
};
[[nodiscard]] std::vector<BeyondExploration> beyond_exploration(const ir::System&, const ir::Instantiation&,
                                                                const Component&);

}  // namespace robochart::cpp_emit
