// Models for the tests: the corpus, and machines written in the tests themselves.
#pragma once

#include <string>

#include "semantics/ir/ir.hpp"
#include "tests/cpp_emit/harness.hpp"

namespace robochart::cpp_emit::testing {

/// A project of corpus/ as IR; it must be free of errors.
[[nodiscard]] ir::System corpus(const std::string& name);
/// RoboChart text as IR; it must be free of errors.
[[nodiscard]] ir::System model(const std::string& text);

/// A module `Mod` with an enumeration, whole numbers, several arguments, an event sent, termination.
extern const char* const typed_model;

/// Writes the code of every component of a project that can be generated, one folder each; how many there are.
/// Projects with errors count as none.
[[nodiscard]] std::size_t emit_all(const std::string& project, const Folder&, const Options& = {});

}  // namespace robochart::cpp_emit::testing
