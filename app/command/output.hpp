// SPDX-License-Identifier: Apache-2.0
// Writes to standard output. Only these functions do this, so a write error is an error of the run for every verb.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "app/command/options.hpp"
#include "base/diagnostics/render.hpp"

namespace robochart::app {

/// Thrown if standard output cannot be written.
class OutputError : public std::runtime_error {
public:
    /// `cause` is the system's error number.
    explicit OutputError(int cause);
    /// Reports the error on standard error, unless the reader has closed the pipe (`| head`). Returns the exit code.
    [[nodiscard]] Exit report_error() const;

private:
    bool reader_gone_;
};

/// Prints text for people to standard output. Names of files and texts of models may contain control and invisible
/// characters. These characters are printed as escapes (base/diagnostics/escape.hpp), so that none reaches a terminal.
/// All functions for standard output throw OutputError.
void print_text(std::string_view text);
/// Prints text that a program may read (JSON, scripts, formatted files, patches). The text is unchanged, unless
/// standard output is a terminal.
void print_exact(std::string_view text);
/// Prints text with this program's escape sequences to standard output. Foreign text in it must be escaped already.
void print_styled(std::string_view text);
/// True if standard output is a terminal. In this case, text for programs is escaped in the same way as text for
/// people.
[[nodiscard]] bool output_is_a_terminal();
/// True if standard error is a terminal, which a person may be watching.
[[nodiscard]] bool error_is_a_terminal();
template <typename... Arguments>
void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    print_text(fmt::format(format, std::forward<Arguments>(arguments)...));
}
/// Prints text for people to standard error. Write errors are ignored, because they cannot be reported anywhere.
void print_error_text(std::string_view text);
/// Prints JSON, or text with this program's escape sequences, to standard error. Foreign text in it must be escaped
/// already.
void print_error_styled(std::string_view text);
/// Replaces the last line on standard error by this text without a line end; "" clears the line. Standard error must be
/// a terminal.
void redraw_error_line(std::string_view text);
template <typename... Arguments>
void print_error(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    print_error_text(fmt::format(format, std::forward<Arguments>(arguments)...));
}
/// Writes buffered output. It must be called before the program ends. Throws OutputError.
void finish_output();
/// Opens each of the descriptors 0 to 2 that the caller has closed. Otherwise, a file that the program opens later
/// could become a standard stream. Also sets the signals, so that writing to a closed pipe or beyond the file size
/// limit fails and does not end the program. Must be called before any file is opened.
void prepare_output();

/// Returns the number of columns of a line: the value of COLUMNS, otherwise the width of the terminal. Returns 0 if
/// neither is known; text is then not wrapped.
[[nodiscard]] std::size_t line_width(int descriptor);
/// Wraps lines at spaces to this width and indents continuation lines. Colour sequences have the width 0. If `width` is
/// 0, the text is unchanged.
[[nodiscard]] std::string wrap_lines(std::string_view text, std::size_t width);
/// Returns the style of findings on standard error.
[[nodiscard]] diagnostics::TextStyle findings_style(const Options&);

/// True if text for this file descriptor is coloured. By default, it is coloured if the descriptor is a terminal.
[[nodiscard]] bool color_wanted(Color, int descriptor);

}  // namespace robochart::app
