// SPDX-License-Identifier: Apache-2.0
// The targets of the fuzzers: they accept any bytes, and must not crash, hang or violate a property that the headers
// state. The same functions run as ordinary tests on the stored inputs of tests/fuzz/regressions.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace robochart::fuzz {

/// A part of the program that accepts any input.
struct Target {
    std::string_view name;  ///< also the folder of its regressions
    /// Runs the part. Returns the violated property in words, "" if there is none.
    std::string (*run)(std::string_view bytes);
};

/// Model text: parsed, resolved, checked, printed, dumped; all findings are printed.
[[nodiscard]] std::string run_model(std::string_view bytes);
/// Assertion text next to a fixed model.
[[nodiscard]] std::string run_assertions(std::string_view bytes);
/// A CSPM script: parsed, printed, parsed again.
[[nodiscard]] std::string run_script(std::string_view bytes);
/// Model text through all components after the front end, with small limits. Files are separated by form feeds;
/// assertion files start with `!`.
[[nodiscard]] std::string run_semantics(std::string_view bytes);
/// A session with the language server: the first line contains requests and changes, the rest is the document.
[[nodiscard]] std::string run_editor(std::string_view bytes);
/// The language server's input stream.
[[nodiscard]] std::string run_stream(std::string_view bytes);

/// An MCAP file with a log.
[[nodiscard]] std::string run_mcap(std::string_view bytes);

[[nodiscard]] std::span<const Target> targets();

}  // namespace robochart::fuzz
