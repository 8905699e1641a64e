// What a model uses of the language: the measure for what the random models reach.
#pragma once

#include <set>
#include <string>

#include "semantics/ir/ir.hpp"

namespace robochart::conformance::test {

/// Words for the constructs of a module's machines, operations and connections: "during", "depth 3", "async".
[[nodiscard]] std::set<std::string> constructs(const ir::System&);
/// All that the random models must have.
[[nodiscard]] std::set<std::string> claimed_constructs();
/// The same of those of the widened shape.
[[nodiscard]] std::set<std::string> widened_constructs();

}  // namespace robochart::conformance::test
