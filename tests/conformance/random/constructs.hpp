// SPDX-License-Identifier: Apache-2.0
// The language constructs that a model uses, to measure the coverage of the random models.
#pragma once

#include <set>
#include <string>

#include "semantics/ir/ir.hpp"

namespace robochart::conformance::test {

/// Names of the constructs in a module's machines, operations and connections: "during", "depth 3", "async".
[[nodiscard]] std::set<std::string> constructs_in(const ir::System&);
/// The constructs that random models of the core shape must cover.
[[nodiscard]] std::set<std::string> claimed_constructs();
/// The constructs that random models of the widened shape must cover.
[[nodiscard]] std::set<std::string> widened_constructs();

}  // namespace robochart::conformance::test
