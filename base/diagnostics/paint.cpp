// SPDX-License-Identifier: Apache-2.0
#include "base/diagnostics/paint.hpp"

#include <fmt/color.h>

namespace robochart::diagnostics {

namespace {

fmt::text_style style_of(Paint paint) {
    const auto bold = [](fmt::terminal_color color) { return fmt::emphasis::bold | fmt::fg(color); };
    switch (paint) {
        case Paint::heading:
            return fmt::emphasis::bold;
        case Paint::name:
            return fmt::fg(fmt::terminal_color::cyan);
        case Paint::note:
            return bold(fmt::terminal_color::cyan);
        case Paint::warning:
            return bold(fmt::terminal_color::yellow);
        case Paint::error:
            return bold(fmt::terminal_color::red);
        case Paint::addition:
        case Paint::success:
            return bold(fmt::terminal_color::green);
    }
    return {};
}

}  // namespace

std::string paint_text(std::string_view text, Paint paint, bool color) {
    return color ? fmt::format(style_of(paint), "{}", text) : std::string(text);
}

}  // namespace robochart::diagnostics
