// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/expressions/code_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace robochart::cpp_emit {

namespace {

constexpr std::size_t indent_width = 4;
constexpr std::size_t line_width = 120;

}  // namespace

namespace {

/// Checks text before it is written. Callers have converted names to identifiers and foreign text to literals.
void require_code(std::string_view text) {
    const bool printable = std::ranges::all_of(text, [](char c) { return c >= 0x20 && c < 0x7F; });
    if (!printable)
        throw std::logic_error("a line of generated code holds foreign text: " + diagnostics::escape_for_display(text));
}

}  // namespace

void CodeWriter::line_with_doc(std::string_view text, const diagnostics::ForeignText& behind) {
    require_code(text);
    put_line(fmt::format("{}  ///< {}", text, diagnostics::comment_text(behind)));
}

void CodeWriter::line(std::string_view text) {
    require_code(text);
    put_line(text);
}

void CodeWriter::put_line(std::string_view text) {
    assert(text.find('\n') == std::string_view::npos && depth_ >= outermost_);
    if (!text.empty()) {
        text_.append(depth_ * indent_width, ' ');
        text_ += text;
    }
    text_ += '\n';
    fresh_ = false;
}

void CodeWriter::open(std::string_view text) {
    assert(!text.empty());
    line(text);
    ++depth_;
    fresh_ = true;
}

void CodeWriter::open_declaration(const diagnostics::ForeignText& comment, std::string_view head) {
    gap();
    doc(comment);
    open(head);
}

void CodeWriter::write_if(const CppExpr& condition, const std::function<void()>& body) {
    if (condition.empty()) return body();
    open(fmt::format("if ({}) {{", condition.whole_text()));
    body();
    close();
}

void CodeWriter::close(std::string_view text) {
    assert(depth_ > outermost_);  // the body closes only blocks that it has opened
    if (depth_ > 0) --depth_;
    line(text);
}

void CodeWriter::reopen_block(std::string_view text) {
    close(text);
    ++depth_;
    fresh_ = true;
}

void CodeWriter::write_label(std::string_view text) {
    close(text);
    ++depth_;
    fresh_ = true;
}

void CodeWriter::gap() {
    if (fresh_ || text_.ends_with("\n\n")) return;
    line();
}

void CodeWriter::write_raw(std::string_view lines) {
    assert(lines.empty() || lines.ends_with('\n'));
    text_ += lines;
    fresh_ = false;
}

void CodeWriter::write_wrapped(std::string_view prefix, std::string_view text) {
    const std::size_t width = line_width - depth_ * indent_width - prefix.size();
    while (text.size() > width) {
        const std::size_t blank = text.rfind(' ', width);
        if (blank == std::string_view::npos || blank == 0) break;
        put_line(std::string(prefix) + std::string(text.substr(0, blank)));
        text.remove_prefix(blank + 1);
    }
    put_line(std::string(prefix) + std::string(text));
}

}  // namespace robochart::cpp_emit
