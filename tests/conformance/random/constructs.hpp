// SPDX-License-Identifier: Apache-2.0
// Finds the language constructs that a model uses, to measure the coverage of the random models.
#pragma once

#include <set>
#include <string>

#include "semantics/ir/ir.hpp"

namespace robochart::conformance::test {

/// Returns the names of the constructs in a module's machines, operations and connections: "during", "depth 3",
/// "async".
[[nodiscard]] std::set<std::string> constructs_in(const ir::System&);
/// Returns the constructs that random models of the core shape must cover.
[[nodiscard]] std::set<std::string> claimed_constructs();
/// Returns the constructs that random models of the widened shape must cover.
[[nodiscard]] std::set<std::string> widened_constructs();

}  // namespace robochart::conformance::test
