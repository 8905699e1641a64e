// SPDX-License-Identifier: Apache-2.0
// Loads the models of the tests: the corpus, and machines written in the tests themselves.
#pragma once

#include <string>

#include "semantics/ir/ir.hpp"
#include "tests/cpp_emit/harness.hpp"

namespace robochart::cpp_emit::testing {

/// Loads a project of corpus/ as IR. Errors fail the test.
[[nodiscard]] ir::System load_corpus(const std::string& name);
/// Loads RoboChart text as IR, or RoboSim text if the path is `NAME.rst`. Errors fail the test.
[[nodiscard]] ir::System load_model(const std::string& text, const std::string& path = "test.rct");

/// A module `Mod` with an enumeration, whole numbers, several arguments, an output event, and termination.
extern const char* const typed_model;

/// Writes the code of every component of a project that can be generated, each into its own folder. Returns their
/// number, which is 0 for a project with errors.
[[nodiscard]] std::size_t emit_all(const std::string& project, const Folder&, const Options& = {});

}  // namespace robochart::cpp_emit::testing
