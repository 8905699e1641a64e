// SPDX-License-Identifier: Apache-2.0
// Converts text from outside (string literals of models, names of files) to the languages that the project writes: one
// function per language; json.hpp handles JSON. Until then, such text has the type ForeignText. Only these functions
// convert it, so that it cannot be inserted unescaped.
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace robochart::diagnostics {

/// Text that may contain anything: quotes, line ends, zeros, bytes that are not UTF-8. Text that is joined with foreign
/// text becomes foreign too. Only the functions below convert it.
class ForeignText {
public:
    ForeignText() = default;
    ForeignText(std::string text) : text_(std::move(text)) {}  // NOLINT: any text may become foreign
    ForeignText(std::string_view text) : text_(text) {}        // NOLINT
    ForeignText(const char* text) : text_(text) {}             // NOLINT

    [[nodiscard]] bool empty() const { return text_.empty(); }
    /// The unescaped text. Only for comparisons, and for syntax trees of languages with their own escaping.
    /// tests/sanity lists the files that call it.
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

/// Text for a terminal or a report: control characters, invisible characters, line ends and bytes that are not UTF-8
/// become escapes such as "\n", "\x1b" or "\u202e".
[[nodiscard]] std::string escape_for_display(const ForeignText&);
/// Text of several lines for a terminal or a report. It is escaped as by the function above, except for line ends and
/// tabulators.
[[nodiscard]] std::string shown_lines(const ForeignText&);

/// Text in a comment of C++, CMake or Python that ends with its line: one line that is not continued.
[[nodiscard]] std::string comment_text(const ForeignText&);

/// A string literal of C++ with its quotes: printable ASCII without trigraphs; all other characters are octal escapes.
[[nodiscard]] std::string cpp_string(const ForeignText&);

/// A string literal of CSPM with its quotes.
[[nodiscard]] std::string cspm_string(const ForeignText&);
/// A character literal of CSPM with its quotes.
[[nodiscard]] std::string cspm_character(char);

/// Character data, an attribute value or a comment of XML 1.0 (also SVG). Characters that XML does not allow are shown
/// as escapes.
[[nodiscard]] std::string xml_text(const ForeignText&);
/// Character data of several lines for XML. It is escaped as by the function above, except for line ends.
[[nodiscard]] std::string xml_lines(const ForeignText&);

/// Text between the double quotes of a Graphviz label or of an event in Aldebaran's format.
[[nodiscard]] std::string label_text(const ForeignText&);

/// A path as a URI reference (RFC 3986; RFC 8089 if it is absolute): all characters that are not unreserved are
/// escaped.
[[nodiscard]] std::string uri_of_path(std::string_view path);

}  // namespace robochart::diagnostics
