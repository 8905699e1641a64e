// Standard output, written by one writer: what cannot be written is an error of the run, whatever the verb.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "app/command/options.hpp"
#include "diagnostics/render.hpp"

namespace robochart::app {

/// Standard output cannot be written.
class OutputError : public std::runtime_error {
public:
    /// With the number of the system's error.
    explicit OutputError(int cause);
    /// Says so on standard error, but not where the reader has gone (`| head`): that is no news to anybody. Returns
    /// the exit code.
    [[nodiscard]] Exit report() const;

private:
    bool reader_gone_;
};

/// Text for people to standard output: control and invisible characters, which names of files and text of models may
/// hold, are shown (diagnostics/escape.hpp), so that none reaches a terminal. Throws OutputError, as the others do.
void print_text(std::string_view text);
/// The same for what a program may read (JSON, scripts, formatted files, patches): as it is, unless it goes to a
/// terminal.
void print_exact(std::string_view text);
/// The same for text with escape sequences of our own, in which what others wrote is shown already.
void print_styled(std::string_view text);
/// Standard output is a terminal, so that what programs read is made for people.
[[nodiscard]] bool output_is_a_terminal();
/// Standard error is a terminal, so that somebody may be looking on.
[[nodiscard]] bool error_is_a_terminal();
template <typename... Arguments>
void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    print_text(fmt::format(format, std::forward<Arguments>(arguments)...));
}
/// Text for people to standard error. That it cannot be written changes nothing: there is no place left to say so.
void print_error_text(std::string_view text);
/// The same for text with escape sequences of our own, and for JSON, in which what others wrote is escaped already.
void print_error_styled(std::string_view text);
/// Writes the last line of standard error, a terminal, anew: the text without a line end, or nothing.
void redraw_error_line(std::string_view text);
template <typename... Arguments>
void print_error(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    print_error_text(fmt::format(format, std::forward<Arguments>(arguments)...));
}
/// Hands over what is buffered. Throws OutputError. To be called before the program ends.
void finish_output();
/// Before anything is opened: descriptors 0 to 2 are taken, so that no file of ours becomes the standard output that
/// somebody closed; and writing to a reader that has gone, or beyond the largest file allowed, fails instead of ending
/// the program.
void prepare_output();

/// Columns of a line there: those of COLUMNS, else the terminal's; 0 where there is neither, so that nothing is cut.
[[nodiscard]] std::size_t line_width(int descriptor);
/// The text with lines that are wider than that continued below, after a space, further to the right. Sequences of
/// colours take no columns. 0: as it is.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width);
/// How findings are drawn on standard error.
[[nodiscard]] diagnostics::TextStyle findings_style(const Options&);

/// Are colours wanted on this file descriptor? By default if it is a terminal.
[[nodiscard]] bool color_wanted(Color, int descriptor);

}  // namespace robochart::app
