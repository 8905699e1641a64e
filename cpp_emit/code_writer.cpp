#include "cpp_emit/code_writer.hpp"

namespace robochart::cpp_emit {

namespace {

constexpr std::size_t indent_width = 4;
constexpr std::size_t line_width = 120;

}  // namespace

void CodeWriter::line(std::string_view text) {
    if (!text.empty()) {
        text_.append(depth_ * indent_width, ' ');
        text_ += text;
    }
    text_ += '\n';
    fresh_ = false;
}

void CodeWriter::open(std::string_view text) {
    line(text);
    ++depth_;
    fresh_ = true;
}

void CodeWriter::close(std::string_view text) {
    if (depth_ > 0) --depth_;
    line(text);
}

void CodeWriter::reopen(std::string_view text) {
    close(text);
    ++depth_;
    fresh_ = true;
}

void CodeWriter::label(std::string_view text) {
    close(text);
    ++depth_;
    fresh_ = true;
}

void CodeWriter::gap() {
    if (fresh_ || text_.ends_with("\n\n")) return;
    line();
}

void CodeWriter::raw(std::string_view lines) {
    text_ += lines;
    fresh_ = false;
}

void CodeWriter::wrapped(std::string_view prefix, std::string_view text) {
    const std::size_t width = line_width - depth_ * indent_width - prefix.size();
    while (text.size() > width) {
        const std::size_t blank = text.rfind(' ', width);
        if (blank == std::string_view::npos || blank == 0) break;
        line(std::string(prefix) + std::string(text.substr(0, blank)));
        text.remove_prefix(blank + 1);
    }
    line(std::string(prefix) + std::string(text));
}

}  // namespace robochart::cpp_emit
