// SPDX-License-Identifier: Apache-2.0
// Declares the targets of the fuzzers. They accept any bytes, and must not crash, hang or violate a property that the
// headers state. The same functions run as ordinary tests on the stored inputs of tests/fuzz/regressions.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace robochart::fuzz {

/// A part of the program that accepts any input.
struct Target {
    std::string_view name;  ///< also the folder of its regressions
    /// Runs the part. Returns the violated property in words, or "" if there is none.
    std::string (*run)(std::string_view bytes);
};

/// Parses, resolves, checks, prints and dumps model text, and prints all findings.
[[nodiscard]] std::string run_model(std::string_view bytes);
/// Does the same for assertion text next to a fixed model.
[[nodiscard]] std::string run_assertions(std::string_view bytes);
/// Parses a CSPM script, prints it and parses it again.
[[nodiscard]] std::string run_script(std::string_view bytes);
/// Runs model text through all components after the front end, with small limits. Files are separated by form feeds.
/// Assertion files start with `!`.
[[nodiscard]] std::string run_semantics(std::string_view bytes);
/// Runs a session with the language server. The first line contains requests and changes, and the rest is the document.
[[nodiscard]] std::string run_editor(std::string_view bytes);
/// Gives the bytes to the language server as its input stream.
[[nodiscard]] std::string run_stream(std::string_view bytes);

/// Reads the bytes as an MCAP file with a log.
[[nodiscard]] std::string run_mcap(std::string_view bytes);

[[nodiscard]] std::span<const Target> targets();

}  // namespace robochart::fuzz
