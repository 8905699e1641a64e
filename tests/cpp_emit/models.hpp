// Models for the tests: the corpus, and machines written in the tests themselves.
#pragma once

#include <string>

#include "semantics/ir.hpp"

namespace robochart::cpp_emit::testing {

/// A project of corpus/ as IR; it must be free of errors.
[[nodiscard]] ir::System corpus(const std::string& name);
/// RoboChart text as IR; it must be free of errors.
[[nodiscard]] ir::System model(const std::string& text);

}  // namespace robochart::cpp_emit::testing
