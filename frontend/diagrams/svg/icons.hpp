// SPDX-License-Identifier: Apache-2.0
// Draws the icons of diagrams, which were designed for this project.
#pragma once

#include <string>

#include "frontend/diagrams/notation/picture.hpp"

namespace robochart::diagrams {

/// Returns the contents of an SVG group whose origin is the centre of the icon.
[[nodiscard]] std::string icon_svg(Icon icon);

}  // namespace robochart::diagrams
