// SPDX-License-Identifier: Apache-2.0
// Models for the tests: the corpus, and machines written in the tests themselves.
#pragma once

#include <string>

#include "semantics/ir/ir.hpp"
#include "tests/cpp_emit/harness.hpp"

namespace robochart::cpp_emit::testing {

/// Loads a project of corpus/ as IR; errors fail the test.
[[nodiscard]] ir::System load_corpus(const std::string& name);
/// Loads RoboChart text as IR, or RoboSim text with a path `NAME.rst`; errors fail the test.
[[nodiscard]] ir::System load_model(const std::string& text, const std::string& path = "test.rct");

/// A module `Mod` with an enumeration, whole numbers, several arguments, a sent event, and termination.
extern const char* const typed_model;

/// Writes the code of every component of a project that can be generated, each into its own folder; returns their
/// number. A project with errors counts as 0.
[[nodiscard]] std::size_t emit_all(const std::string& project, const Folder&, const Options& = {});

}  // namespace robochart::cpp_emit::testing
