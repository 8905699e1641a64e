// SPDX-License-Identifier: Apache-2.0
// Standard output. Only these functions write it; a write error is an error of the run for every verb.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "app/command/options.hpp"
#include "base/diagnostics/render.hpp"

namespace robochart::app {

/// Standard output cannot be written.
class OutputError : public std::runtime_error {
public:
    /// `cause`: the system's error number.
    explicit OutputError(int cause);
    /// Reports the error on standard error, unless the reader has closed the pipe (`| head`). Returns the exit code.
    [[nodiscard]] Exit report_error() const;

private:
    bool reader_gone_;
};

/// Text for people to standard output. Control and invisible characters, which names of files and texts of models may
/// contain, are shown as escapes (base/diagnostics/escape.hpp), so that none reaches a terminal. These functions throw
/// OutputError.
void print_text(std::string_view text);
/// The same for text that a program may read (JSON, scripts, formatted files, patches): unchanged, unless it goes to a
/// terminal.
void print_exact(std::string_view text);
/// The same for text with our own escape sequences, in which foreign text is escaped already.
void print_styled(std::string_view text);
/// True if standard output is a terminal, so that text for programs is escaped as text for people.
[[nodiscard]] bool output_is_a_terminal();
/// True if standard error is a terminal, so that a person may be watching.
[[nodiscard]] bool error_is_a_terminal();
template <typename... Arguments>
void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    print_text(fmt::format(format, std::forward<Arguments>(arguments)...));
}
/// Text for people to standard error. Write errors are ignored, because they cannot be reported anywhere.
void print_error_text(std::string_view text);
/// The same for text with our own escape sequences and for JSON, in which foreign text is escaped already.
void print_error_styled(std::string_view text);
/// Replaces the last line of standard error, a terminal, by this text without a line end; "" clears the line.
void redraw_error_line(std::string_view text);
template <typename... Arguments>
void print_error(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    print_error_text(fmt::format(format, std::forward<Arguments>(arguments)...));
}
/// Writes buffered output. Throws OutputError. Must be called before the program ends.
void finish_output();
/// Must be called before anything is opened. Occupies descriptors 0 to 2, so that no file becomes a standard stream
/// that the caller closed. Writing to a closed pipe or beyond the file size limit then fails instead of ending the
/// program.
void prepare_output();

/// The columns of a line: the value of COLUMNS, otherwise the terminal's. 0 if neither is known, so that nothing is
/// wrapped.
[[nodiscard]] std::size_t line_width(int descriptor);
/// The text with lines wrapped at this width, at spaces, with continuation lines indented. Colour sequences have no
/// width. 0: unchanged.
[[nodiscard]] std::string wrap_lines(std::string_view text, std::size_t width);
/// The style of findings on standard error.
[[nodiscard]] diagnostics::TextStyle findings_style(const Options&);

/// True if this file descriptor gets colours; by default, if it is a terminal.
[[nodiscard]] bool color_wanted(Color, int descriptor);

}  // namespace robochart::app
