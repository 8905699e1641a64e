// SPDX-License-Identifier: Apache-2.0
// See icons.hpp.
#include "frontend/diagrams/svg/icons.hpp"

#include <fmt/format.h>

namespace robochart::diagrams {
namespace {

std::string letter_sign(std::string_view text, double size, std::string_view style = "bold") {
    const std::string_view weight = style == "bold" ? "font-weight=\"bold\"" : "font-style=\"italic\"";
    return fmt::format(R"(<text class="sign" y="{:.1f}" font-size="{}" text-anchor="middle" {}>{}</text>)", size * 0.36,
                       size, weight, text);
}

std::string in_circle(std::string_view text, double line) {
    return fmt::format(R"(<circle class="thin" r="6" stroke-width="{}"/>)", line) + letter_sign(text, 9);
}

}  // namespace

std::string icon_svg(Icon icon) {
    switch (icon) {
        case Icon::no_icon:
            return "";
        case Icon::module:  // a cube
            return R"(<path class="thin" d="M-5 -3L0 -6L5 -3V3L0 6L-5 3ZM-5 -3L0 0L5 -3M0 0V6"/>)";
        case Icon::platform:  // a robot's head
            return R"(<path class="thin" d="M-5 -2H5V5H-5ZM0 -2V-6M-7 0V3M7 0V3M-2.5 3H2.5"/>)"
                   R"(<circle class="dot" cx="-2.2" cy="0.6" r="1"/><circle class="dot" cx="2.2" cy="0.6" r="1"/>)";
        case Icon::controller:  // three joined dots
            return R"(<path class="thin" d="M-4 3L0 -4L4 3Z"/><circle class="dot" cx="-4" cy="3" r="2"/>)"
                   R"(<circle class="dot" cx="0" cy="-4" r="2"/><circle class="dot" cx="4" cy="3" r="2"/>)";
        case Icon::machine:  // two states and a transition
            return R"(<path class="thin" d="M-6 -5H0V-1H-6ZM0 1.5H6V5.5H0ZM0 -3H3.5V1.5M2 -0.5L3.5 1.5L5 -0.5"/>)";
        case Icon::operation:
            return letter_sign("O", 13);
        case Icon::enumeration:
            return letter_sign("E", 13);
        case Icon::record:  // a table
            return R"(<path class="thin" d="M-5 -5H5V5H-5ZM-5 -1.5H5M-5 1.8H5M-1 -1.5V5"/>)";
        case Icon::function:
            return letter_sign("fx", 12, "italic");
        case Icon::event:  // a flash
            return R"(<path class="dot" d="M2 -6L-4 1H-0.5L-2 6L4 -1.5H0.5Z"/>)";
        case Icon::constant:
            return letter_sign("\xCF\x80", 13);
        case Icon::variable:
            return letter_sign("X", 11);
        case Icon::clock:
            return R"(<circle class="thin" r="5.5"/><path class="thin" d="M0 -3.5V0H2.8"/>)";
        case Icon::provides:
            return R"(<path class="thin" d="M-6 -6H6V6H-6Z"/>)" + letter_sign("P", 9);
        case Icon::requires_:
            return in_circle("R", 2);
        case Icon::uses:
            return in_circle("i", 1);
        case Icon::precondition:
            return letter_sign("pre", 8, "italic");
        case Icon::postcondition:
            return letter_sign("post", 8, "italic");
    }
    return "";
}

}  // namespace robochart::diagrams
