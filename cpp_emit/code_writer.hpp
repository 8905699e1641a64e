// Indented text of generated files. Blocks are opened and closed, so that the output needs no formatter.
#pragma once

#include <string>
#include <string_view>

namespace robochart::cpp_emit {

class CodeWriter {
public:
    explicit CodeWriter(std::size_t depth = 0) : depth_(depth) {}

    /// One line at the current depth; "" is an empty line.
    void line(std::string_view text = {});
    /// `text` ends in a brace or colon that the following lines belong to.
    void open(std::string_view text);
    /// Ends a block: "}", "};", "} else {" come one level further out.
    void close(std::string_view text = "}");
    /// "public:" and the like, one level further out.
    void label(std::string_view text);
    /// "} else {": ends a block and opens the next.
    void reopen(std::string_view text);
    /// `/// text`, wrapped at the line width.
    void doc(std::string_view text) { wrapped("/// ", text); }
    /// `// text`, wrapped at the line width.
    void comment(std::string_view text) { wrapped("// ", text); }
    /// Lines that are indented already.
    void raw(std::string_view lines);
    /// An empty line between parts; never two in a row, none at the beginning of a block.
    void gap();

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] bool empty() const { return text_.empty(); }

private:
    void wrapped(std::string_view prefix, std::string_view text);

    std::string text_;
    std::size_t depth_ = 0;
    bool fresh_ = true;  ///< at the beginning of a file or block
};

}  // namespace robochart::cpp_emit
