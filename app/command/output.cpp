// SPDX-License-Identifier: Apache-2.0
#include "app/command/output.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/utf8.hpp"

namespace robochart::app {

OutputError::OutputError(int cause)
    : std::runtime_error(fmt::format("cannot write to standard output: {}", std::strerror(cause != 0 ? cause : EIO))),
      reader_gone_(cause == EPIPE) {}

Exit OutputError::report_error() const {
    if (!reader_gone_) print_error("robochart-verify: {}\n", what());
    return Exit::bad_input;
}

void print_text(std::string_view text) {
    print_styled(diagnostics::shown_lines(text));
}

bool output_is_a_terminal() {
    return isatty(STDOUT_FILENO) == 1;
}

bool error_is_a_terminal() {
    return isatty(STDERR_FILENO) == 1;
}

void print_exact(std::string_view text) {
    if (output_is_a_terminal())
        print_text(text);
    else
        print_styled(text);
}

void print_styled(std::string_view text) {
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) throw OutputError(errno);
}

void print_error_text(std::string_view text) {
    print_error_styled(diagnostics::shown_lines(text));
}

void print_error_styled(std::string_view text) {
    (void)!std::fwrite(text.data(), 1, text.size(), stderr);
}

void redraw_error_line(std::string_view text) {
    constexpr std::string_view erase = "\r\x1b[K";  // ECMA-48, 8.3.41: erases to the end of the line
    print_error_styled(fmt::format("{}{}", erase, text));
    (void)std::fflush(stderr);
}

void finish_output() {
    errno = 0;
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw OutputError(errno != 0 ? errno : EIO);
}

void prepare_output() {
    // Opens the descriptor in the wrong mode, so that reading or writing fails as with a closed descriptor.
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(descriptor, F_GETFD) < 0 && errno == EBADF)
            (void)!open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    (void)::signal(SIGPIPE, SIG_IGN);
    (void)::signal(SIGXFSZ, SIG_IGN);
}

std::size_t line_width(int descriptor) {
    constexpr std::size_t least = 20, most = 100'000;
    if (const char* const columns = std::getenv("COLUMNS")) {
        const std::string_view digits = columns;
        std::size_t width = 0;
        const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), width);
        if (code == std::errc() && end == digits.data() + digits.size() && width > 0 && width <= most)
            return std::max(least, width);
    }
    winsize size{};
    if (ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 0;
    return std::max<std::size_t>(least, size.ws_col);
}

namespace {

/// A line without its line end, with widths in columns.
class WideLine {
public:
    WideLine(std::string_view text, std::size_t width) : text_(text), width_(width) {
        const std::size_t indent = std::min(text.find_first_not_of(' '), text.size());
        further_ = std::min(indent + 2, width / 2);
    }

    std::string break_line() {
        std::string out;
        std::size_t begin = 0;
        for (std::size_t columns_left = width_; begin < text_.size(); columns_left = width_ - further_) {
            const std::size_t end = break_after(begin, columns_left);
            out +=
                (begin == 0 ? "" : "\n" + std::string(further_, ' ')) + std::string(text_.substr(begin, end - begin));
            begin = std::min(text_.find_first_not_of(' ', end), text_.size());
        }
        return out;
    }

private:
    /// Returns the end of the piece that starts at `begin`. It is before the last space within the columns, or after
    /// the first word if this word is wider than the columns.
    [[nodiscard]] std::size_t break_after(std::size_t begin, std::size_t columns_left) const {
        std::size_t columns = 0, space = std::string_view::npos;
        bool words = false;
        for (std::size_t i = begin; i < text_.size(); ++i) {
            if (text_[i] == '\x1b') {
                i = std::min(text_.find('m', i), text_.size());
                continue;
            }
            if (diagnostics::is_continuation(text_[i])) continue;
            if (text_[i] == ' ' && words) {
                if (columns > columns_left) return space == std::string_view::npos ? i : space;
                space = i;
            }
            words = words || text_[i] != ' ';
            ++columns;
        }
        return columns <= columns_left || space == std::string_view::npos ? text_.size() : space;
    }

    std::string_view text_;
    std::size_t width_;
    std::size_t further_ = 0;
};

}  // namespace

std::string wrap_lines(std::string_view text, std::size_t width) {
    if (width == 0) return std::string(text);
    std::string out;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        out += WideLine(text.substr(0, end), width).break_line();
        if (end == std::string_view::npos) break;
        out += '\n';
        text.remove_prefix(end + 1);
    }
    return out;
}

diagnostics::TextStyle findings_style(const Options& options) {
    diagnostics::TextStyle style;
    style.color = color_wanted(options.output.color, STDERR_FILENO);
    constexpr std::size_t margin = 14;  // width of the line number and of the marks at the ends of a cut line
    if (const std::size_t width = line_width(STDERR_FILENO); width > 0)
        style.max_width = std::max(margin, width - std::min(width, margin));
    return style;
}

bool color_wanted(Color color, int descriptor) {
    if (color != Color::automatic) return color == Color::always;
    const char* refused = std::getenv("NO_COLOR");  // no-color.org: applies if set and not empty
    return isatty(descriptor) == 1 && (refused == nullptr || *refused == '\0');
}

}  // namespace robochart::app
