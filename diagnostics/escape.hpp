// Text that others wrote (string literals of models, names of files) on its way into a language: one function for each
// language that the project writes; json.hpp has JSON's. ForeignText is what such text is until then: nothing else lets
// it out, so that nobody can paste it.
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace robochart::diagnostics {

/// Text that may hold anything: quotes, line ends, zeros, bytes that are no UTF-8. It grows by being joined with other
/// text, which is foreign then too, and leaves through the functions below.
class ForeignText {
public:
    ForeignText() = default;
    ForeignText(std::string text) : text_(std::move(text)) {}  // NOLINT: any text may become foreign
    ForeignText(std::string_view text) : text_(text) {}        // NOLINT
    ForeignText(const char* text) : text_(text) {}             // NOLINT

    [[nodiscard]] bool empty() const { return text_.empty(); }
    /// As it is. For those who compare it or write it in a language with an escaping of its own in a syntax tree; the
    /// seams where this is called are listed in tests/sanity.
    [[nodiscard]] const std::string& unescaped() const { return text_; }

    friend ForeignText operator+(ForeignText a, const ForeignText& b) { return a.text_ += b.text_, a; }
    friend bool operator==(const ForeignText&, const ForeignText&) = default;
    friend auto operator<=>(const ForeignText&, const ForeignText&) = default;

private:
    std::string text_;
};

/// For people, in a terminal or a report: control characters, invisible ones and bytes that are no UTF-8 as "\n",
/// "\x1b" or "\u202e"; line ends too.
[[nodiscard]] std::string shown(const ForeignText&);
/// The same, but line ends and tabulators stay.
[[nodiscard]] std::string shown_lines(const ForeignText&);

/// Within a comment of C++, CMake or Python that ends with its line: one line that is not continued.
[[nodiscard]] std::string comment_text(const ForeignText&);

/// A string literal of C++ with its quotes: printable ASCII without trigraphs, all else as octal escapes.
[[nodiscard]] std::string cpp_string(const ForeignText&);

/// A string literal of CSPM with its quotes.
[[nodiscard]] std::string cspm_string(const ForeignText&);
/// A character literal of CSPM with its quotes.
[[nodiscard]] std::string cspm_character(char);

/// Character data, an attribute's value or a comment of XML 1.0, SVG included; what XML cannot hold is shown.
[[nodiscard]] std::string xml_text(const ForeignText&);
/// The same for character data of several lines: line ends stay.
[[nodiscard]] std::string xml_lines(const ForeignText&);

/// Between the double quotes of a label of Graphviz or an event of Aldebaran's format.
[[nodiscard]] std::string label_text(const ForeignText&);

/// A path as a URI reference (RFC 3986; RFC 8089 where it is absolute): what is not unreserved is escaped.
[[nodiscard]] std::string uri_of_path(std::string_view path);

}  // namespace robochart::diagnostics
