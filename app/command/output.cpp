#include "app/command/output.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>
#include <cstdlib>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "diagnostics/escape.hpp"

namespace robochart::app {

OutputError::OutputError(int cause)
    : std::runtime_error(fmt::format("cannot write to standard output: {}", std::strerror(cause != 0 ? cause : EIO))),
      reader_gone_(cause == EPIPE) {}

Exit OutputError::report() const {
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
    constexpr std::string_view erase = "\r\x1b[K";  // ECMA-48, 8.3.41: to the end of the line
    print_error_styled(fmt::format("{}{}", erase, text));
    (void)std::fflush(stderr);
}

void finish_output() {
    errno = 0;
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw OutputError(errno != 0 ? errno : EIO);
}

void prepare_output() {
    // The wrong way round, so that reading and writing them fail as they would on what is closed.
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(descriptor, F_GETFD) < 0 && errno == EBADF)
            (void)!open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    (void)::signal(SIGPIPE, SIG_IGN);
    (void)::signal(SIGXFSZ, SIG_IGN);
}

bool color_wanted(Color color, int descriptor) {
    if (color != Color::automatic) return color == Color::always;
    const char* refused = std::getenv("NO_COLOR");  // no-color.org: set and not empty
    return isatty(descriptor) == 1 && (refused == nullptr || *refused == '\0');
}

}  // namespace robochart::app
