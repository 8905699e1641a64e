// SPDX-License-Identifier: Apache-2.0
// Converts text from outside (string literals of models, names of files) for the languages that the project writes.
// There is one function for each language; json.hpp handles JSON. Text from outside has the type ForeignText, which
// only these functions convert, so that it cannot be inserted unescaped.
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace robochart::diagnostics {

/// Text that may contain anything: quotes, line ends, zeros, bytes that are not UTF-8. Text that is joined with foreign
/// text is foreign text, too. Only the functions below convert it.
class ForeignText {
public:
    ForeignText() = default;
    ForeignText(std::string text) : text_(std::move(text)) {}  // NOLINT: any text may become foreign
    ForeignText(std::string_view text) : text_(text) {}        // NOLINT
    ForeignText(const char* text) : text_(text) {}             // NOLINT

    [[nodiscard]] bool empty() const { return text_.empty(); }
    /// Returns the text without escapes. It may only be used for comparisons, and for syntax trees of languages with
    /// their own escapes. tests/sanity lists the files that call it.
    [[nodiscard]] const std::string& unescaped() const { return text_; }

    friend ForeignText operator+(ForeignText a, const ForeignText& b) {
        a.text_ += b.text_;
        return a;
    }
    friend bool operator==(const ForeignText&, const ForeignText&) = default;
    friend auto operator<=>(const ForeignText&, const ForeignText&) = default;

private:
    std::string text_;
};

/// Returns the text for a terminal or a report: control characters, invisible characters, line ends and bytes that are
/// not UTF-8 become escapes such as "\n", "\x1b" or "\u202e".
[[nodiscard]] std::string escape_for_display(const ForeignText&);
/// Returns text of several lines for a terminal or a report. It is escaped as by the function above, except for line
/// ends and tabulators.
[[nodiscard]] std::string shown_lines(const ForeignText&);

/// Returns the text for a comment of C++, CMake or Python. The result is one line, which does not continue on the next
/// line.
[[nodiscard]] std::string comment_text(const ForeignText&);

/// Returns a string literal of C++ with its quotes. Printable ASCII characters stay, except in trigraphs; all other
/// characters become octal escapes.
[[nodiscard]] std::string cpp_string(const ForeignText&);

/// Returns a string literal of CSPM with its quotes.
[[nodiscard]] std::string cspm_string(const ForeignText&);
/// Returns a character literal of CSPM with its quotes.
[[nodiscard]] std::string cspm_character(char);

/// Returns character data, an attribute value or a comment of XML 1.0 (also SVG). Characters that XML does not allow
/// are shown as escapes.
[[nodiscard]] std::string xml_text(const ForeignText&);
/// Returns character data of several lines for XML. It is escaped as by the function above, except for line ends.
[[nodiscard]] std::string xml_lines(const ForeignText&);

/// Returns the text between the double quotes of a Graphviz label or of an event in Aldebaran's format.
[[nodiscard]] std::string label_text(const ForeignText&);

/// Returns a path as a URI reference (RFC 3986; RFC 8089 if the path is absolute). All characters that are not
/// unreserved are escaped.
[[nodiscard]] std::string uri_of_path(std::string_view path);

}  // namespace robochart::diagnostics
