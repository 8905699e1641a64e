// SPDX-License-Identifier: Apache-2.0
// Reads the steps that a Markdown document asks a reader to do: files to write, and commands to run with their expected
// output. docs/testing.md, "Commands in documents", describes the notation.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace robochart::app::testing {

/// A fenced block.
struct Block {
    std::string language;  ///< the word after its fence
    std::size_t line;      ///< line of its fence in the document, from 1
    std::vector<std::string> lines;
};

/// Returns the fenced blocks of a document, in order.
[[nodiscard]] std::vector<Block> blocks_of(const std::string& document);

/// Text in backquotes, outside blocks.
struct Inline {
    std::size_t line;  ///< first line of its paragraph in the document, from 1
    std::string text;  ///< joined into one line
};
[[nodiscard]] std::vector<Inline> inline_code(const std::string& document);

/// A block whose first line is `// file: NAME` (in CSPM, `-- file: NAME`).
struct ShownFile {
    std::string name;
    std::string text;
};

/// A line `$ COMMAND` in a `console` block, and the output lines below it.
struct ShownCommand {
    std::string command;
    std::vector<std::string> output;
};

/// A `console` block. Its commands run in one shell.
struct ShownSession {
    std::size_t line;  ///< line of its fence in the document, from 1
    std::vector<ShownCommand> commands;
};

using Step = std::variant<ShownFile, ShownSession>;

/// Returns the steps of a document, in order.
[[nodiscard]] std::vector<Step> steps_of(const std::string& document);

/// Returns the lines of a text, without empty lines at its end.
[[nodiscard]] std::vector<std::string> lines_of(const std::string& text);

/// Returns whether the printed lines agree with the shown ones. A shown line `...` matches any lines. The comparison
/// ignores the widths of gaps between words, times, sizes, and counts of states, transitions and cycles.
[[nodiscard]] bool lines_agree(const std::vector<std::string>& shown, const std::vector<std::string>& printed);

}  // namespace robochart::app::testing
