// SPDX-License-Identifier: Apache-2.0
// Contains one escape function for each language. It decodes the text once and escapes the characters that have a
// meaning in the language.
#include "base/diagnostics/escape.hpp"

#include <fmt/format.h>

#include <sstream>

#include "base/diagnostics/control.hpp"
#include "base/diagnostics/utf8.hpp"

namespace robochart::diagnostics {

namespace {

using Escape = std::string (*)(char);

/// Escapes every byte separately.
std::string escape_bytes(const std::string& text, Escape escape) {
    std::string result;
    for (const char c : text) result += escape(c);
    return result;
}

bool letter_or_digit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

std::string control_escape(char c) {
    if (const auto letter = letter_of_control(c)) return {'\\', *letter};
    return fmt::format("\\x{:02x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
}

/// Returns the code point of a well-formed UTF-8 sequence.
unsigned decode_utf8(std::string_view sequence) {
    const unsigned lead = static_cast<unsigned char>(sequence.front());
    unsigned code = lead & 0x07U;
    if (sequence.size() == 2) code = lead & 0x1FU;
    if (sequence.size() == 3) code = lead & 0x0FU;
    for (const char c : sequence.substr(1)) code = (code << 6U) | (static_cast<unsigned char>(c) & 0x3FU);
    return code;
}

/// Returns true for characters that can make a text look like another text: C1 controls, characters without width,
/// characters that change the direction (Unicode 15, Default_Ignorable_Code_Point and Bidi_Control), and line and
/// paragraph separators.
bool is_invisible(unsigned code) {
    return (code >= 0x80U && code <= 0x9FU) || code == 0xADU || code == 0x61CU ||
           (code >= 0x200BU && code <= 0x200FU) || (code >= 0x2028U && code <= 0x202EU) ||
           (code >= 0x2060U && code <= 0x206FU) || code == 0xFEFFU || (code >= 0xFFF9U && code <= 0xFFFBU) ||
           (code >= 0xE0000U && code <= 0xE0FFFU);
}

/// Escapes invisible characters. `ascii` escapes ASCII characters as the language requires.
std::string escape_invisible(std::string_view text, Escape ascii, bool lines) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const char c = text.front();
        if (length == 0)
            result += fmt::format("\\x{:02x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
        else if (length == 1 && lines && (c == '\n' || c == '\t'))
            result += c;
        else if (length == 1)
            result += is_control(c) ? control_escape(c) : ascii(c);
        else if (const unsigned code = decode_utf8(text.substr(0, length)); is_invisible(code))
            result += fmt::format("\\u{:04x}", code);
        else
            result += text.substr(0, length);
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return result;
}

std::string as_it_is(char c) {
    return {c};
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

std::string cspm_escaped(const std::string& text, char quote) {
    std::string result(1, quote);
    for (const char c : text) {
        if (const auto letter = letter_of_control(c))
            (result += '\\') += *letter;
        else if (c == quote || c == '\\')
            (result += '\\') += c;
        else
            result += c;
    }
    return result + quote;
}

}  // namespace

std::string escape_for_display(const ForeignText& text) {
    return escape_invisible(text.unescaped(), as_it_is, false);
}

std::string shown_lines(const ForeignText& text) {
    return escape_invisible(text.unescaped(), as_it_is, true);
}

/// Also escapes backslashes: a backslash at the end of a line, also after wrapping, continues a comment, and "??/" is a
/// backslash (ISO C++14 [lex.trigraph]).
std::string comment_text(const ForeignText& text) {
    std::string result = escape_invisible(
        text.unescaped(), [](char c) { return c == '\\' ? "\\x5c" : std::string(1, c); }, false);
    replace_all(result, "??", "?\\x3f");
    return result;
}

std::string cpp_string(const ForeignText& text) {
    return '"' +
           escape_bytes(text.unescaped(),
                        [](char c) {
                            const bool plain = c != '"' && c != '\\' && c != '?' && c >= 0x20 && c < 0x7F;
                            return plain
                                       ? std::string(1, c)
                                       : fmt::format("\\{:03o}", static_cast<unsigned>(static_cast<unsigned char>(c)));
                        }) +
           '"';
}

std::string cspm_string(const ForeignText& text) {
    return cspm_escaped(text.unescaped(), '"');
}

std::string cspm_character(char c) {
    return cspm_escaped(std::string(1, c), '\'');
}

/// Also escapes "--", which is not allowed in a comment.
std::string xml_text(const ForeignText& text) {
    std::string result = escape_invisible(
        text.unescaped(),
        [](char c) -> std::string {
            switch (c) {
                case '&':
                    return "&amp;";
                case '<':
                    return "&lt;";
                case '>':
                    return "&gt;";
                case '"':
                    return "&quot;";
                case '\'':
                    return "&#39;";
                default:
                    return {c};
            }
        },
        false);
    replace_all(result, "--", "-&#45;");
    return result;
}

std::string xml_lines(const ForeignText& text) {
    std::istringstream lines(text.unescaped());
    std::string result;
    for (std::string line; std::getline(lines, line);) result += (result.empty() ? "" : "\n") + xml_text(line);
    return result;
}

std::string label_text(const ForeignText& text) {
    return escape_invisible(
        text.unescaped(),
        [](char c) {
            return c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
        },
        false);
}

std::string uri_of_path(std::string_view path) {
    std::string out = path.starts_with("/") ? "file://" : "";
    for (const char c : path)
        out += letter_or_digit(c) || std::string_view("-._~/").find(c) != std::string_view::npos
                   ? std::string(1, c)
                   : fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    return out;
}

}  // namespace robochart::diagnostics
