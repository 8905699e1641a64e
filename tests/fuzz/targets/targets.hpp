// What the fuzzers try: any bytes go in, and nothing may crash, hang or break a promise of the headers.
// The same functions run on the kept inputs of tests/fuzz/regressions as ordinary tests.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace robochart::fuzz {

/// A part of the program under any input.
struct Target {
    std::string_view name;  ///< also the folder of its regressions
    /// Runs the part. Returns the promise that was broken in words, "" if none was.
    std::string (*run)(std::string_view bytes);
};

/// Model text: read, resolved, checked, printed, dumped; every finding drawn.
[[nodiscard]] std::string run_model(std::string_view bytes);
/// Assertion text beside a fixed model.
[[nodiscard]] std::string run_assertions(std::string_view bytes);
/// A CSPM script: read, printed, read again.
[[nodiscard]] std::string run_script(std::string_view bytes);
/// Model text through all that is behind the front end, within small limits: files divided by form feeds, those of
/// assertions after a `!`.
[[nodiscard]] std::string run_semantics(std::string_view bytes);
/// A session with the language server: the first line says what is asked and typed, the rest is the document.
[[nodiscard]] std::string run_editor(std::string_view bytes);
/// The language server's input stream.
[[nodiscard]] std::string run_stream(std::string_view bytes);

[[nodiscard]] std::span<const Target> targets();

}  // namespace robochart::fuzz
