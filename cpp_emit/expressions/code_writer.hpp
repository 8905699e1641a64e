// SPDX-License-Identifier: Apache-2.0
// Writes the indented text of generated files. The writer opens and closes blocks, so no formatter is necessary.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "base/diagnostics/escape.hpp"
#include "cpp_emit/expressions/cpp_expr.hpp"

namespace robochart::cpp_emit {

/// Writes lines of C++. A line may contain the generator's own text, identifiers (names.hpp) and literals
/// (base/diagnostics/escape.hpp). A control character or non-ASCII character in it is an internal error. Comments may
/// contain any text.
class CodeWriter {
public:
    explicit CodeWriter(std::size_t depth = 0) : depth_(depth), outermost_(depth) {}

    /// Writes one line at the current depth; "" is an empty line.
    void line(std::string_view text = {});
    /// Writes `text`, which ends in a brace or colon, and indents the following lines.
    void open(std::string_view text);
    /// Opens a function or type after an empty line, with its comment. `head` ends in a brace, which `close` closes.
    void open_declaration(const diagnostics::ForeignText& comment, std::string_view head);
    /// Calls `body` to write lines. If there is a condition, the lines are inside an `if`.
    void write_if(const CppExpr& condition, const std::function<void()>& body);
    /// Ends a block: writes "}", "};" or similar text one level less deep.
    void close(std::string_view text = "}");
    /// Writes "public:" and similar lines one level less deep.
    void write_label(std::string_view text);
    /// Ends a block and opens the next one: "} else {".
    void reopen_block(std::string_view text);
    /// Writes `/// text`, wrapped at the line width.
    void doc(const diagnostics::ForeignText& text) { write_wrapped("/// ", diagnostics::comment_text(text)); }
    /// Writes `// text`, wrapped at the line width.
    void comment(const diagnostics::ForeignText& text) { write_wrapped("// ", diagnostics::comment_text(text)); }
    /// Writes `text  ///< behind` on one line.
    void line_with_doc(std::string_view text, const diagnostics::ForeignText& behind);
    /// Writes lines that are already indented.
    void write_raw(std::string_view lines);
    /// Writes an empty line between parts; never two consecutive ones, and none at the beginning of a block.
    void gap();

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] bool empty() const { return text_.empty(); }

private:
    void write_wrapped(std::string_view prefix, std::string_view text);
    void put_line(std::string_view text);

    std::string text_;
    std::size_t depth_ = 0;
    [[maybe_unused]] std::size_t outermost_ = 0;  ///< the depth at the beginning, for assertions
    bool fresh_ = true;                           ///< true at the beginning of a file or block
};

}  // namespace robochart::cpp_emit
