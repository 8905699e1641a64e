// The pages of the rules: docs/rules/CODE.md, compiled in. One page a code says what is wrong, why the rule exists,
// and shows a wrong and a right example; the tests run both (docs/rules/README.md defines the form).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace robochart::app {

/// A page as written. The code is the name of its file; `README` is the index.
struct PageText {
    std::string_view code;
    std::string_view text;
};

/// All pages, sorted by code as the file system sorts them (made by embed_pages.cmake).
[[nodiscard]] const std::vector<PageText>& page_texts();
/// The text of one page, ignoring case; "" if there is none.
[[nodiscard]] std::string_view page_text(std::string_view code);

/// A fenced block: one file of an example, or (language `console`) the command that shows the finding.
struct Block {
    std::string language;  ///< robochart, assertions, cspm, console, text
    std::string file;      ///< from `file=NAME` after the language; "" if none is given
    std::string text;
};

/// The parts of a page.
struct RulePage {
    std::string code, title;
    std::string severity;  ///< "error", "warning", "error or warning", ...
    std::string area;      ///< a heading of the index
    std::string source;    ///< where the rule comes from; may be empty
    std::string reason;    ///< the paragraphs before the examples
    std::vector<Block> wrong, right;
    std::vector<std::string> faults;  ///< departures from the form, in words; empty for a good page
};

[[nodiscard]] RulePage read_page(std::string_view text);

/// The page for a terminal: headings and code words marked where colours are on, examples indented, links by name.
[[nodiscard]] std::string render_page(std::string_view text, bool color);

}  // namespace robochart::app
