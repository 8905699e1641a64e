// What a document in Markdown asks a reader to do: files to write and commands to run, with what these print.
// docs/testing.md, "Commands in documents", describes how they are written.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace robochart::app::testing {

/// A fenced block.
struct Block {
    std::string language;  ///< what stands behind its fence
    std::size_t line;      ///< of its fence in the document, from 1
    std::vector<std::string> lines;
};

/// The blocks of a document, in its order.
[[nodiscard]] std::vector<Block> blocks(const std::string& document);

/// Text in backquotes, outside blocks.
struct Inline {
    std::size_t line;  ///< of the beginning of its paragraph in the document, from 1
    std::string text;  ///< on one line
};
[[nodiscard]] std::vector<Inline> inline_code(const std::string& document);

/// A block whose first line is `// file: NAME`, or `-- file: NAME` as CSPM has it.
struct ShownFile {
    std::string name;
    std::string text;
};

/// A line `$ COMMAND` of a block `console`, and the lines below it.
struct ShownCommand {
    std::string command;
    std::vector<std::string> output;
};

/// A block `console`: its commands run in one shell.
struct ShownSession {
    std::size_t line;  ///< of its fence in the document, from 1
    std::vector<ShownCommand> commands;
};

using Step = std::variant<ShownFile, ShownSession>;

/// The steps of a document, in its order.
[[nodiscard]] std::vector<Step> steps(const std::string& document);

/// The lines of a text, without the empty ones at its end.
[[nodiscard]] std::vector<std::string> lines_of(const std::string& text);

/// Whether lines are printed as they are shown. A shown line `...` stands for any lines. Widths of gaps between
/// words, times, sizes and counts of states, transitions and cycles are not compared.
[[nodiscard]] bool agrees(const std::vector<std::string>& shown, const std::vector<std::string>& printed);

}  // namespace robochart::app::testing
